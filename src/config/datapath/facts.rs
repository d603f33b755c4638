//! What is known of a datapath besides its arithmetic and its hardware.
use super::kind::DatapathConfig;
use crate::{Config, Design, ModeConfig, Trim, WindowsConfig};
use reliefrtl_base::format::{FloatFormat, Words};

/// A row of the table: one datapath.
#[derive(Debug)]
pub struct DatapathFacts {
    /// Its word, by which tables and messages call it.
    pub word: &'static str,
    /// The keys that choose it, each with its word in the TOML file and on the command line; the last one is what tells it from others.
    pub chosen_by: &'static [(&'static str, &'static str)],
    /// Which keys besides `datapath.kind` choose its arithmetic.
    pub reads: Reads,
    /// The numbers of a ray.
    pub words: fn(&Design) -> Words,
    /// The loop holds the dividers.
    pub divides_in_loop: bool,
    /// A start level is found by a trip through the loop, before the first iteration.
    pub start_trip: bool,
    /// Every ray ends by itself; without, one may stay in a texel until the step limit.
    pub rays_end: bool,
    /// Every ray ends in the same hit whatever the mode.
    pub modes_agree: bool,
    /// An iteration reads one node of a level: there are a start level, a descent and a way up, and one address interleaved of both indices.
    pub reads_nodes: bool,
    /// A hit counts node crossings and levels gone up beside its iterations.
    pub counts_levels: bool,
    /// The loop is shorter than two sums in series between registers, so what stands before and after it has a register after each: the travel's
    /// magnitude, every row of the reciprocal, the hit's difference.
    pub short_loop: bool,
    /// It has `mode.trim`, at number formats that [`DatapathFacts::trim_fits`] allows.
    pub has_trim: bool,
    /// Whether a chord trim is possible in this number format.
    pub trim_fits: fn(FloatFormat) -> bool,
    /// It has `mode.lod`.
    pub has_lod: bool,
    /// It can read four cells in one iteration (`fetch.cells`).
    pub has_blocks: bool,
    /// It has `mode.bilinear`.
    pub has_bilinear: bool,
    /// Latencies for a clock follow from those of its units; without, from profiles that were placed whole.
    pub clock_by_units: bool,
    /// INT_W and FRAC_W of `fp_from_fixed`, bits.
    pub from_fixed: fn(&Design) -> (u32, u32),
    /// What must hold of its widths: each adds a sentence for what does not.
    pub limits: &'static [fn(&Config, &mut Vec<String>)],
    /// Keys, or sections with a point at their end, that it has no use for, each with what it has instead in a few words: refused where they are
    /// given, ignored where they are defaults.
    pub ignores: &'static [(&'static str, &'static str)],
    /// Puts what it does not read to its default.
    pub forget: fn(&mut Config),
    /// Arithmetic and widths in a few words.
    pub arithmetic: fn(&DatapathConfig, FloatFormat) -> String,
    /// Datapath and widths in a few words, with all that tells two designs of it apart but the mode.
    pub label: fn(&Design) -> String,
    /// How hits are found, in a few words.
    pub way: fn(&ModeConfig, &WindowsConfig) -> String,
    /// The same in a sentence, without its subject.
    pub sentence: fn(&ModeConfig, &WindowsConfig) -> String,
    /// Whether a mode that is compared makes a design of its own: of modes that are all one to it, [`crate::modes::BEST`] stands for all.
    pub has_mode: fn(&ModeConfig) -> bool,
    /// Other designs of the same widths that must find the same hits, those with these trims among them.
    pub ways: fn(&Design, &[Trim]) -> Vec<Design>,
    /// Designs of the same numbers, and so of the same hits, that search otherwise.
    pub searches: fn(&Design) -> Vec<Design>,
    /// The design whose hits it must equal: itself, where it answers to the oracle alone.
    pub reference: fn(&Design) -> Design,
    /// The same with all written out that the emitted text holds fast, whatever its parameters are.
    pub settled: fn(&Design) -> Design,
    /// Nets of an iteration that have a value in the model, too, in the order in which they are computed.
    pub nets: &'static [&'static str],
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
    /// `windows.set`.
    pub window_set: bool,
}

impl DatapathFacts {
    /// Whether it has no use for a key.
    pub fn ignores(&self, key: &str) -> bool {
        self.ignores.iter().any(|(what, _)| crate::keys::stands_in(key, what))
    }
}
