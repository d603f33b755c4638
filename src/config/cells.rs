//! The modes of four cells an iteration (`docs/cells.md`): what they are called, which there are, which are refused.
use super::modes::combinations;
use super::{Config, Design, FetchConfig, LevelUp, ModeConfig, Trim, datapaths};

impl FetchConfig {
    /// Levels of a descent after the first crossing: of four cells two where nothing else is asked for.
    pub fn levels_down_after(self, mode: &ModeConfig) -> u32 {
        mode.levels_down_after.unwrap_or(if self.blocks() { 2 } else { 1 })
    }

    /// A mode with four cells in a few words; `None` with one.
    pub fn way(self, mode: &ModeConfig) -> Option<String> {
        let start = if mode.start_level { "start level" } else { "from root" };
        let (down, after) = (mode.levels_down, self.levels_down_after(mode));
        let trim = if mode.trim == Trim::None { String::new() } else { format!(" + trim {}", mode.trim) };
        self.blocks().then(|| format!("four cells, {start}, {down} then {after} down, up {}{trim}", mode.level_up))
    }

    /// The same in a sentence, without its subject.
    pub fn sentence(self, mode: &ModeConfig) -> Option<String> {
        let after = self.levels_down_after(mode);
        let told =
            || format!("{}; after that crossing {after} down; four siblings are judged at once", mode.sentence());
        self.blocks().then(told)
    }
}

/// Levels per descent that four cells allow.
const DOWN: std::ops::RangeInclusive<u32> = 1..=3;
/// Level-up rules that they allow.
const UP: [LevelUp; 2] = [LevelUp::Tevs, LevelUp::Selective];
/// The chord trim that they do not have.
const NO_TRIM: Trim = Trim::Descent;

/// Whether start level, levels down, level-up rule and trim of a mode are such that four cells have it.
fn is_block_mode(mode: &ModeConfig) -> bool {
    DOWN.contains(&mode.levels_down) && UP.contains(&mode.level_up) && mode.trim != NO_TRIM
}

impl Design {
    /// [`FetchConfig::levels_down_after`].
    pub fn levels_down_after(&self) -> u32 {
        self.fetch.levels_down_after(&self.mode)
    }

    /// The coarsest level whose cells are read: with four cells at once the root is never looked at.
    pub const fn top_level(&self) -> u32 {
        self.traverse.levels - if self.fetch.blocks() { 1 } else { 0 }
    }

    /// Every combination of start level, levels down before and after the first crossing and level-up rule that four cells allow, with each of `trims`
    /// that they allow, all else as in the design: 36 a trim.
    pub fn block_modes(&self, trims: &[Trim]) -> Vec<ModeConfig> {
        let with_after =
            |mode: ModeConfig| DOWN.map(move |after| ModeConfig { levels_down_after: Some(after), ..mode });
        let mut out: Vec<ModeConfig> =
            combinations(self.mode, trims).into_iter().filter(is_block_mode).flat_map(with_after).collect();
        // By levels down first: of ways that are equally short, the one before counts.
        out.sort_by_key(|m| {
            (trims.iter().position(|t| *t == m.trim), m.levels_down, m.start_level, m.levels_down_after)
        });
        out
    }
}

impl Config {
    /// `mode.levels_down` where it is not given.
    pub(super) fn usual_levels_down(&self) -> u32 {
        let facts = self.datapath.kind.facts();
        if self.fetch.blocks() && facts.has_blocks { 3 } else { ModeConfig::default().levels_down }
    }

    /// Levels down follow the cells where they are not given; `before` is what they usually were.
    pub(super) fn follow_cells(&mut self, before: u32) {
        let usual = self.usual_levels_down();
        if usual != before && self.mode.levels_down == before && !self.given.has("mode.levels_down") {
            self.mode.levels_down = usual;
        }
    }

    /// What four cells at once, and what one, do not have.
    pub(super) fn fetch_problems(&self, problems: &mut Vec<String>) {
        let (path, mode) = (self.datapath.kind.facts(), &self.mode);
        if path.ignores("fetch.cells") {
            // Each key was refused by name.
            return;
        }
        if !self.fetch.blocks() {
            problems.extend(mode.levels_down_after.filter(|after| *after != 1).map(|after| {
                format!(
                    "mode.levels_down_after = {after} and fetch.cells = 1 exclude each other: with one cell a descent after the first crossing goes one level down, so set fetch.cells = 4 or leave the key out"
                )
            }));
            return;
        }
        let cells = format!("fetch.cells = {}", self.fetch.cells);
        if !path.has_blocks {
            let having = datapaths().filter(|k| k.facts().has_blocks).map(|k| format!("\"{}\"", k.word()));
            problems.push(format!(
                "{cells} and datapath.kind = \"{}\" exclude each other: four cells need datapath.kind = {}",
                path.word,
                having.collect::<Vec<_>>().join(" or ")
            ));
            return;
        }
        let mut refuse = |key: &str, shown: String, legal: &str| {
            problems.push(format!("{key} = {shown} and {cells} exclude each other: with four cells {legal}"));
        };
        if !UP.contains(&mode.level_up) {
            refuse("mode.level_up", format!("\"{}\"", mode.level_up), "\"selective\" and \"tevs\" are legal");
        }
        if mode.trim == NO_TRIM {
            refuse("mode.trim", format!("\"{}\"", mode.trim), "\"none\" and \"always\" are legal");
        }
        if !DOWN.contains(&mode.levels_down) {
            refuse("mode.levels_down", mode.levels_down.to_string(), "1 to 3 are legal");
        }
        if mode.bilinear {
            refuse("mode.bilinear", "true".to_owned(), "hits are not refined");
        }
    }
}
