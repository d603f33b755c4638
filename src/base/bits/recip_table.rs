//! The words of `recip_table`: a line under the reciprocal in each of 256 intervals (`docs/arithmetic.md`, Division by a table).

/// Bits of the index: those below a significand's leading one.
pub const INDEX_W: u32 = 8;
/// Bits of a line's start and slope; a word holds both, the start on top.
pub const START_W: u32 = 21;
/// As [`START_W`].
pub const SLOPE_W: u32 = 12;

/// The line for divisors from `(256 + index) / 256` up: its start less one half in units of 2^-22, and how much it falls at each
/// 2^-16 in units of 2^-28.
#[inline(always)]
pub const fn recip_table(index: u64) -> u64 {
    WORDS[(index & 0xff) as usize]
}

const WORDS: [u64; 256] = {
    let mut words = [0; 256];
    let mut i = 0;
    while i < words.len() {
        words[i] = word(i as u64);
        i += 1;
    }
    words
};

const fn word(index: u64) -> u64 {
    let (x, y) = (256 + index, 257 + index);
    // The chord's slope, rounded.
    let slope = ((1 << 28) + x * y / 2) / (x * y);
    // In the middle, the line passes half-way between chord and curve. 4 more: half a unit of the sum's last place,
    // so that cutting it off rounds.
    let sum = (1 << 28) * ((x + y) * (x + y) + 4 * x * y) / (x * y * (x + y));
    (sum + 2 * slope + 4 - (1 << START_W)) << SLOPE_W | slope
}
