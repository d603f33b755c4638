//! The widths of the windows' traversal (`docs/windows.md`, "Once per ray"): numbers alone, which model and hardware both read.
use crate::Design;

/// Operand bits of one multiplier.
const OPERAND: u32 = 18;

/// The widths of one design.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WindowWidths {
    /// e: fraction bits of the estimate's texel.
    pub estimate_fraction: u32,
    /// n + T + e: bits of s, the travel a height code as the estimate has it.
    pub travel: u32,
    /// B: bits of m that the estimate multiplies with, its topmost.
    pub time: u32,
    /// g': fraction bits of a plane's parameter beyond those of t.
    pub guard: u32,
    /// F + 2 + g': bits of Q and C.
    pub plane: u32,
    /// n + T + 1: bits of k, the planes passed along one axis.
    pub planes: u32,
    /// F + 2: bits of a ray parameter.
    pub parameter: u32,
}

impl WindowWidths {
    /// Those of a design in fixed point.
    pub fn of(d: &Design) -> Self {
        let (n, tile) = (d.traverse.levels, d.traverse.tile_bits);
        let (f, w) = (d.datapath.fraction_bits, d.datapath.reciprocal_bits);
        let estimate_fraction = OPERAND.saturating_sub(n + tile).min(f - n);
        let guard = (w + tile + n).saturating_sub(2 + f);
        Self {
            estimate_fraction,
            travel: n + tile + estimate_fraction,
            time: OPERAND.min(f + 2),
            guard,
            plane: f + 2 + guard,
            planes: n + tile + 1,
            parameter: f + 2,
        }
    }
}
