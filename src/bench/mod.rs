//! Benches that replay the vectors in a simulator: their text, and running them.
mod run;
mod text;

pub use run::{Outcome, Simulator, run_bench};
pub use text::bench_files;
