//! The report: speed against error of every design, as one page, JSON and CSV with the same numbers.
mod bilinear;
mod charts;
mod figures;
mod inventory;
mod measurement;
mod pictures;
mod plan;
mod published;
mod replay;
mod sections;
mod store;
mod svg;
mod table;
mod units;
mod write;

pub use measurement::{Measurement, MeasurementSpec, Witness};
pub use plan::{Extent, ModeSet, Plan, Selection};
pub use store::{Work, measurements};
pub use write::{Output, files, write};
