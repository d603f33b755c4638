//! What `synth` measured of whole traverse units, taken from its file: a design's area and clock.
use super::design::DesignSpec;
use super::select::configured;
use crate::config::{Config, DatapathConfig, ModeConfig, TraverseConfig};
use crate::error::{Error, Result};
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

#[derive(Deserialize)]
struct Entry {
    unit: String,
    target: String,
    luts: u64,
    multipliers: u64,
    clock: Option<Clock>,
    design: Design,
}

#[derive(Deserialize)]
struct Clock {
    median: f64,
}

#[derive(Deserialize)]
struct Design {
    exp: u32,
    man: u32,
    traverse: TraverseConfig,
    mode: ModeConfig,
    datapath: DatapathConfig,
}

impl Synthesized {
    /// The traverse units of a file that `synth` wrote.
    ///
    /// # Errors
    /// A file that can't be read, is no such file, or holds no clock of a traverse unit.
    pub fn load(path: &Path) -> Result<Vec<Self>> {
        let text = std::fs::read_to_string(path).map_err(|e| Error::file("read", path, e))?;
        let wrong = |e: serde_json::Error| Error::input(format!("{} is no file of `synth`: {e}", path.display()));
        let all: Vec<Entry> = serde_json::from_str(&text).map_err(wrong)?;
        let found: Vec<Self> = all.into_iter().filter(|e| e.unit == "traverse").filter_map(Self::of).collect();
        if found.is_empty() {
            let name = path.display();
            return Err(Error::input(format!(
                "{name} has no clock of a traverse unit: `synth --unit traverse` measures it"
            )));
        }
        Ok(found)
    }

    fn of(e: Entry) -> Option<Self> {
        let mut c = Config::default();
        (c.format.exp, c.format.man) = (e.design.exp, e.design.man);
        (c.traverse, c.mode, c.datapath) = (e.design.traverse, e.design.mode, e.design.datapath);
        let (design, levels, mhz) = (configured(&c), c.traverse.levels, e.clock?.median);
        Some(Self { design, levels, luts: e.luts, multipliers: e.multipliers, mhz, target: e.target })
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
