//! Engines by their names.
use super::golden::Golden;
use super::interp::Interp;
use super::run::Engine;
use super::simulated::Simulated;
use crate::bench::Simulator;

/// An engine by its name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EngineName {
    /// The bit-accurate model.
    Golden,
    /// The embedded interpreter of the emitted datapath.
    Interp,
    /// Icarus Verilog.
    Icarus,
    /// Verilator.
    Verilator,
}

impl EngineName {
    /// All, in the order of the help.
    pub const ALL: [Self; 4] = [Self::Golden, Self::Interp, Self::Icarus, Self::Verilator];

    /// The engine of this name.
    pub fn engine(self) -> &'static dyn Engine {
        match self {
            Self::Golden => &Golden,
            Self::Interp => &Interp,
            Self::Icarus => &Simulated(Simulator::Icarus),
            Self::Verilator => &Simulated(Simulator::Verilator),
        }
    }
}

impl From<Simulator> for EngineName {
    fn from(simulator: Simulator) -> Self {
        match simulator {
            Simulator::Icarus => Self::Icarus,
            Simulator::Verilator => Self::Verilator,
        }
    }
}
