//! `datapath.kind = "published"` (`docs/published.md`): as it was published, without chord trim and level of detail.
use super::facts::{DatapathFacts, Reads};
use super::float;
use crate::Config;

pub(super) const FACTS: DatapathFacts = DatapathFacts {
    word: "published",
    reads: Reads { format: true, nudge_bits: true, fraction_bits: false },
    words: float::words,
    steps_indices: false,
    divides_in_loop: true,
    start_trip: true,
    modes_agree: false,
    windows: false,
    trim: false,
    trim_fits: |_| false,
    lod: false,
    bilinear: false,
    clock_by_units: false,
    from_fixed: |d| (d.traverse.idx_bits() + d.datapath.nudge_bits + 1, d.datapath.nudge_bits),
    limits: &[float::widths, nudged_plane],
    label: |path, f| match path.nudge_bits {
        0 => format!("published {}/{}, no nudge", f.exp, f.man),
        n => format!("published {}/{}, nudge 2^-{n}", f.exp, f.man),
    },
    ladder: float::ladder,
    narrower: |_| None,
};

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
