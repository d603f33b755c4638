//! Areas and clocks of a unit, by Yosys and nextpnr where they are installed.
//!
//! The unit stands between two ranks of registers on every input and output, so that no pad lies on a path, and its
//! clock enable is tied to 1. A latency of L means L clocks from the operand's register to the result's.
mod digest;
mod flow;
mod foreign;
mod path;
mod top;

pub use digest::digest;
pub use flow::{Clock, Figures, Placing, Target, asked, check_module_name, measure, measure_files, versions};
pub use foreign::{Foreign, foreign};
pub use path::Critical;
pub use top::top_module;
