//! Runs the very graph that is emitted: elaborated at any parameter values, levelized once.
#![forbid(unsafe_code)]
mod bundle;
mod elaborate;
mod eval;
mod flat;
mod fuse;
mod kernel;
mod lanes;
mod layout;
mod netlist;
mod optimize;
mod program;
mod simplify;
mod stream;
mod tracked;
mod wave;
mod wave_file;

pub use elaborate::elaborate;
pub use eval::eval;
pub use kernel::BLOCK;
pub use lanes::Lanes;
pub use netlist::{FlatOp, FlatPort, Kind, Netlist, Slot};
pub use stream::{Stream, StreamRun, Traffic};
pub use tracked::{Bits, Tracked};
pub use wave::Wave;
pub use wave_file::WaveFormat;
