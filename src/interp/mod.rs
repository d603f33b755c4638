//! Runs the very graph that is emitted: elaborated at any parameter values, levelized once.
mod elaborate;
mod eval;
mod lanes;
mod netlist;
mod stream;
mod tracked;
mod wave;

pub use elaborate::elaborate;
pub use lanes::Lanes;
pub use netlist::{FlatOp, FlatPort, Kind, Netlist, Slot};
pub use stream::{Stream, StreamRun, Traffic};
pub use tracked::{Bits, Tracked};
pub use wave::Wave;
