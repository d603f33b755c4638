//! The golden arithmetic against oracles that share nothing with it, nor with each other:
//! rustc_apfloat, exact fractions rounded once, and, for the widest format, the machine.
//!
//! `RELIEFRTL_PAIRS` sets the random operand pairs per operation, `RELIEFRTL_SEED` their seed:
//! `RELIEFRTL_PAIRS=5000000 cargo test --release --test golden float_oracle -- --nocapture`
mod apfloat;
mod arithmetic;
mod choices;
mod convert;
mod operands;
mod rational;

use reliefrtl::format::FloatFormat;
use reliefrtl::golden::float;
use std::cmp::Ordering;

/// The operations both oracles know; `Lt` gives 0 or 1, `Compare` a bit for each of less, equal, greater, unordered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Op {
    Add,
    Mul,
    Div,
    Lt,
    Sqrt,
    Recip,
    Compare,
    Add3,
}

impl Op {
    pub const ALL: [Self; 8] =
        [Self::Add, Self::Mul, Self::Div, Self::Lt, Self::Sqrt, Self::Recip, Self::Compare, Self::Add3];

    /// Operands that it takes.
    pub fn arity(self) -> u32 {
        match self {
            Self::Sqrt | Self::Recip => 1,
            Self::Add3 => 3,
            _ => 2,
        }
    }
    /// The result under test.
    pub fn golden(self, fmt: FloatFormat, x: [u64; 3]) -> u64 {
        match self {
            Self::Add => float::add(fmt, x[0], x[1]),
            Self::Mul => float::mul(fmt, x[0], x[1]),
            Self::Div => float::div(fmt, x[0], x[1]),
            Self::Lt => u64::from(float::lt(fmt, x[0], x[1])),
            Self::Sqrt => float::sqrt(fmt, x[0]),
            Self::Recip => float::recip(fmt, x[0]),
            Self::Compare => match float::compare(fmt, x[0], x[1]) {
                Some(Ordering::Less) => 1,
                Some(Ordering::Equal) => 2,
                Some(Ordering::Greater) => 4,
                None => 8,
            },
            Self::Add3 => float::add3(fmt, x),
        }
    }
}

/// Reads a number from the environment.
pub fn env(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name}={v} is not a number")))
}
