//! What the datapaths have in common that search nodes of the height pyramid.
use crate::modes::combinations;
use crate::{Config, Design, ModeConfig, Trim, WindowsConfig};

/// Nets of an iteration that steps texel indices over planes.
pub(super) const PLANE_NETS: &[&str] = &[
    "level",
    "x",
    "y",
    "t",
    "x_plane",
    "y_plane",
    "x_chord",
    "y_chord",
    "level_read",
    "height",
    "m",
    "t_x",
    "t_y",
    "x_hit",
    "y_hit",
];

/// Datapath and widths in a few words.
pub(super) fn label(d: &Design) -> String {
    d.datapath.arithmetic(d.format)
}

/// How hits are found: the mode.
pub(super) fn way(mode: &ModeConfig, _: &WindowsConfig) -> String {
    mode.label()
}

/// The same in a sentence.
pub(super) fn sentence(mode: &ModeConfig, _: &WindowsConfig) -> String {
    mode.sentence()
}

/// Every mode with one of these trims; of four cells at once those that they have, and one cell at a time.
pub(super) fn ways(d: &Design, trims: &[Trim]) -> Vec<Design> {
    if d.fetch.blocks() {
        let one = Design { fetch: Default::default(), mode: ModeConfig { levels_down_after: None, ..d.mode }, ..*d };
        let modes = d.block_modes(trims).into_iter().map(|mode| Design { mode, ..*d });
        return [*d, one].into_iter().chain(modes).collect();
    }
    combinations(d.mode, trims).into_iter().map(|mode| Design { mode, ..*d }).collect()
}

/// There are no windows.
pub(super) fn forget(c: &mut Config) {
    c.windows = WindowsConfig::default();
}

/// A set of windows is given, but none is searched.
pub(super) fn no_windows(c: &Config, problems: &mut Vec<String>) {
    // A search by windows that the datapath does not have is refused by its own name.
    if let (true, Some(set)) = (c.datapath.search == Default::default(), c.windows.set) {
        problems.push(format!(
            "windows.set = \"{set}\" is given, but the pyramid has no windows: set datapath.kind = \"fixed\" and datapath.search = \"windows\", or leave it out"
        ));
    }
}
