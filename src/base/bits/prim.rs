//! The primitives whose Verilog is a loop over a parameter.
use super::mask;

/// Leading zeros of the low `w` bits; `w` for zero.
#[inline(always)]
pub const fn lzc(a: u64, w: u32) -> u64 {
    (a.leading_zeros() + w - 64) as u64
}

/// Morton order: bit `b` of `a` to bit `2b`, bit `b` of `b` to bit `2b + 1` (operands of at most 32 bits).
#[inline(always)]
pub const fn interleave(a: u64, b: u64) -> u64 {
    spread(a) | (spread(b) << 1)
}

/// The inverse of [`interleave`].
pub const fn deinterleave(m: u64) -> (u64, u64) {
    (gather(m), gather(m >> 1))
}

#[inline(always)]
const fn spread(a: u64) -> u64 {
    let a = (a | (a << 16)) & 0x0000_ffff_0000_ffff;
    let a = (a | (a << 8)) & 0x00ff_00ff_00ff_00ff;
    let a = (a | (a << 4)) & 0x0f0f_0f0f_0f0f_0f0f;
    let a = (a | (a << 2)) & 0x3333_3333_3333_3333;
    (a | (a << 1)) & 0x5555_5555_5555_5555
}

const fn gather(a: u64) -> u64 {
    let a = a & 0x5555_5555_5555_5555;
    let a = (a | (a >> 1)) & 0x3333_3333_3333_3333;
    let a = (a | (a >> 2)) & 0x0f0f_0f0f_0f0f_0f0f;
    let a = (a | (a >> 4)) & 0x00ff_00ff_00ff_00ff;
    let a = (a | (a >> 8)) & 0x0000_ffff_0000_ffff;
    (a | (a >> 16)) & 0x0000_0000_ffff_ffff
}

/// `rows` rows of restoring division: each compares, subtracts, and doubles the remainder.
///
/// `rem` has `w + 1` bits and must be below `2 * div`; `div` has `w` bits. Returns the remainder (`w + 1` bits)
/// and the quotient digits, first digit on top (`rows` bits).
#[inline(always)]
pub fn div_rows(mut rem: u64, div: u64, w: u32, rows: u32) -> (u64, u64) {
    let mut quot = 0;
    for _ in 0..rows {
        let ge = rem >= div;
        rem = (if ge { rem.wrapping_sub(div) } else { rem } << 1) & mask(w + 1);
        quot = (quot << 1) | u64::from(ge);
    }
    (rem, quot)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lzc_at_every_width() {
        for w in 1..=64 {
            assert_eq!(lzc(0, w), u64::from(w));
            for top in 0..w {
                assert_eq!(lzc(1 << top, w), u64::from(w - 1 - top));
                assert_eq!(lzc(mask(top + 1), w), u64::from(w - 1 - top));
            }
        }
    }

    #[test]
    fn interleave_and_back() {
        for a in [0, 1, 2, 0x55, 0xff, 0xdead_beef, 0xffff_ffff] {
            for b in [0, 1, 3, 0xaa, 0x1234_5678, 0xffff_ffff] {
                assert_eq!(deinterleave(interleave(a, b)), (a, b));
            }
        }
        assert_eq!(interleave(0b11, 0b00), 0b0101);
        assert_eq!(interleave(0b00, 0b11), 0b1010);
    }

    #[test]
    fn division_rows_divide() {
        for w in 2..=20u32 {
            for (n, d) in [(1u64 << (w - 1), (1 << (w - 1)) + 1), (mask(w), 1 << (w - 1)), (mask(w), mask(w))] {
                let rows = w + 2;
                let (_, q) = div_rows(n, d, w, rows);
                assert_eq!(q, (n << (rows - 1)) / d, "w {w}");
            }
        }
    }
}
