//! Conversions from and to integers, fixed point and f64.
use super::arith::ratio;
use super::rounding::round;
use super::value::{Value, decode, infinity, invalid, zero};
use reliefrtl_base::format::FloatFormat;

/// `v * 2^-frac`, rounded once; 0 gives +0.
pub fn from_fixed(fmt: FloatFormat, v: i64, frac: u32) -> u64 {
    if v == 0 { 0 } else { round(fmt, v < 0, u128::from(v.unsigned_abs()), -(frac as i32), false) }
}

/// The integer `v`, rounded once.
pub fn from_int(fmt: FloatFormat, v: i64) -> u64 {
    from_fixed(fmt, v, 0)
}

/// `floor(a * 2^frac)`, saturated to a signed integer of `int_w` bits (2 to 64) in all; NaN gives 0.
pub fn to_fixed(fmt: FloatFormat, a: u64, int_w: u32, frac: u32) -> i64 {
    let max = i64::MAX >> (64 - int_w);
    let min = i64::MIN >> (64 - int_w);
    match decode(fmt, a) {
        Value::Nan | Value::Zero(_) => 0,
        Value::Infinite(negative) => {
            if negative {
                min
            } else {
                max
            }
        }
        Value::Finite(x) => {
            let sig = if x.negative { -(x.sig as i128) } else { x.sig as i128 };
            // 64 places up is outside of every range already; 127 places down leaves the floor of a tiny number.
            let floor = match x.exp + frac as i32 {
                up @ 0.. => sig << up.min(64),
                down => sig >> (-down).min(127),
            };
            floor.clamp(i128::from(min), i128::from(max)) as i64
        }
    }
}

/// `floor(a)`, saturated to a signed integer of `int_w` bits; NaN gives 0.
pub fn to_int(fmt: FloatFormat, a: u64, int_w: u32) -> i64 {
    to_fixed(fmt, a, int_w, 0)
}

/// `x` rounded once; every NaN becomes the canonical one (where there is none, +0).
pub fn from_f64(fmt: FloatFormat, x: f64) -> u64 {
    let negative = x.is_sign_negative();
    let bits = x.to_bits();
    let field = ((bits >> 52) & 0x7ff) as i32;
    let fraction = u128::from(bits & ((1 << 52) - 1));
    match (field, fraction) {
        (0x7ff, 0) => infinity(fmt, negative),
        (0x7ff, _) => invalid(fmt, false),
        (0, 0) => zero(fmt, negative),
        // The f64's own subnormals are real numbers here.
        (0, _) => round(fmt, negative, fraction, -1074, false),
        _ => round(fmt, negative, fraction | (1 << 52), field - 1075, false),
    }
}

/// The exact value, for every format of at most 11 exponent and 52 fraction bits.
pub fn to_f64(fmt: FloatFormat, a: u64) -> f64 {
    let sign = |negative: bool| if negative { -1.0 } else { 1.0 };
    match decode(fmt, a) {
        Value::Nan => f64::NAN,
        Value::Infinite(s) => f64::INFINITY * sign(s),
        Value::Zero(s) => 0.0 * sign(s),
        Value::Finite(x) => {
            // Of at most 53 bits, and no lower than the last place of an f64: both factors and the product are exact.
            let (half, rest) = (x.exp / 2, x.exp - x.exp / 2);
            x.sig as f64 * 2f64.powi(half) * 2f64.powi(rest) * sign(x.negative)
        }
    }
}

/// `1 / m`, rounded once.
///
/// # Panics
/// If `m` is 0.
pub fn recip_int(fmt: FloatFormat, m: u64) -> u64 {
    ratio(fmt, false, 1, u128::from(m), 0)
}

/// 2^`e`, encoded.
pub fn power_of_two(fmt: FloatFormat, e: i32) -> u64 {
    from_f64(fmt, 2f64.powi(e))
}
