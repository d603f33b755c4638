//! Benches that replay the vectors in a simulator: their text, and running them.
mod coverage;
mod harness;
mod headers;
mod kept;
mod run;
mod said;
mod simulator;
mod text;

pub use coverage::{Further, Point, PointKind, cover};
pub use harness::{COMPILERS, Harness, HarnessRun, Load, harness_text};
pub use run::{Outcome, Paths, run_bench, run_bench_on};
pub use simulator::Simulator;
pub use text::bench_files;
