//! The configuration: one description of the design, the input and the vectors.
mod design;
pub use design::{Design, LatencyConfig, LevelUp, ModeConfig, TraverseConfig};
