//! The named choices of a floating-point format (`docs/arithmetic.md`).
use serde::{Deserialize, Serialize};

macro_rules! choice {
    ($(#[$doc:meta])* $type:ident: $($(#[$each:meta])* $variant:ident = $word:literal),+ $(,)?) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize, schemars::JsonSchema)]
        pub enum $type {
            $($(#[$each])* #[serde(rename = $word)] $variant),+
        }
        impl $type {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];
            /// Their words in the TOML file, in the same order.
            pub const WORDS: &'static [&'static str] = &[$($word),+];
            /// The word in the TOML file and on the command line.
            pub const fn word(self) -> &'static str {
                match self { $(Self::$variant => $word),+ }
            }
        }
    };
}

choice!(
    /// How results are rounded.
    Rounding:
    /// To the nearest number, ties to the even one.
    #[default]
    NearestEven = "nearest-even",
    /// To the nearest number, ties away from zero.
    NearestAway = "nearest-away",
    /// Toward zero.
    TowardZero = "toward-zero",
    /// Toward plus infinity.
    Up = "up",
    /// Toward minus infinity.
    Down = "down",
);

choice!(
    /// What becomes of numbers below the smallest normal one.
    Subnormals:
    /// Zero of their sign, as operand and as result.
    #[default]
    Flush = "flush",
    /// They are numbers, of fewer bits.
    Gradual = "gradual",
);

choice!(
    /// What an exponent field of all ones means.
    Specials:
    /// Infinities and NaN.
    #[default]
    Ieee = "ieee",
    /// The largest numbers: every code is a number, and results saturate.
    Finite = "finite",
);
