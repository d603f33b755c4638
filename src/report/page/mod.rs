//! The report: speed against error of every design, as one page, JSON and CSV with the same numbers.
mod cell;
mod plan;
mod stats;
mod store;

pub use cell::{Cell, CellSpec, Witness};
pub use plan::{Extent, Plan};
pub use store::{Work, cells};
