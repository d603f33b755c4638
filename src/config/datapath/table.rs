//! The table of the datapaths.
use super::facts::DatapathFacts;
use super::kind::{DatapathConfig, DatapathKind};
use super::{fixed, published, watertight, windows};
use crate::{Design, ModeConfig, Trim, WindowSet, WindowsConfig};
use reliefrtl_base::format::{FloatFormat, Words};

impl DatapathKind {
    /// Those of different arithmetic.
    pub const ALL: [Self; 3] = [Self::Watertight, Self::Published, Self::Fixed];
    /// The same with every search that one of them has.
    pub const WITH_SEARCHES: [Self; 4] = [Self::Watertight, Self::Published, Self::Fixed, Self::Windows];

    /// What is known of it.
    pub const fn facts(self) -> &'static DatapathFacts {
        match self {
            Self::Watertight => &watertight::FACTS,
            Self::Published => &published::FACTS,
            Self::Fixed => &fixed::FACTS,
            Self::Windows => &windows::FACTS,
        }
    }

    /// The word in the TOML file and on the command line.
    pub const fn word(self) -> &'static str {
        self.facts().word
    }

    /// The key that chooses it, and the word there.
    pub const fn chosen_by(self) -> (&'static str, &'static str) {
        let keys = self.facts().chosen_by;
        keys[keys.len() - 1]
    }

    /// Trips of a ray through the loop that are no iterations.
    pub const fn start_trips(self, mode: &ModeConfig) -> u32 {
        (self.facts().start_trip && mode.start_level) as u32
    }
}

impl std::str::FromStr for DatapathKind {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        let names = || Self::ALL.map(Self::word).join(", ");
        Self::ALL.into_iter().find(|k| k.word() == word).ok_or_else(|| format!("{word:?} is not one of {}", names()))
    }
}

/// Every datapath in the order of tables and pages: first those whose hits are the same in every mode.
pub fn datapaths() -> impl Iterator<Item = DatapathKind> {
    let agree = |agree| DatapathKind::ALL.into_iter().filter(move |k| k.facts().modes_agree == agree);
    agree(true).chain(agree(false))
}

/// Every datapath with each search that it has.
pub fn searches() -> impl Iterator<Item = DatapathKind> {
    DatapathKind::WITH_SEARCHES.into_iter()
}

impl DatapathConfig {
    /// Arithmetic and widths in a few words; `format` is that of a floating-point one.
    pub fn arithmetic(&self, format: FloatFormat) -> String {
        (self.kind.facts().arithmetic)(self, format)
    }
}

impl Design {
    /// The numbers of a ray.
    pub fn words(&self) -> Words {
        (self.datapath.kind.facts().words)(self)
    }

    /// Datapath and widths in a few words.
    pub fn label(&self) -> String {
        (self.datapath.kind.facts().label)(self)
    }

    /// How hits are found, in a few words: the mode, or the windows.
    pub fn way(&self) -> String {
        if let Some(way) = self.fetch.way(&self.mode) {
            return way;
        }
        let windows = WindowsConfig { set: Some(self.window_set()) };
        (self.datapath.kind.facts().way)(&self.mode, &windows)
    }

    /// Other designs of the same datapath and widths that must find the same hits: every mode with one of `trims`, or every set of windows that has a
    /// name and the pyramid's own search.
    pub fn ways(&self, trims: &[Trim]) -> Vec<Self> {
        (self.datapath.kind.facts().ways)(self, trims)
    }

    /// The windows of a search by windows.
    pub fn window_set(&self) -> WindowSet {
        self.windows.at(self.traverse.levels)
    }

    /// The design whose hits it must equal: of a search by windows, that of the pyramid.
    pub fn reference(&self) -> Self {
        (self.datapath.kind.facts().reference)(self)
    }

    /// The same with all written out that the emitted text holds fast, whatever its parameters are.
    pub fn settled(&self) -> Self {
        (self.datapath.kind.facts().settled)(self)
    }

    /// The chord trims that datapath and number format have.
    pub fn trims(&self) -> &'static [Trim] {
        let facts = self.datapath.kind.facts();
        if facts.has_trim && (facts.trim_fits)(self.format) { &Trim::ALL } else { &[Trim::None] }
    }
}
