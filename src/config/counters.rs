//! Which counters a hit has.
use super::Design;
use serde::{Deserialize, Serialize};

/// The counters that `traverse` gives with each hit; what is not given has no port, no register and no column in the vectors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Counters {
    /// Iterations, node crossings and levels gone up, as far as the datapath has them.
    #[default]
    All,
    /// Iterations alone.
    Steps,
    /// None: iterations are counted inside of the loop for the step limit alone.
    None,
}

words!(Counters: All = "all", Steps = "steps", None = "none");

impl Design {
    /// A hit says its iterations.
    pub fn gives_steps(&self) -> bool {
        self.counters != Counters::None
    }

    /// A hit says its node crossings and the levels that it went up.
    pub fn gives_crossings(&self) -> bool {
        self.counters == Counters::All && self.datapath.kind.facts().counts_levels
    }

    /// The word of the choice where it leaves out what the datapath has.
    pub fn counters_left(&self) -> Option<&'static str> {
        let all = self.gives_steps() && self.gives_crossings() == self.datapath.kind.facts().counts_levels;
        (!all).then(|| self.counters.word())
    }
}
