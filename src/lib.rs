//! reliefrtl: parameterized Verilog for ray / height-field traversal, with golden vectors and an interpreter of the same
//! datapath.
pub mod bench;
pub mod catalogue;
pub mod cli;
pub mod emit;
pub mod engine;
pub mod fit;
pub mod measure;
pub mod project;
pub mod proofs;
pub mod report;
pub mod synth;
pub mod trace;
pub mod vectors;
pub use base::{bits, error, files, format, measured, process};
pub use {config, golden, interp, ir, oracle, scene, units, verilog};
