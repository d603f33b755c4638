//! Areas and clocks of a unit, by Yosys and nextpnr where they are installed.
//!
//! The unit stands between two ranks of registers on every input and output, so that no pad lies on a path, and its
//! clock enable is tied to 1. A latency of L means L clocks from the operand's register to the result's.
mod flow;
mod path;
mod top;

pub use flow::{Clock, Figures, Placing, Target, measure, measure_files};
pub use path::Critical;
pub use top::top_module;
