//! The exact answer: a walk over the level-0 texels with rational comparisons that never round.
//!
//! It shares nothing with the golden model, not even how a number is read, so that it can say how often the datapath's
//! rounding leads to another texel. Entry point and travel are taken as the exact values of the encoded numbers.
//!
//! The rules are those of the datapath: the map repeats, cells are half-open `[entry, exit)`, the u plane goes first on a tie,
//! height code c stands at ray parameter M - c, M = 2^height_bits - 1.
mod exact;
mod value;
mod walk;

pub use exact::{Dyadic, Ratio};
pub use walk::{ExactHit, ExactMap, ExactRay};
