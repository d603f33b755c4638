//! What the words of a ray are: the datapath chooses it, and hardware, models and stimulus each read it for themselves.
use super::FloatFormat;

/// The numbers that entry point and travel of a ray are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Words {
    /// Encoded floating-point numbers.
    Float(FloatFormat),
    /// Integers in 2^-`fraction_bits` tiles: entry points unsigned, travels in two's complement.
    Fixed {
        /// Fraction bits.
        fraction_bits: u32,
        /// Bits of a travel, its sign included.
        travel_bits: u32,
    },
}

impl Words {
    /// The number format, where the numbers are floating-point ones.
    pub const fn float(self) -> Option<FloatFormat> {
        match self {
            Self::Float(format) => Some(format),
            Self::Fixed { .. } => None,
        }
    }

    /// Exponent of the smallest positive number.
    pub const fn least_exponent(self) -> i32 {
        match self {
            Self::Float(format) => 1 - format.bias(),
            Self::Fixed { fraction_bits, .. } => -(fraction_bits as i32),
        }
    }

    /// Exponent of the distance from a number of exponent `exp` to the next larger one.
    pub const fn spacing_exponent(self, exp: i32) -> i32 {
        match self {
            Self::Float(format) => {
                let least = self.least_exponent();
                (if exp > least { exp } else { least }) - format.man as i32
            }
            Self::Fixed { .. } => self.least_exponent(),
        }
    }

    /// Whether the word of a travel is a zero.
    pub const fn is_zero(self, travel: u64) -> bool {
        match self {
            Self::Float(format) => travel & !format.sign_bit() < 1 << format.man,
            Self::Fixed { .. } => travel == 0,
        }
    }
}
