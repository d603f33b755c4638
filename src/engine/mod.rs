//! What runs the datapath, under one trait: the golden model, the interpreter, Icarus Verilog, Verilator. Here alone one is chosen by its name.
mod golden;
mod interp;
mod name;
mod run;
mod simulated;
pub mod stored;

pub use name::EngineName;
pub use run::{Checked, CheckedFigures, Engine, Replay, SlotLoad, Traced};
