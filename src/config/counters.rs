//! Which counters a hit has.
use super::{Counters, Design};

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
