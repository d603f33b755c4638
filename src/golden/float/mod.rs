//! The arithmetic of `docs/datapath.md`: numbers are taken apart into exact integers, and put together by one rounding.
mod arith;
mod convert;

pub use arith::{add, div, lt, mul, neg};
pub use convert::{from_f64, from_fixed, from_int, recip_int, to_f64, to_fixed, to_int};

use crate::format::FloatFormat;

/// What an encoded number means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    /// Not a number, whatever its sign and payload.
    Nan,
    /// An infinity of the given sign (`true` is negative).
    Infinite(bool),
    /// A zero of the given sign; subnormals read as this.
    Zero(bool),
    /// An ordinary number.
    Finite(Finite),
}

/// The number `(-1)^negative * sig * 2^exp`; `sig` has `man + 1` bits and its top bit is 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Finite {
    /// Sign.
    pub negative: bool,
    /// Integer significand, hidden bit included.
    pub sig: u128,
    /// Exponent of the significand's last bit.
    pub exp: i32,
}

/// How much a rounding cuts off, compared with half a unit in the last kept place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Loss {
    Nothing,
    LessThanHalf,
    Half,
    MoreThanHalf,
}

/// Reads an encoded number; bits above the format's width are ignored.
pub fn decode(fmt: FloatFormat, a: u64) -> Value {
    let negative = a & fmt.sign_bit() != 0;
    let field = (a >> fmt.man) & fmt.exp_max();
    let fraction = a & fmt.man_mask();
    if field == 0 {
        Value::Zero(negative)
    } else if field == fmt.exp_max() {
        if fraction == 0 { Value::Infinite(negative) } else { Value::Nan }
    } else {
        let sig = u128::from(fraction | (1 << fmt.man));
        Value::Finite(Finite { negative, sig, exp: field as i32 - fmt.bias() - fmt.man as i32 })
    }
}

/// Infinity of a sign, encoded.
fn infinity(fmt: FloatFormat, negative: bool) -> u64 {
    zero(fmt, negative) | fmt.infinity()
}

/// Zero of a sign, encoded.
fn zero(fmt: FloatFormat, negative: bool) -> u64 {
    if negative { fmt.sign_bit() } else { 0 }
}

/// Rounds `(-1)^negative * (sig + r) * 2^exp` to nearest even, where `r` is 0, or, with `rest`, anything strictly between 0 and 1.
///
/// The exponent is unbounded until the significand is rounded; only then is the range looked at: too small is zero of the sign,
/// too large is infinity.
///
/// # Panics
/// If `sig` is 0, or if there is a rest and `sig` has less than one bit more than the format keeps (the rest could not be weighed).
fn round(fmt: FloatFormat, negative: bool, sig: u128, exp: i32, rest: bool) -> u64 {
    let keep = fmt.man as i32 + 1;
    let drop = u128::BITS as i32 - sig.leading_zeros() as i32 - keep;
    assert!(sig != 0 && (drop > 0 || !rest));
    let (kept, loss) = if drop > 0 { (sig >> drop, classify(sig, drop, rest)) } else { (sig << -drop, Loss::Nothing) };
    let mut kept = kept as u64;
    kept += u64::from(loss == Loss::MoreThanHalf || (loss == Loss::Half && kept & 1 == 1));
    // The value is now kept * 2^last, and kept has `keep` bits, or is the power of two just above.
    let mut last = exp + drop;
    if kept >> keep != 0 {
        kept >>= 1;
        last += 1;
    }
    let exponent = last + fmt.man as i32;
    if exponent < 1 - fmt.bias() {
        zero(fmt, negative)
    } else if exponent > fmt.bias() {
        infinity(fmt, negative)
    } else {
        let field = (exponent + fmt.bias()) as u64;
        zero(fmt, negative) | (field << fmt.man) | (kept & fmt.man_mask())
    }
}

/// Weighs the lowest `drop` bits of `sig` and the rest behind them; `drop` is positive.
fn classify(sig: u128, drop: i32, rest: bool) -> Loss {
    let half = 1u128 << (drop - 1);
    let tail = sig & (2 * half - 1);
    if tail > half || (tail == half && rest) {
        Loss::MoreThanHalf
    } else if tail == half {
        Loss::Half
    } else if tail != 0 || rest {
        Loss::LessThanHalf
    } else {
        Loss::Nothing
    }
}
