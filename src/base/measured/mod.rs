//! Figures that stand in the project's documents and on which `--clock` rests: `data/figures.json`, an entry a line, as `reliefrtl synth` writes them.
//!
//! Each has the digest of the emitted text that it was measured on. `reliefrtl synth --stale data/figures.json` names those whose text
//! has changed since (a test asks for it), `--refresh` measures them again.
use serde::Deserialize;
use std::sync::LazyLock;

/// The clock of a placed and routed unit.
#[derive(Clone, Debug, Deserialize, PartialEq)]
pub struct Clock {
    /// MHz by seed.
    #[serde(default)]
    pub mhz: Vec<(u32, f64)>,
    /// Their median.
    pub median: f64,
    /// Slowest path at that median.
    #[serde(default)]
    pub critical: Critical,
}

/// Ends and length of a critical path.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(default)]
pub struct Critical {
    /// Register that it leaves.
    pub from: String,
    /// Register that it reaches.
    pub to: String,
    /// Nanoseconds in cells.
    pub logic_ns: f64,
    /// Nanoseconds in wires.
    pub routing_ns: f64,
}

/// What was measured of one unit.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(default)]
pub struct Entry {
    /// The call that measures it: `reliefrtl synth --unit fp_add --latency 1`.
    pub command: String,
    /// Unit.
    pub unit: String,
    /// Clocks from operand to result; none for a handshaked unit.
    pub latency: Option<u32>,
    /// Name of what it was mapped to.
    pub target: String,
    /// Look-up tables.
    pub luts: u64,
    /// Carry cells.
    pub carries: u64,
    /// Multiplier blocks.
    pub multipliers: u64,
    /// Block memories.
    pub memories: u64,
    /// Memories of look-up tables.
    pub lut_memories: u64,
    /// Flip-flops.
    pub flip_flops: u64,
    /// Clock, where it was placed and routed.
    pub clock: Option<Clock>,
    /// Digest of the emitted text that was measured; none: nothing was measured yet.
    pub digest: Option<String>,
    /// Names and versions of the tools.
    pub tools: Vec<String>,
}

impl Entry {
    /// The words of the call after `reliefrtl synth`.
    pub fn words(&self) -> Vec<&str> {
        self.command.split_whitespace().skip(2).collect()
    }

    /// True if the call asks for nothing but this unit at one latency, with `more` besides.
    pub fn is_alone(&self, unit: &str, more: &[&str]) -> bool {
        let latency = self.latency.map(|l| l.to_string()).unwrap_or_default();
        let plain = [&["--unit", unit, "--latency", &latency][..], more].concat();
        self.words() == plain
    }
}

/// The entries of a file like `data/figures.json`.
///
/// # Errors
/// The parser's sentence.
pub fn parse(text: &str) -> Result<Vec<Entry>, serde_json::Error> {
    serde_json::from_str(text)
}

/// The figures of `data/figures.json`. One without a digest is of an earlier text: it helps to choose, and is promised nowhere.
pub fn all() -> &'static [Entry] {
    static ALL: LazyLock<Vec<Entry>> = LazyLock::new(|| {
        parse(include_str!("../../../data/figures.json")).expect("a list of figures, as a test holds")
    });
    &ALL
}
