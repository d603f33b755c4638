//! The golden arithmetic against oracles that share nothing with it, nor with each other:
//! rustc_apfloat, exact fractions rounded once, and, for the widest format, the machine.
//!
//! `RELIEFRTL_PAIRS` sets the random operand pairs per operation, `RELIEFRTL_SEED` their seed:
//! `RELIEFRTL_PAIRS=5000000 cargo test --release --test float_oracle -- --nocapture`
mod apfloat;
mod arithmetic;
mod convert;
mod operands;
mod rational;

/// The operations both oracles know; `Lt` gives 0 or 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Op {
    Add,
    Mul,
    Div,
    Lt,
}

impl Op {
    pub const ALL: [Self; 4] = [Self::Add, Self::Mul, Self::Div, Self::Lt];
}

/// Reads a number from the environment.
pub fn env(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name}={v} is not a number")))
}
