//! `datapath.kind = "fixed"` with `datapath.search = "windows"` (`docs/windows.md`).
use super::facts::{DatapathFacts, Reads};
use super::fixed;
use crate::modes::BEST;
use crate::windows::ignored;
use crate::{Config, DatapathConfig, DatapathKind, Design, ModeConfig, Trim, WindowSet, WindowsConfig};
use reliefrtl_base::format::FloatFormat;

pub(super) const FACTS: DatapathFacts = DatapathFacts {
    word: "windows",
    chosen_by: &[("datapath.kind", "fixed"), ("datapath.search", "windows")],
    reads: Reads { window_set: true, ..fixed::FACTS.reads },
    reads_nodes: false,
    counts_levels: false,
    short_loop: true,
    has_trim: false,
    trim_fits: |_| false,
    has_lod: false,
    has_blocks: false,
    limits: &[fixed::widths, set, ignored],
    ignores: &[
        ("mode.start_level", "has no levels to start on"),
        ("mode.levels_down", "has no levels to descend"),
        ("mode.levels_down_after", "has no levels to descend"),
        ("mode.level_up", "has no levels to go up"),
        ("mode.trim", "has no nodes to trim"),
        ("mode.lod", "has no level of detail"),
        ("fetch.", "reads every window in one iteration"),
    ],
    forget: |c| c.mode = ModeConfig { bilinear: c.mode.bilinear, ..ModeConfig::default() },
    arithmetic,
    label: |d| format!("{}, {}", d.datapath.arithmetic(d.format), d.window_set()),
    way,
    sentence,
    has_mode: |mode| *mode == BEST,
    ways,
    searches: |_| Vec::new(),
    reference,
    settled: |d| Design { windows: WindowsConfig { set: Some(d.window_set()) }, ..*d },
    // The texel is wrapped, as the memories see it.
    nets: &["t", "texel_x", "texel_y", "m"],
    ..fixed::FACTS
};

/// As that of the pyramid, with the search's name.
fn arithmetic(path: &DatapathConfig, format: FloatFormat) -> String {
    (fixed::FACTS.arithmetic)(path, format).replacen("fixed", "windows", 1)
}

/// The set, where it is known.
fn way(_: &ModeConfig, windows: &WindowsConfig) -> String {
    windows.set.map_or_else(|| "windows".to_owned(), |set| format!("windows {set}"))
}

/// The same in a sentence.
fn sentence(_: &ModeConfig, windows: &WindowsConfig) -> String {
    let of = windows.set.map_or_else(String::new, |set| format!(" ({set})"));
    format!(
        "reads all windows ahead of the ray{of} in one iteration, and goes on to the farthest place that one of them proves empty"
    )
}

/// The pyramid's own search, and every set that has a name.
fn ways(d: &Design, _: &[Trim]) -> Vec<Design> {
    let sets = WindowSet::named().into_iter().filter(|set| set.misfit(d.traverse.levels).is_none());
    let sets = sets.map(|set| Design { windows: WindowsConfig { set: Some(set) }, ..*d });
    [*d, reference(d)].into_iter().chain(sets).collect()
}

/// The same numbers with a search in the pyramid.
fn reference(d: &Design) -> Design {
    Design { datapath: DatapathConfig { kind: DatapathKind::Fixed, ..d.datapath }, ..*d }
}

/// What the map's size asks of the set.
fn set(c: &Config, problems: &mut Vec<String>) {
    let set = c.windows.at(c.traverse.levels);
    problems.extend(set.misfit(c.traverse.levels).map(|problem| format!("windows.set = \"{set}\" {problem}")));
}
