//! What an encoded number means.
use reliefrtl_base::format::FloatFormat;

/// What an encoded number means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    /// Not a number, whatever its sign and payload.
    Nan,
    /// An infinity of the given sign (`true` is negative).
    Infinite(bool),
    /// A zero of the given sign; where they are flushed, subnormals read as this.
    Zero(bool),
    /// An ordinary number.
    Finite(Finite),
}

/// The number `(-1)^negative * sig * 2^exp`; `sig` has `man + 1` bits and its top bit is 1, a subnormal's too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Finite {
    /// Sign.
    pub negative: bool,
    /// Integer significand, hidden bit included.
    pub sig: u128,
    /// Exponent of the significand's last bit.
    pub exp: i32,
}

/// Reads an encoded number; bits above the format's width are ignored.
pub fn decode(fmt: FloatFormat, a: u64) -> Value {
    let negative = a & fmt.sign_bit() != 0;
    let field = (a >> fmt.man) & fmt.exp_max();
    let fraction = a & fmt.man_mask();
    let last = |field: u64| field as i32 - fmt.bias() - fmt.man as i32;
    if field == fmt.exp_max() && !fmt.is_finite() {
        if fraction == 0 { Value::Infinite(negative) } else { Value::Nan }
    } else if field != 0 {
        let sig = u128::from(fraction | (1 << fmt.man));
        Value::Finite(Finite { negative, sig, exp: last(field) })
    } else if fraction == 0 || !fmt.is_gradual() {
        Value::Zero(negative)
    } else {
        let up = fmt.man + 1 - (u64::BITS - fraction.leading_zeros());
        Value::Finite(Finite { negative, sig: u128::from(fraction) << up, exp: last(1) - up as i32 })
    }
}

/// Infinity of a sign, encoded; the largest number where there is none.
pub(super) fn infinity(fmt: FloatFormat, negative: bool) -> u64 {
    zero(fmt, negative) | if fmt.is_finite() { fmt.largest() } else { fmt.infinity() }
}

/// What an operation without a result gives: NaN, or a zero of this sign where there is none.
pub(super) fn invalid(fmt: FloatFormat, negative: bool) -> u64 {
    if fmt.is_finite() { zero(fmt, negative) } else { fmt.nan() }
}

/// Zero of a sign, encoded.
pub(super) fn zero(fmt: FloatFormat, negative: bool) -> u64 {
    if negative { fmt.sign_bit() } else { 0 }
}
