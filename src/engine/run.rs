//! What an engine does: it replays the vectors of a unit, and it traces rays.
use crate::config::{Config, Design};
use crate::error::{Error, Result};
use crate::golden::{Pyramid, RayHit, RayInput};
use crate::ir::{Binding, Module};
use crate::process;
use crate::vectors::VectorSet;
use serde::Serialize;
use std::path::Path;
use std::time::Duration;

/// A unit's vector set, and where it comes from.
pub struct Replay<'a> {
    /// The configured design.
    pub design: &'a Design,
    /// The emitted tree.
    pub tree: &'a Path,
    /// The unit.
    pub unit: &'a Module,
    /// Directory of the vectors.
    pub place: &'a Path,
    /// Parameter values that are not the configured ones.
    pub over: &'a Binding,
    /// The vectors.
    pub set: &'a VectorSet,
    /// Whether the set is not that of the directory any more: a fault was put into it.
    pub spoiled: bool,
}

/// How busy the slots of the loop were, of `traverse`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct SlotLoad {
    /// Clocks under full load in which the slot of stage 0 held a ray.
    pub busy: u64,
    /// Clocks under full load.
    pub loaded: u64,
    /// Clocks from the first ray to the last hit.
    pub clocks: u64,
}

impl SlotLoad {
    /// From the line that a bench prints of it.
    pub fn read(line: &str) -> Option<Self> {
        let mut numbers = line.split_whitespace().filter_map(|word| word.parse().ok());
        Some(Self { busy: numbers.next()?, loaded: numbers.next()?, clocks: numbers.next()? })
    }
}

/// One unit's result.
#[derive(Clone, Debug)]
pub struct Checked {
    /// Unit.
    pub unit: String,
    /// Rows compared.
    pub rows: usize,
    /// A line that the engine printed beside the verdict (slots busy).
    pub note: String,
    /// The same as numbers.
    pub slots: Option<SlotLoad>,
}

/// The same as figures: what `--json` prints of a unit.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct CheckedFigures<'a> {
    /// Unit.
    pub unit: &'a str,
    /// Rows compared.
    pub checked: usize,
    /// Rows that differ: none, as a difference is an error.
    pub mismatched: usize,
    /// How full the slots of the loop were.
    pub slots: Option<SlotLoad>,
}

impl<'a> From<&'a Checked> for CheckedFigures<'a> {
    fn from(c: &'a Checked) -> Self {
        Self { unit: &c.unit, checked: c.rows, mismatched: 0, slots: c.slots }
    }
}

/// Rays that were traced.
#[derive(Clone, Debug)]
pub struct Traced {
    /// A hit for each ray, in their order.
    pub hits: Vec<RayHit>,
    /// Time until the engine could run.
    pub build: Duration,
    /// Time of the run.
    pub run: Duration,
}

/// What runs the datapath.
pub trait Engine: Sync {
    /// Name as on the command line.
    fn name(&self) -> &'static str;

    /// Programs that must be installed.
    fn needs(&self) -> Vec<String>;

    /// Whether they are.
    ///
    /// # Errors
    /// [`Error::ToolMissing`] with the first that is not.
    fn installed(&self) -> Result<()> {
        let needs = self.needs();
        let missing = |p: &String| {
            Error::ToolMissing(format!("{p} is not installed: {} needs {}", self.name(), needs.join(" and ")))
        };
        needs.iter().find(|program| !process::starts(program)).map_or(Ok(()), |p| Err(missing(p)))
    }

    /// Whether it runs the emitted text; the others run what the text is printed from.
    fn reads_text(&self) -> bool;

    /// Replays the vectors of a unit.
    ///
    /// # Errors
    /// The first difference; a result that never came, or one too many; an engine that can't judge.
    fn replay(&self, replay: &Replay<'_>) -> Result<Checked>;

    /// Traces rays through the design of a configuration.
    ///
    /// # Errors
    /// Of a simulator: it is not installed, or disagrees with the golden model.
    fn trace(&self, c: &Config, pyramid: &Pyramid, rays: &[RayInput]) -> Result<Traced>;
}

#[cfg(test)]
mod tests {
    use super::SlotLoad;

    #[test]
    fn a_load_is_read() {
        let line = "slots busy: 90 of 100 under full load; 250 clocks from first ray to last hit";
        assert_eq!(SlotLoad::read(line), Some(SlotLoad { busy: 90, loaded: 100, clocks: 250 }));
        assert_eq!(SlotLoad::read(""), None);
    }
}
