//! Primitive modules: what is written as a whole instead of as a graph.
use super::expr::Binding;

/// Primitive modules: each has one meaning in `bits` and one Verilog body with loops.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Prim {
    /// `bits` \[W\] to `count` \[clog2(W+1)\].
    Lzc,
    /// `a`, `b` \[W\] to `result` \[2W\].
    Interleave,
    /// `rem_in` \[W+1\], `div` \[W\] to `rem_out` \[W+1\], `quot` \[ROWS\].
    DivRows,
    /// `rem_in` \[W+1\], `root_in` \[W\] to `rem_out` \[W+1\], `root_out` \[W\], digits FIRST to FIRST + ROWS - 1.
    SqrtRows,
    /// Single read, single write memory with registered read.
    Memory,
    /// The same with few words, which change while rays are inside.
    FifoMem,
    /// The same in banks, each with a second register.
    Banks,
    /// `in_data` \[W\] to `out_data` \[W\] CLOCKS clocks later, held while the clock enable is 0.
    DelayLine,
    /// `index` \[8\] to `word` \[33\] one clock later: constants, held while the clock enable is 0.
    RecipTable,
}

impl Prim {
    /// Clocks from inputs to outputs, at the parameters `at`.
    pub(crate) fn clocks(self, at: &Binding) -> u32 {
        match self {
            Self::Lzc | Self::Interleave | Self::DivRows | Self::SqrtRows => 0,
            Self::Memory | Self::FifoMem | Self::RecipTable => 1,
            Self::Banks => 2,
            Self::DelayLine => at["CLOCKS"] as u32,
        }
    }
}
