//! The floating-point format's constants and named choices: all that hardware and golden model share.
mod choices;
mod words;

pub use choices::{Rounding, Specials, Subnormals};
pub use words::Words;

/// A floating-point format: 1 sign bit, `exp` exponent bits, `man` fraction bits (PIDM-HW section 4.3 uses 7 and 16),
/// and what `docs/arithmetic.md` lets one choose.
///
/// Encoded numbers are `u64`s of `1 + exp + man` bits: sign on top, then exponent, then fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FloatFormat {
    /// Exponent bits.
    pub exp: u32,
    /// Fraction bits, the hidden one not counted.
    pub man: u32,
    /// How results are rounded.
    pub rounding: Rounding,
    /// What becomes of numbers below the smallest normal one.
    pub subnormals: Subnormals,
    /// Whether there are infinities and NaN.
    pub specials: Specials,
}

impl FloatFormat {
    /// The published 24-bit format.
    pub const FP24: Self = Self::new(7, 16);

    /// A format of `exp` exponent and `man` fraction bits: nearest even, flush to zero, infinities and NaN.
    pub const fn new(exp: u32, man: u32) -> Self {
        let (rounding, subnormals, specials) = (Rounding::NearestEven, Subnormals::Flush, Specials::Ieee);
        Self { exp, man, rounding, subnormals, specials }
    }
    /// The same choices at other widths.
    pub const fn resized(self, exp: u32, man: u32) -> Self {
        Self { exp, man, ..self }
    }
    /// Whether the choices are those of [`FloatFormat::new`].
    pub const fn is_plain(self) -> bool {
        matches!(
            (self.rounding, self.subnormals, self.specials),
            (Rounding::NearestEven, Subnormals::Flush, Specials::Ieee)
        )
    }
    /// Whether there are numbers between zero and the smallest normal one.
    pub const fn is_gradual(self) -> bool {
        matches!(self.subnormals, Subnormals::Gradual)
    }
    /// Whether every code is a number.
    pub const fn is_finite(self) -> bool {
        matches!(self.specials, Specials::Finite)
    }
    /// Total width in bits.
    pub const fn width(self) -> u32 {
        1 + self.exp + self.man
    }
    /// Exponent bias, 2^(exp-1) - 1.
    pub const fn bias(self) -> i32 {
        (1 << (self.exp - 1)) - 1
    }
    /// Exponent field of all ones: infinities and NaNs, or the largest numbers where every code is one.
    pub const fn exp_max(self) -> u64 {
        (1 << self.exp) - 1
    }
    /// All ones in the fraction field.
    pub const fn man_mask(self) -> u64 {
        (1 << self.man) - 1
    }
    /// The sign bit.
    pub const fn sign_bit(self) -> u64 {
        1 << (self.exp + self.man)
    }
    /// The largest number.
    pub const fn largest(self) -> u64 {
        if self.is_finite() { self.sign_bit() - 1 } else { self.infinity() - 1 }
    }
    /// Positive infinity.
    pub const fn infinity(self) -> u64 {
        self.exp_max() << self.man
    }
    /// The one NaN that results carry: sign 0, top fraction bit 1, rest 0.
    pub const fn nan(self) -> u64 {
        self.infinity() | (1 << (self.man - 1))
    }
}

impl std::fmt::Display for FloatFormat {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.exp, self.man)?;
        let plain = Self::FP24;
        for (word, other) in [
            (self.rounding.word(), self.rounding != plain.rounding),
            (self.subnormals.word(), self.subnormals != plain.subnormals),
            (self.specials.word(), self.specials != plain.specials),
        ] {
            if other {
                write!(f, " {word}")?;
            }
        }
        Ok(())
    }
}
