//! What is known of a datapath besides its arithmetic and its hardware.
use super::kind::DatapathConfig;
use crate::{Config, Design};
use reliefrtl_base::format::{FloatFormat, Words};

/// A row of the table: one datapath.
#[derive(Debug)]
pub struct DatapathFacts {
    /// The word in the TOML file and on the command line.
    pub word: &'static str,
    /// Which keys besides `datapath.kind` choose its arithmetic.
    pub reads: Reads,
    /// The numbers of a ray.
    pub words: fn(&Design) -> Words,
    /// An iteration steps texel indices over planes; without, it moves positions.
    pub steps_indices: bool,
    /// The loop holds the dividers.
    pub divides_in_loop: bool,
    /// A start level is found by a trip through the loop, before the first iteration.
    pub start_trip: bool,
    /// Every ray ends, and in the same hit whatever the mode.
    pub modes_agree: bool,
    /// It reads all windows ahead of the ray in one iteration: no node, no level, and none of the modes that choose them.
    pub windows: bool,
    /// It has `mode.trim`, at number formats that [`DatapathFacts::trim_fits`] allows.
    pub trim: bool,
    /// Whether a chord trim is possible in this number format.
    pub trim_fits: fn(FloatFormat) -> bool,
    /// It has `mode.lod`.
    pub lod: bool,
    /// It has `mode.bilinear`.
    pub bilinear: bool,
    /// Latencies for a clock follow from those of its units; without, from profiles that were placed whole.
    pub clock_by_units: bool,
    /// INT_W and FRAC_W of `fp_from_fixed`, bits.
    pub from_fixed: fn(&Design) -> (u32, u32),
    /// What must hold of its widths: each adds a sentence for what does not.
    pub limits: &'static [fn(&Config, &mut Vec<String>)],
    /// Datapath and widths in a few words.
    pub label: fn(&DatapathConfig, FloatFormat) -> String,
    /// Its widths, narrow to wide: of each step the first legal design counts.
    pub ladder: fn(&Design) -> Vec<Vec<Design>>,
    /// The design with a bit less where that does not change the words of a ray; `None`: nothing can be left out.
    pub narrower: fn(&Design) -> Option<Design>,
}

/// Which keys a datapath reads.
#[derive(Clone, Copy, Debug)]
pub struct Reads {
    /// The table `format`.
    pub format: bool,
    /// `datapath.nudge_bits`.
    pub nudge_bits: bool,
    /// `datapath.fraction_bits` and `datapath.reciprocal_bits`.
    pub fraction_bits: bool,
}
