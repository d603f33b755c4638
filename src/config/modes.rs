//! The modes that are compared, and the label of a mode: the one list of them, and the one place where a mode is put into words.
use super::{LevelUp, ModeConfig, Trim};

const fn published(start_level: bool, levels_down: u32, level_up: LevelUp) -> ModeConfig {
    ModeConfig {
        start_level,
        levels_down,
        levels_down_after: None,
        level_up,
        trim: Trim::None,
        lod: false,
        bilinear: false,
    }
}

/// The plain walk: from the root, one level down, never up.
pub const PLAIN: ModeConfig = published(false, 1, LevelUp::None);

/// The mode of the published unit: all three of its ideas.
pub const BEST: ModeConfig = published(true, 2, LevelUp::Selective);

/// Rows of the published table (PIDM-HW table 4): name and mode.
pub const PUBLISHED_ROWS: [(&str, ModeConfig); 7] = [
    ("PDM baseline [10]", PLAIN),
    ("Tevs [12]", published(false, 1, LevelUp::Tevs)),
    ("(a) start level", published(true, 1, LevelUp::None)),
    ("(b) two levels down", published(false, 2, LevelUp::None)),
    ("(c1) selective up", published(false, 1, LevelUp::Selective)),
    ("(c2) coherent up", published(false, 1, LevelUp::Coherent)),
    ("a + b + c1", BEST),
];

/// The modes of the published table.
pub fn published_rows() -> impl Iterator<Item = ModeConfig> {
    PUBLISHED_ROWS.into_iter().map(|row| row.1)
}

/// [`BEST`] with each chord trim: fewer iterations than published.
pub fn trimmed() -> impl Iterator<Item = ModeConfig> {
    Trim::ALL.into_iter().filter(|trim| *trim != Trim::None).map(|trim| ModeConfig { trim, ..BEST })
}

/// The plain walk with more levels down than any row of the published table has.
pub fn deeper() -> impl Iterator<Item = ModeConfig> {
    (3..=4).map(|levels_down| ModeConfig { levels_down, ..PLAIN })
}

/// Every combination of start level, levels down and level-up rule with each of `trims`, all else as in `base`: 40 a trim; the first one is the
/// plain walk.
pub fn combinations(base: ModeConfig, trims: &[Trim]) -> Vec<ModeConfig> {
    let mut out = Vec::new();
    for &trim in trims {
        for start_level in [false, true] {
            for levels_down in 1..=4 {
                let mode = |level_up| ModeConfig { start_level, levels_down, level_up, trim, ..base };
                out.extend(LevelUp::ALL.map(mode));
            }
        }
    }
    out
}

impl ModeConfig {
    /// Every key of the mode that has a value, with that value as the configuration writes it, without quotes.
    pub fn words(&self) -> Vec<(String, String)> {
        let table = toml::Table::try_from(self).expect("a mode is a table");
        let word = |value: toml::Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        table.into_iter().map(|(key, value)| (key, word(value))).collect()
    }

    /// The mode in a few words: that of the published table where it has one. Level of detail and refinement are not said: they choose another
    /// answer, not another way to it.
    pub fn label(&self) -> String {
        let plain = Self { trim: Trim::None, lod: false, bilinear: false, ..*self };
        let named = PUBLISHED_ROWS.iter().find(|(_, row)| *row == plain).map(|(name, _)| (*name).to_owned());
        let name = named.unwrap_or_else(|| {
            let start = if self.start_level { "start level" } else { "from root" };
            format!("{start}, {} down, up {}", self.levels_down, self.level_up.word())
        });
        match self.trim {
            Trim::None => name,
            trim => format!("{name} + trim {}", trim.word()),
        }
    }

    /// The mode in a sentence: what it does, without the names of the published rows.
    pub fn sentence(&self) -> String {
        let start = if self.start_level {
            "starts at the lowest level whose node holds the whole ray"
        } else {
            "starts at the root"
        };
        let down =
            ["one level", "two levels", "three levels", "four levels"][(self.levels_down.clamp(1, 4) - 1) as usize];
        let down = if self.levels_down == 1 {
            format!("{down} down a descent")
        } else {
            format!("{down} down a descent until the first crossing")
        };
        let up = match self.level_up {
            LevelUp::None => "never up a level",
            LevelUp::Tevs => "up a level when a crossing leaves the parent node",
            LevelUp::Selective => {
                "up a level when a crossing leaves the parent node and the predicted hit is not in a neighbouring node"
            }
            LevelUp::Coherent => "up a level on the second crossing in a row",
            LevelUp::Always => "up a level on every crossing",
        };
        let trim = match self.trim {
            Trim::None => "",
            Trim::Descent => "; after a descent, chord trim to the smallest node that holds the rest of the ray in it",
            Trim::Always => "; always chord trim to the smallest node that holds the rest of the ray in it",
        };
        format!("{start}; {down}; {up}{trim}")
    }
}
