//! Vector sets: stimulus and expected results, one set replayed by every engine.
mod campaign;
mod corners;
mod files;
mod kind;
mod levels;
mod set;
mod weights;

pub use campaign::{Campaign, Level, Shard};
pub use corners::{Plan, exhaustive, landmarks, plan_rows};
pub use files::{Rows, read_csv, read_json, read_set, set_files};
pub use kind::Kind;
pub use levels::campaign_rows;
pub use set::{Column, Counts, Iterations, VectorSet};
