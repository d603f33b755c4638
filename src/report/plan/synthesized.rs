//! What `synth` measured, taken from its file: figures of every unit, and of whole traverse units a design's area and clock.
use super::design::DesignSpec;
use super::select::configured;
use crate::config::{Config, DatapathConfig, ModeConfig, TraverseConfig};
use crate::error::{Error, Result};
use crate::files::{TABLE, read_named_text};
use serde::Deserialize;
use std::path::Path;

/// Area and clock of a design.
#[derive(Clone, Debug, PartialEq)]
pub struct Synthesized {
    /// The design.
    design: DesignSpec,
    /// log2 of the side of its map.
    levels: u32,
    /// Look-up tables.
    pub luts: u64,
    /// Multiplier blocks.
    pub multipliers: u64,
    /// Clock in MHz, the median of the placer's seeds.
    pub mhz: f64,
    /// What it was placed on.
    pub target: String,
}

/// What was measured of one unit at one latency.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct UnitFigures {
    /// Unit, or another project's module.
    pub unit: String,
    /// Clocks from operand to result; none for a handshaked unit.
    #[serde(default)]
    pub latency: Option<u32>,
    /// What it was mapped to.
    pub target: String,
    /// Look-up tables.
    pub luts: u64,
    /// Carry cells.
    #[serde(default)]
    pub carries: u64,
    /// Multiplier blocks.
    pub multipliers: u64,
    /// Block memories.
    #[serde(default)]
    pub memories: u64,
    /// Flip-flops, the ranks around the unit included.
    #[serde(default)]
    pub flip_flops: u64,
    /// Clock, where it was placed and routed.
    pub clock: Option<Clock>,
    #[serde(default)]
    design: Option<Design>,
}

/// The clock of a placed and routed unit.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Clock {
    /// MHz, the median of the placer's seeds.
    pub median: f64,
    /// The slowest path.
    #[serde(default)]
    pub critical: Ends,
}

/// The two ends of a path, in names of the emitted text.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct Ends {
    /// Where it begins.
    pub from: String,
    /// Where it ends.
    pub to: String,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
struct Design {
    exp: u32,
    man: u32,
    traverse: TraverseConfig,
    mode: ModeConfig,
    datapath: DatapathConfig,
}

/// The units of a file that `synth` wrote.
///
/// # Errors
/// A file that can't be read, is no such file, or holds no unit.
pub fn load(path: &Path) -> Result<Vec<UnitFigures>> {
    let text = read_named_text(path, TABLE)?;
    let wrong = |e: serde_json::Error| Error::input(format!("{} is no file of `synth`: {e}", path.display()));
    let all: Vec<UnitFigures> = serde_json::from_str(&text).map_err(wrong)?;
    if all.is_empty() {
        let name = path.display();
        return Err(Error::input(format!("{name} has no figures of a unit: `synth` measures them")));
    }
    Ok(all)
}

impl Synthesized {
    /// The design of one of these traverse units that was placed and routed.
    pub fn of(e: &UnitFigures, traversals: &[&str]) -> Option<Self> {
        let (design, clock) = (e.design.as_ref()?, e.clock.as_ref()?);
        if !traversals.contains(&e.unit.as_str()) {
            return None;
        }
        let mut c = Config::default();
        (c.format.exp, c.format.man) = (design.exp, design.man);
        (c.traverse, c.mode, c.datapath) = (design.traverse, design.mode, design.datapath);
        let (design, levels, mhz) = (configured(&c), c.traverse.levels, clock.median);
        Some(Self { design, levels, luts: e.luts, multipliers: e.multipliers, mhz, target: e.target.clone() })
    }

    /// True if this is the design on maps of this size; the step limit is a counter's compare value, and no matter of size.
    pub fn is(&self, d: &DesignSpec, levels: u32) -> bool {
        let same = DesignSpec { step_limit: d.step_limit, ..self.design.clone() };
        self.levels == levels && same == *d
    }

    /// Look-up tables times nanoseconds a ray: area-delay product of one ray.
    pub fn area_time(&self, cycles: f64) -> f64 {
        self.luts as f64 * self.nanoseconds(cycles)
    }

    /// Nanoseconds a ray.
    pub fn nanoseconds(&self, cycles: f64) -> f64 {
        1000.0 * cycles / self.mhz
    }
}
