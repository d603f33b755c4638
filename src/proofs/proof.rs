//! What a proof is; which there are stands with the units, in the table of `catalogue`.
use crate::ir::Module;
use std::sync::Arc;

/// What a proof is about.
#[derive(Clone, Copy, Debug)]
pub struct Proof {
    /// Its name; the harness is `<prefix>fv_<name>.v`, the script `<prefix>fv_<name>.sby`.
    pub name: &'static str,
    /// Units that must be part of the design.
    pub units: &'static [&'static str],
    /// What is proved, in a sentence.
    pub claim: &'static str,
    /// Template of the harness.
    pub text: &'static str,
    /// The solver: [`WORD_LEVEL`], [`BIT_LEVEL`] or [`INVARIANT`].
    pub engine: &'static str,
    /// Parameter values other than the defaults.
    pub over: &'static [(&'static str, i64)],
    /// Each unit feeds the next: the claim is about the output after all their clocks, not after those of the first.
    pub chained: bool,
    /// How far the solver goes.
    pub reach: Reach,
    /// What the script adds to the design.
    pub extra: Extra,
}

/// Names the assertion that fails.
pub const WORD_LEVEL: &str = "smtbmc z3";
/// Ends where the bits are many.
pub const BIT_LEVEL: &str = "abc bmc3";
/// Proves by induction over one clock, and looks for what is missing in it by itself. The first `pdr` is the one that counts: SymbiYosys gives
/// its own an option that Debian's program does not know.
pub const INVARIANT: &str = "abc scorr; pdr -v; write_cex -a engine_0/trace.aiw; pdr";

/// A proof of which nothing is said.
pub const PROOF: Proof = Proof {
    name: "",
    units: &[],
    claim: "",
    text: "",
    engine: WORD_LEVEL,
    over: &[],
    chained: false,
    reach: Reach::Latency,
    extra: Extra::Nothing,
};

/// How far a solver goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Until the unit's outputs are those of its inputs, which stand still: for good.
    Latency,
    /// By induction over that many clocks: for good.
    Induction(u32),
}

/// What the script of a proof adds to the design.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extra {
    /// Nothing.
    Nothing,
    /// Wires of the harness, and the registers of the unit that drive them.
    Registers(&'static [(&'static str, &'static str)]),
    /// The memory and the pointer of a delay line of each length.
    DelayLines,
    /// The slots and the registers of a FIFO of 16 words.
    Fifo,
    /// The valid bits and tags of every register in which `traverse` holds a ray; the depth follows from their number.
    RaysOfTheLoop {
        /// Template of the harness where the rays are counted, because there are registers in the handshakes.
        counted: &'static str,
    },
}

impl Proof {
    /// Clocks after which the outputs are those of the inputs.
    pub(super) fn clocks(&self, units: &[Arc<Module>]) -> u32 {
        let of = |name: &&str| units.iter().find(|m| m.name == **name).and_then(|m| m.latency()).unwrap_or(0);
        if self.chained { self.units.iter().map(of).sum() } else { of(&self.units[0]) }
    }
}
