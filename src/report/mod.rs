//! Figures: steps, error against the exact oracle, speed of the engines. Each with its count and its worst case.
mod accuracy;
mod bilinear;
mod cost;
pub mod endure;
mod fit;
pub mod hard;
pub mod page;
mod steps;
pub mod turns;
mod uv;

pub use accuracy::{Accuracy, WrongTexel, accuracy, exact_ray, uv_given};
pub use bilinear::{Bilinear, bilinear};
pub use cost::Cost;
pub use fit::{Budget, Checked, Fit, Limits, Rejected, SETS, Trial, Truth, fit, fit_checked};
pub use page::stats::Spread;
pub use steps::{PUBLISHED, Published, ROWS, Steps, TRIM_ROWS, steps};
pub use uv::{DEFINITION, GIVEN_BITS, given_ray, place, uv_error};
