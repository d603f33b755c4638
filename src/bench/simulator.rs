//! The simulators: their programs, and what they build.

/// A simulator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Simulator {
    /// `iverilog` and `vvp`.
    Icarus,
    /// `verilator`; the environment's VERILATOR names another program.
    Verilator,
}

impl Simulator {
    /// Name as on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Icarus => "icarus",
            Self::Verilator => "verilator",
        }
    }
    /// What a build makes, in the directory where it works.
    pub(super) fn product(self) -> &'static str {
        match self {
            Self::Icarus => "bench.vvp",
            Self::Verilator => "obj/Vtb",
        }
    }
    /// Programs that it starts.
    pub fn programs(self) -> Vec<String> {
        match self {
            Self::Icarus => vec![self.program(), "vvp".into()],
            Self::Verilator => vec![self.program(), "make".into()],
        }
    }
    /// The program that builds.
    pub(super) fn program(self) -> String {
        match self {
            Self::Icarus => "iverilog".into(),
            Self::Verilator => std::env::var("VERILATOR").unwrap_or_else(|_| "verilator".into()),
        }
    }
}
