//! The exact answer: a walk over the level-0 texels whose decisions are never rounded.
//!
//! It shares nothing with the golden model, not even how a number is read, so that it can say how often the datapath's
//! rounding leads to another texel. Entry point and travel are taken as the exact values of the encoded numbers.
//!
//! # Ties
//!
//! The rules are those of the datapath, and decide every tie:
//!
//! * the map repeats; cells are half-open `[entry, exit)` in the ray parameter, so a ray that enters on a border and runs toward
//!   lower indices crosses it at once, and a texel whose top is met exactly on its exit plane is not hit;
//! * the u plane goes first where both planes are met at once; the texel that is touched only in that corner is never hit;
//! * a top that is met exactly on entry is met as a top, not as a wall;
//! * height code c stands at ray parameter M - c, M = 2^height_bits - 1.
//!
//! # How it decides
//!
//! Parameters are compared in f64 where they differ by more than f64 can err, and as quotients of 256-bit integers where they don't:
//! formats up to 8/23, fixed point up to 28 fraction bits and maps of up to 4096 texels always fit.
mod axis;
mod bilinear;
mod exact;
mod value;
mod walk;
mod wide;

pub use bilinear::Root;
pub use exact::{Dyadic, Ratio};
pub use walk::{ExactHit, ExactMap, ExactRay};
pub use wide::U256;
