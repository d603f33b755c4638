//! The table of the datapaths.
use super::facts::DatapathFacts;
use super::kind::{DatapathConfig, DatapathKind};
use super::{fixed, published, watertight, windows};
use crate::{Design, ModeConfig, Trim, WindowSet};
use reliefrtl_base::format::{FloatFormat, Words};

impl DatapathKind {
    /// All.
    pub const ALL: [Self; 3] = [Self::Watertight, Self::Published, Self::Fixed];

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
        let facts = self.facts();
        (if facts.windows { "datapath.search" } else { "datapath.kind" }, facts.word)
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

impl DatapathConfig {
    /// Datapath and widths in a few words; `format` is that of a floating-point one.
    pub fn label(&self, format: FloatFormat) -> String {
        (self.kind.facts().label)(self, format)
    }
}

impl Design {
    /// The numbers of a ray.
    pub fn words(&self) -> Words {
        (self.datapath.kind.facts().words)(self)
    }

    /// Datapath and widths in a few words; of a search by windows its set, too.
    pub fn label(&self) -> String {
        let label = self.datapath.label(self.format);
        if self.datapath.kind.facts().windows { format!("{label}, {}", self.window_set()) } else { label }
    }

    /// The windows of a search by windows.
    pub fn window_set(&self) -> WindowSet {
        self.windows.at(self.traverse.levels)
    }

    /// The same with a search in the pyramid, if it searches by windows.
    pub fn by_pyramid(&self) -> Self {
        if !self.datapath.kind.facts().windows {
            return *self;
        }
        Self { datapath: DatapathConfig { kind: DatapathKind::Fixed, ..self.datapath }, ..*self }
    }

    /// The chord trims that datapath and number format have.
    pub fn trims(&self) -> &'static [Trim] {
        let facts = self.datapath.kind.facts();
        if facts.trim && (facts.trim_fits)(self.format) { &Trim::ALL } else { &[Trim::None] }
    }
}
