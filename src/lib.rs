//! reliefrtl: parameterized Verilog for ray / height-field traversal, with golden vectors and an interpreter of the same
//! datapath.
pub mod bench;
pub mod bits;
pub mod catalogue;
pub mod cli;
pub mod config;
pub mod emit;
pub mod error;
pub mod files;
pub mod fit;
pub mod format;
pub mod golden;
pub mod interp;
pub mod ir;
pub mod measure;
pub mod measured;
pub mod oracle;
pub mod process;
pub mod project;
pub mod proofs;
pub mod report;
pub mod scene;
pub mod synth;
pub mod trace;
pub mod units;
pub mod vectors;
pub mod verilog;
