//! Sum, product, quotient, comparison.
use super::rounding::round;
use super::value::{Finite, Value, decode, infinity, invalid, zero};
use reliefrtl_base::format::{FloatFormat, Rounding};

/// Exponents further apart than this leave the smaller operand of a sum no influence but its sign:
/// a significand has at most 53 bits, so the smaller operand is below 2^-10 units in the last place of the larger.
const FAR: i32 = 64;

/// `a + b`, rounded once. Encoded operands and result; `x - x` is +0 (-0 when rounding down), `inf - inf` is NaN.
pub fn add(fmt: FloatFormat, a: u64, b: u64) -> u64 {
    match (decode(fmt, a), decode(fmt, b)) {
        (Value::Nan, _) | (_, Value::Nan) => fmt.nan(),
        (Value::Infinite(s), Value::Infinite(t)) if s != t => fmt.nan(),
        (Value::Infinite(s), _) | (_, Value::Infinite(s)) => infinity(fmt, s),
        (Value::Zero(s), Value::Zero(t)) => zero_sum(fmt, &[s, t]),
        (Value::Zero(_), Value::Finite(x)) | (Value::Finite(x), Value::Zero(_)) => {
            round(fmt, x.negative, x.sig, x.exp, false)
        }
        (Value::Finite(x), Value::Finite(y)) => add_finite(fmt, x, y),
    }
}

/// Both operands become integers in units of the smaller exponent, and the sum is exact.
fn add_finite(fmt: FloatFormat, x: Finite, y: Finite) -> u64 {
    let (large, small) = if x.exp >= y.exp { (x, y) } else { (y, x) };
    // Any other nonzero value as small as this rounds alike, so take one that keeps the integers short.
    let small = if large.exp - small.exp > FAR { Finite { sig: 1, exp: large.exp - FAR, ..small } } else { small };
    let sum = (signed(large) << (large.exp - small.exp)) + signed(small);
    if sum == 0 { zero_sum(fmt, &[true, false]) } else { round(fmt, sum < 0, sum.unsigned_abs(), small.exp, false) }
}

/// The zero that terms of these signs sum up to: theirs if they agree, else +0, or -0 when rounding down.
pub(super) fn zero_sum(fmt: FloatFormat, signs: &[bool]) -> u64 {
    let agree = signs.iter().all(|s| *s == signs[0]);
    zero(fmt, if agree { signs[0] } else { fmt.rounding == Rounding::Down })
}

/// The significand with its sign; at most 53 bits and the sign.
pub(super) fn signed(x: Finite) -> i128 {
    if x.negative { -(x.sig as i128) } else { x.sig as i128 }
}

/// `a * b`, rounded once. Encoded operands and result; `0 * inf` is NaN.
pub fn mul(fmt: FloatFormat, a: u64, b: u64) -> u64 {
    match (decode(fmt, a), decode(fmt, b)) {
        (Value::Nan, _) | (_, Value::Nan) => fmt.nan(),
        (Value::Infinite(_), Value::Zero(_)) | (Value::Zero(_), Value::Infinite(_)) => fmt.nan(),
        (Value::Infinite(s), Value::Infinite(t)) => infinity(fmt, s != t),
        (Value::Infinite(s), Value::Finite(x)) | (Value::Finite(x), Value::Infinite(s)) => {
            infinity(fmt, s != x.negative)
        }
        (Value::Zero(s), Value::Zero(t)) => zero(fmt, s != t),
        (Value::Zero(s), Value::Finite(x)) | (Value::Finite(x), Value::Zero(s)) => zero(fmt, s != x.negative),
        (Value::Finite(x), Value::Finite(y)) => {
            round(fmt, x.negative != y.negative, x.sig * y.sig, x.exp + y.exp, false)
        }
    }
}

/// `a / b`, rounded once. Encoded operands and result; `0 / 0` and `inf / inf` are NaN, `x / 0` is infinity. Where every
/// code is a number, `0 / 0` is 0 and `x / 0` the largest one, both with the sign of a quotient.
pub fn div(fmt: FloatFormat, a: u64, b: u64) -> u64 {
    match (decode(fmt, a), decode(fmt, b)) {
        (Value::Nan, _) | (_, Value::Nan) => fmt.nan(),
        (Value::Infinite(_), Value::Infinite(_)) => fmt.nan(),
        (Value::Zero(s), Value::Zero(t)) => invalid(fmt, s != t),
        (Value::Infinite(s), Value::Zero(t)) => infinity(fmt, s != t),
        (Value::Infinite(s), Value::Finite(y)) => infinity(fmt, s != y.negative),
        (Value::Finite(x), Value::Zero(t)) => infinity(fmt, x.negative != t),
        (Value::Zero(s), Value::Infinite(t)) => zero(fmt, s != t),
        (Value::Zero(s), Value::Finite(y)) => zero(fmt, s != y.negative),
        (Value::Finite(x), Value::Infinite(t)) => zero(fmt, x.negative != t),
        (Value::Finite(x), Value::Finite(y)) => ratio(fmt, x.negative != y.negative, x.sig, y.sig, x.exp - y.exp),
    }
}

/// `(-1)^negative * num / den * 2^exp`, rounded once, by integer quotient and remainder.
///
/// `num` and `den` are nonzero and below 2^64.
pub(super) fn ratio(fmt: FloatFormat, negative: bool, num: u128, den: u128, exp: i32) -> u64 {
    // With num brought to the top, the quotient keeps at least 63 bits, and no format keeps more than 53.
    let shift = num.leading_zeros();
    let num = num << shift;
    round(fmt, negative, num / den, exp - shift as i32, !num.is_multiple_of(den))
}

/// `a < b`. False when either is NaN; the two zeros are equal, and so are subnormals where they are flushed.
pub fn lt(fmt: FloatFormat, a: u64, b: u64) -> bool {
    match (order(fmt, a), order(fmt, b)) {
        (Some(x), Some(y)) => x < y,
        _ => false,
    }
}

/// An integer that stands in the same order as the number: exponent and fraction read as one, with the sign. None for NaN.
pub(super) fn order(fmt: FloatFormat, a: u64) -> Option<i64> {
    let magnitude = a & (fmt.sign_bit() - 1);
    if magnitude > fmt.infinity() && !fmt.is_finite() {
        None
    } else if magnitude == 0 || (magnitude <= fmt.man_mask() && !fmt.is_gradual()) {
        Some(0)
    } else {
        Some(if a & fmt.sign_bit() != 0 { -(magnitude as i64) } else { magnitude as i64 })
    }
}

/// `-a`: the sign bit flipped, for every operand. The sign of a NaN means nothing to the other operations.
pub fn neg(fmt: FloatFormat, a: u64) -> u64 {
    a ^ fmt.sign_bit()
}
