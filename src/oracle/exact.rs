//! Non-negative rationals `num / den * 2^exp`, compared without rounding.
use super::wide::{U256, aligned};
use reliefrtl_base::error::{Error, Result};
use std::cmp::Ordering;

/// The exact value `num / den * 2^exp`; `den` is not 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ratio {
    /// Numerator.
    pub num: U256,
    /// Denominator, not 0.
    pub den: u128,
    /// Power of two.
    pub exp: i32,
}

impl Ratio {
    /// An integer.
    pub const fn integer(v: u64) -> Self {
        Self { num: U256 { high: 0, low: v as u128 }, den: 1, exp: 0 }
    }

    /// Exact order of two values, and how far they are apart, to within a few units in the last place of an f64; 0 only of
    /// equal values.
    ///
    /// # Errors
    /// [`Error::Input`] if a cross product does not fit in 256 bits; the answer is never a rounded one.
    pub fn order(&self, other: &Self) -> Result<(Ordering, f64)> {
        let left = self.num.checked_mul(other.den).ok_or_else(too_wide)?;
        let right = other.num.checked_mul(self.den).ok_or_else(too_wide)?;
        let far = || (self.to_f64() - other.to_f64()).abs();
        let (order, apart) = match aligned(left, self.exp, right, other.exp) {
            // Close ones are subtracted before they are rounded.
            Ok((left, right, exp)) => {
                (left.cmp(&right), scale(left.abs_diff(right).to_f64() / self.den as f64 / other.den as f64, exp))
            }
            Err(order) => (order, far()),
        };
        Ok((order, if order.is_eq() { 0.0 } else { apart.max(f64::MIN_POSITIVE) }))
    }

    /// The value to within a few units in the last place of an f64.
    pub fn to_f64(&self) -> f64 {
        scale(self.num.to_f64() / self.den as f64, self.exp)
    }
}

/// `x * 2^exp`.
pub(super) fn scale(x: f64, exp: i32) -> f64 {
    // Two halves of the power keep the intermediate values in range.
    let half = exp / 2;
    x * 2f64.powi(half) * 2f64.powi(exp - half)
}

/// The error of a ray whose numbers are too far apart for 256-bit integers.
pub(super) fn too_wide() -> Error {
    Error::input("the ray's numbers are too far apart for an exact walk in 256-bit integers")
}

/// A dyadic number `sig * 2^exp` with its sign; `sig` is odd, or 0 with `exp` 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dyadic {
    pub(super) negative: bool,
    pub(super) sig: u128,
    pub(super) exp: i32,
}

impl Dyadic {
    /// `sig * 2^exp` with a sign.
    pub fn new(negative: bool, sig: u128, exp: i32) -> Self {
        if sig == 0 {
            return Self { negative, sig, exp: 0 };
        }
        let even = sig.trailing_zeros();
        Self { negative, sig: sig >> even, exp: exp + even as i32 }
    }

    /// Reads a finite encoded number of `exp_w` exponent and `man_w` fraction bits; None for infinities and NaNs.
    pub fn read(code: u64, exp_w: u32, man_w: u32) -> Option<Self> {
        let fraction = code % (1 << man_w);
        let field = (code >> man_w) % (1 << exp_w);
        let negative = (code >> man_w) >> exp_w & 1 == 1;
        if field == (1 << exp_w) - 1 {
            return None;
        }
        if field == 0 {
            return Some(Self { negative, sig: 0, exp: 0 });
        }
        let sig = fraction + (1 << man_w);
        let unit = 1 - (1i32 << (exp_w - 1)) + field as i32 - man_w as i32;
        Some(Self::new(negative, u128::from(sig), unit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_agrees_with_plain_integers() {
        let values = [(0u128, 3), (1, 0), (1, 1), (2, 0), (3, -1), (3, 0), (7, -2), (u128::MAX, -126), (1, 2)];
        let ratio = |(a, exp): (u128, i32)| Ratio { num: a.into(), den: 1, exp };
        for a in values {
            for b in values {
                // u128::MAX * 2^-126 is just below 4, which f64 can't tell apart.
                let near = |x: (u128, i32)| if x.0 == u128::MAX { 3.5 } else { x.0 as f64 * 2f64.powi(x.1) };
                let (order, apart) = ratio(a).order(&ratio(b)).unwrap();
                assert_eq!(order, near(a).partial_cmp(&near(b)).unwrap(), "{a:?} {b:?}");
                assert_eq!(order.is_eq(), apart == 0.0);
            }
        }
        let close = ratio((u128::MAX, -126)).order(&ratio((1, 2))).unwrap();
        assert_eq!(close, (Ordering::Less, 2f64.powi(-126)));
    }

    #[test]
    fn too_wide_is_an_error_and_not_an_answer() {
        let wide = Ratio { num: U256 { high: 1 << 127, low: 0 }, den: 3, exp: 0 };
        assert!(wide.order(&wide).is_err());
    }

    #[test]
    fn reads_numbers() {
        let read = |code| Dyadic::read(code, 7, 16);
        assert_eq!(read(0x3f_0000), Some(Dyadic { negative: false, sig: 1, exp: 0 }));
        assert_eq!(read(0xbf_8000), Some(Dyadic { negative: true, sig: 3, exp: -1 }));
        assert_eq!(read(0x80_1234), Some(Dyadic { negative: true, sig: 0, exp: 0 }));
        assert_eq!(read(0x7f_0000), None);
    }
}
