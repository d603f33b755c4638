//! The numbers: iterations, error against the exact oracle, corner cases, what every ray ends in, cost, turns. Each with its count and its
//! worst case, as plain data; their words are found where they are printed.
mod accuracy;
mod again;
mod bilinear;
pub mod corner_cases;
mod cost;
pub mod soak;
pub mod spread;
mod steps;
pub mod turns;
mod uv;
mod words;

pub use accuracy::{Accuracy, WrongTexel, accuracy, exact_ray, uv_given};
pub use again::{again, settings, trace_again};
pub use bilinear::{Bilinear, bilinear};
pub use cost::Cost;
pub use spread::Spread;
pub use steps::{PUBLISHED, Published, StepFigures, Steps, steps};
pub use uv::{DEFINITION, GIVEN_BITS, given_ray, place, uv_error};
pub use words::{RayEnd, hex_words};
