//! The floating-point format's constants: all that hardware and golden model share.

/// A floating-point format: 1 sign bit, `exp` exponent bits, `man` fraction bits (PIDM-HW section 4.3 uses 7 and 16).
///
/// Encoded numbers are `u64`s of `1 + exp + man` bits: sign on top, then exponent, then fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FloatFormat {
    /// Exponent bits.
    pub exp: u32,
    /// Fraction bits, the hidden one not counted.
    pub man: u32,
}

impl FloatFormat {
    /// The published 24-bit format.
    pub const FP24: Self = Self { exp: 7, man: 16 };

    /// A format of `exp` exponent and `man` fraction bits.
    pub const fn new(exp: u32, man: u32) -> Self {
        Self { exp, man }
    }
    /// Total width in bits.
    pub const fn width(self) -> u32 {
        1 + self.exp + self.man
    }
    /// Exponent bias, 2^(exp-1) - 1.
    pub const fn bias(self) -> i32 {
        (1 << (self.exp - 1)) - 1
    }
    /// Exponent field of infinities and NaNs: all ones.
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
        write!(f, "{}/{}", self.exp, self.man)
    }
}
