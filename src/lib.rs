//! reliefrtl: parameterized Verilog for ray / height-field traversal, with golden vectors and an interpreter of the same datapath.
pub mod config;
pub mod error;
pub mod files;
pub mod format;
pub mod scene;
