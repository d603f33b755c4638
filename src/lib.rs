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
pub use reliefrtl_base::{alike, bits, error, files, format, measured, process};
pub use reliefrtl_config as config;
pub use reliefrtl_golden as golden;
pub use reliefrtl_interp as interp;
pub use reliefrtl_ir as ir;
pub use reliefrtl_oracle as oracle;
pub use reliefrtl_scene as scene;
pub use reliefrtl_units as units;
pub use reliefrtl_verilog as verilog;
