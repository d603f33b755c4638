//! The arithmetic of `docs/arithmetic.md`: numbers are taken apart into exact integers, and put together by one rounding.
mod arith;
mod convert;
mod events;
mod more;
mod rounding;
mod value;

pub use arith::{add, div, lt, mul, neg};
pub use convert::{from_f64, from_fixed, from_int, power_of_two, recip_int, to_f64, to_fixed, to_int};
pub use events::{Events, events};
pub use more::{add3, compare, recip, sqrt};
pub use value::{Finite, Value, decode};
