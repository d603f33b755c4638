//! `datapath.kind = "published"` (`docs/published.md`): as it was published, without chord trim and level of detail.
use super::facts::{DatapathFacts, Reads};
use super::{float, pyramid};
use crate::{Config, Trim};

pub(super) const FACTS: DatapathFacts = DatapathFacts {
    word: "published",
    chosen_by: &[("datapath.kind", "published")],
    reads: Reads { format: true, nudge_bits: true, fraction_bits: false, window_set: false },
    words: float::words,
    divides_in_loop: true,
    start_trip: true,
    rays_end: false,
    modes_agree: false,
    reads_nodes: true,
    counts_levels: true,
    short_loop: false,
    has_trim: false,
    trim_fits: |_| false,
    has_lod: false,
    has_blocks: false,
    has_bilinear: false,
    clock_by_units: false,
    from_fixed: |d| (d.traverse.idx_bits() + d.datapath.nudge_bits + 1, d.datapath.nudge_bits),
    limits: &[float::widths, nudged_plane, pyramid::no_windows],
    ignores: &[],
    forget: pyramid::forget,
    arithmetic: |path, f| match path.nudge_bits {
        0 => format!("published {}/{}, no nudge", f.exp, f.man),
        n => format!("published {}/{}, nudge 2^-{n}", f.exp, f.man),
    },
    label: pyramid::label,
    way: pyramid::way,
    sentence: pyramid::sentence,
    has_mode: |mode| matches!(mode.trim, Trim::None),
    ways: pyramid::ways,
    searches: |_| Vec::new(),
    reference: |d| *d,
    settled: |d| *d,
    nets: NETS,
    ladder: float::ladder,
    narrower: |_| None,
};

/// Nets of an iteration that moves positions.
const NETS: &[&str] = &[
    "level",
    "x",
    "y",
    "t",
    "x_plane",
    "y_plane",
    "height",
    "m",
    "t_x",
    "t_y",
    "level_next",
    "t_after",
    "x_next",
    "y_next",
];

/// A nudged plane is converted in one word (`docs/published.md`, Parameters).
fn nudged_plane(c: &Config, problems: &mut Vec<String>) {
    let (index, nudge, man) = (c.traverse.idx_bits(), c.datapath.nudge_bits, c.format.man);
    if index + nudge + man > 60 {
        problems.push(format!(
            "datapath.nudge_bits = {nudge} is too large for a texel coordinate of {index} bits and format.man = {man}: levels + tile_bits + 2 + nudge_bits + man = {} may be at most 60",
            index + nudge + man
        ));
    }
}
