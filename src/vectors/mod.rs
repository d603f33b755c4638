//! Vector sets: stimulus and expected results, one set replayed by every engine.
mod corners;
mod files;
mod levels;
mod set;
mod weights;

pub use corners::{Kind, Plan, exhaustive, landmarks, plan_rows};
pub use files::{Rows, read_csv, read_json, read_set, set_files};
pub use levels::{Campaign, Level, Shard, campaign_rows};
pub use set::{Column, Counts, VectorSet};
