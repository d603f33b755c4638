//! What a column holds.
use crate::format::FloatFormat;

/// What the words of a column mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An encoded number.
    Float(FloatFormat),
    /// A word of so many bits, signed or not.
    Integer(u32),
}

impl Kind {
    /// Bits.
    pub const fn width(self) -> u32 {
        match self {
            Self::Float(f) => f.width(),
            Self::Integer(w) => w,
        }
    }
}
