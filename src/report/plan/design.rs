//! A design as the report names it.
use crate::config::modes::BEST;
use crate::config::{
    Config, DatapathConfig, DatapathKind, Design, FetchConfig, MapConfig, ModeConfig, TraverseConfig, WindowSet,
    WindowsConfig,
};
use crate::error::Result;
use crate::format::FloatFormat;
use crate::golden::prepare;
use serde::{Deserialize, Serialize};

/// A design, as a measurement names it: what does not matter to its datapath is left out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DesignSpec {
    /// Datapath.
    pub kind: DatapathKind,
    /// EXP_W of a floating-point datapath.
    pub exp: Option<u32>,
    /// MAN_W of a floating-point datapath.
    pub man: Option<u32>,
    /// `published`: nudge.
    pub nudge_bits: Option<u32>,
    /// `fixed`: fraction bits.
    pub fraction_bits: Option<u32>,
    /// `fixed`: bits of the reciprocal.
    pub reciprocal_bits: Option<u32>,
    /// The set of a search by windows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub windows: Option<WindowSet>,
    /// What one iteration reads.
    #[serde(default, skip_serializing_if = "reads_one")]
    pub fetch: FetchConfig,
    /// TILE_W.
    pub tile_bits: u32,
    /// FRAC_W.
    pub frac_bits: u32,
    /// STEP_LIMIT.
    pub step_limit: u32,
    /// Modes.
    pub mode: ModeConfig,
}

/// Iterations after which a ray without nudge is given up: more than any ray of the usual maps needs.
const STUCK_LIMIT: u32 = 511;

/// Whether an iteration reads one node.
fn reads_one(fetch: &FetchConfig) -> bool {
    !fetch.blocks()
}

impl DesignSpec {
    /// The configuration's design, with its own tile bits, fraction bits and step limit.
    pub fn new(c: &Config, datapath: DatapathConfig, exp: u32, man: u32, mode: ModeConfig) -> Self {
        let windows = datapath.kind.facts().reads.window_set.then_some(c.windows.set).flatten();
        let fetch = if datapath.kind.facts().has_blocks { c.fetch } else { FetchConfig::default() };
        Self { windows, fetch, ..Self::sized(&c.traverse, datapath, exp, man, mode) }
    }

    /// A design that is compared with others: positions and step limit are the usual ones, for what a configuration (of `fit`, say) needs of
    /// them is its own design's. Its rays travel no fewer tiles than the configuration's.
    pub fn usual(c: &Config, datapath: DatapathConfig, exp: u32, man: u32, mode: ModeConfig) -> Self {
        let usual = TraverseConfig::default();
        let tile_bits = usual.tile_bits.max(c.traverse.tile_bits);
        Self::sized(&TraverseConfig { tile_bits, ..usual }, datapath, exp, man, mode)
    }

    fn sized(t: &TraverseConfig, datapath: DatapathConfig, exp: u32, man: u32, mode: ModeConfig) -> Self {
        let facts = datapath.kind.facts();
        // Without its nudge more than half of the published datapath's rays stay in a texel for ever, and each costs the whole limit.
        let cap = match (facts.rays_end, datapath.nudge_bits) {
            (true, _) => 8191,
            (false, 0) => STUCK_LIMIT,
            (false, _) => 1023,
        };
        Self {
            kind: datapath.kind,
            exp: facts.reads.format.then_some(exp),
            man: facts.reads.format.then_some(man),
            nudge_bits: facts.reads.nudge_bits.then_some(datapath.nudge_bits),
            fraction_bits: facts.reads.fraction_bits.then_some(datapath.fraction_bits),
            reciprocal_bits: facts.reads.fraction_bits.then_some(datapath.reciprocal_bits),
            windows: None,
            fetch: FetchConfig::default(),
            tile_bits: t.tile_bits,
            frac_bits: t.frac_bits,
            step_limit: t.step_limit.min(cap),
            mode,
        }
    }

    /// The configuration of this design on a map of 2^levels texels.
    pub fn config(&self, base: &Config, levels: u32) -> Config {
        let mut c = base.clone();
        (c.map, c.mode, c.fetch) = (MapConfig::default(), self.mode, self.fetch);
        (c.traverse.levels, c.traverse.tile_bits, c.traverse.frac_bits) = (levels, self.tile_bits, self.frac_bits);
        // A map eight times as wide is eight times as far to walk; a ray that is stuck is stuck on any map.
        let wider = if self.nudge_bits == Some(0) { 0 } else { levels.saturating_sub(8).min(4) };
        c.traverse.step_limit = (self.step_limit << wider).min(65535);
        c.datapath = DatapathConfig::default();
        c.choose_datapath(self.kind);
        c.windows.set = self.windows;
        c.format.exp = self.exp.unwrap_or(c.format.exp);
        c.format.man = self.man.unwrap_or(c.format.man);
        c.datapath.nudge_bits = self.nudge_bits.unwrap_or(c.datapath.nudge_bits);
        c.datapath.fraction_bits = self.fraction_bits.unwrap_or(c.datapath.fraction_bits);
        c.datapath.reciprocal_bits = self.reciprocal_bits.unwrap_or(c.datapath.reciprocal_bits);
        c
    }

    /// The design on a map of 2^levels texels.
    ///
    /// # Errors
    /// Why there is none.
    pub fn design(&self, base: &Config, levels: u32) -> Result<Design> {
        let c = self.config(base, levels);
        c.validate()?;
        let design = c.design();
        prepare(&design)?;
        Ok(design)
    }

    /// Datapath and widths in a few words; fraction bits of the position where they are not the usual ones.
    pub fn label(&self) -> String {
        let usual = TraverseConfig::default().frac_bits;
        let position =
            if self.frac_bits == usual { String::new() } else { format!(", position to 2^-{}", self.frac_bits) };
        self.arithmetic() + &position
    }

    /// Datapath and widths of its arithmetic in a few words.
    fn arithmetic(&self) -> String {
        let datapath = DatapathConfig {
            kind: self.kind,
            search: Default::default(),
            nudge_bits: self.nudge_bits.unwrap_or(0),
            fraction_bits: self.fraction_bits.unwrap_or(0),
            reciprocal_bits: self.reciprocal_bits.unwrap_or(0),
        };
        datapath.arithmetic(FloatFormat::new(self.exp.unwrap_or(0), self.man.unwrap_or(0)))
    }

    /// How hits are found, in a few words: the mode, or the windows.
    pub fn way(&self) -> String {
        let by_node = || (self.kind.facts().way)(&self.mode, &WindowsConfig { set: self.windows });
        self.fetch.way(&self.mode).unwrap_or_else(by_node)
    }

    /// The same in a sentence.
    pub fn sentence(&self) -> String {
        let by_node = || (self.kind.facts().sentence)(&self.mode, &WindowsConfig { set: self.windows });
        self.fetch.sentence(&self.mode).unwrap_or_else(by_node)
    }

    /// Bits of a word of a ray's entry point.
    pub fn word_bits(&self) -> u32 {
        self.fraction_bits.unwrap_or(1 + self.exp.unwrap_or(0) + self.man.unwrap_or(0))
    }

    /// Cycles a ray needs beside its iterations: trips through the loop for its start.
    pub fn start_trips(&self) -> u32 {
        self.kind.start_trips(&self.mode)
    }

    /// Another mode of the same arithmetic.
    pub fn same_arithmetic(&self, other: &Self) -> bool {
        Self { mode: BEST, ..self.clone() } == Self { mode: BEST, ..other.clone() }
    }
}
