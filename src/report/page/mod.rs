//! The report: speed against error of every design, as one page, JSON and CSV with the same numbers.
mod plan;

pub use plan::{Extent, Plan};
