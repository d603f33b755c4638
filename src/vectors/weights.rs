//! Random words, weighted toward what units decide about: equal and neighbouring operands, cancellation, ties, ends of the range.
use super::kind::Kind;
use crate::bits::mask;
use crate::format::FloatFormat;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// A word for a column that has no partner yet.
pub fn word(kind: Kind, rng: &mut ChaCha8Rng) -> u64 {
    match kind {
        Kind::Float(f) => number(f, rng),
        Kind::Integer(w) => integer(w, rng),
    }
}

/// A word for a column after one of the same kind that holds `a`.
pub fn partner(kind: Kind, a: u64, rng: &mut ChaCha8Rng) -> u64 {
    match kind {
        Kind::Float(f) => near(f, a, rng),
        Kind::Integer(w) => match rng.random_range(0..4) {
            0 => a.wrapping_add(rng.random_range(0..7)).wrapping_sub(3) & mask(w),
            1 => (a ^ (1 << rng.random_range(0..w))) & mask(w),
            _ => integer(w, rng),
        },
    }
}

/// Any word half of the time, else one whose magnitude has a random length.
fn integer(w: u32, rng: &mut ChaCha8Rng) -> u64 {
    let any = rng.random::<u64>() & mask(w);
    let short = any >> rng.random_range(0..w);
    match rng.random_range(0..4) {
        0 => short,
        1 => !short & mask(w),
        _ => any,
    }
}

/// Any bits, or a number not far from 1, or one whose fraction is short (sums and products of such give ties).
fn number(f: FloatFormat, rng: &mut ChaCha8Rng) -> u64 {
    let any = rng.random::<u64>() & mask(f.width());
    let span = i64::from(f.man) + 3;
    let e = (i64::from(f.bias()) + rng.random_range(-span..=span)).clamp(1, f.exp_max() as i64 - 1) as u64;
    let plain = (any & !(f.exp_max() << f.man)) | (e << f.man);
    match rng.random_range(0..4) {
        0 => any,
        1 => plain & !mask(rng.random_range(0..=f.man)),
        _ => plain,
    }
}

/// A partner for `a`.
fn near(f: FloatFormat, a: u64, rng: &mut ChaCha8Rng) -> u64 {
    let (man, bias, top) = (i64::from(f.man), i64::from(f.bias()), f.exp_max() as i64);
    let e = ((a >> f.man) & f.exp_max()) as i64;
    let sign = if rng.random::<bool>() { f.sign_bit() } else { 0 };
    let with = |e: i64, m: u64| sign | ((e.clamp(0, top) as u64) << f.man) | (m & f.man_mask());
    let short = |rng: &mut ChaCha8Rng| rng.random::<u64>() & !mask(rng.random_range(0..=f.man));
    match rng.random_range(0..9) {
        // Close in exponent.
        0 => with(e + rng.random_range(-2..=2), rng.random()),
        // The same or almost, of either sign: cancellation.
        1 => (a ^ sign).wrapping_add(rng.random_range(0..3)).wrapping_sub(1) & mask(f.width()),
        // A short fraction far below: a tie of the sum, or just beside one.
        2 => with(e - rng.random_range(0..=man + 3), short(rng)),
        3 => with(e + rng.random_range(-3..=3), 1 << rng.random_range(0..f.man)),
        // The product of the exponents stands at an end of the range.
        4 => with(bias + if rng.random::<bool>() { 1 } else { top } - e + rng.random_range(-2..=1), short(rng)),
        // Their quotient does.
        5 => with(e + bias - if rng.random::<bool>() { 1 } else { top } + rng.random_range(-1..=2), rng.random()),
        6 => with(rng.random_range(0..=top), short(rng)),
        // The product stands at a power of two: rounding carries, or just does not.
        7 => {
            let sig = u128::from((a & f.man_mask()) | (1 << f.man));
            with(bias + rng.random_range(-3..=3), ((1u128 << (2 * f.man + 1)) / sig) as u64 + rng.random_range(0..2))
        }
        _ => number(f, rng),
    }
}
