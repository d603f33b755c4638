//! `datapath.kind = "fixed"` (`docs/fixed.md`).
use super::facts::{DatapathFacts, Reads};
use super::{by_windows, float, pyramid};
use crate::{Config, DatapathConfig, Design};
use reliefrtl_base::format::Words;

/// The narrowest fraction, and the narrowest reciprocal.
const LEAST: u32 = 8;

pub(super) const FACTS: DatapathFacts = DatapathFacts {
    word: "fixed",
    chosen_by: &[("datapath.kind", "fixed")],
    reads: Reads { format: false, nudge_bits: false, fraction_bits: true, window_set: false },
    words: |d| Words::Fixed {
        fraction_bits: d.datapath.fraction_bits,
        travel_bits: d.datapath.fraction_bits + d.traverse.tile_bits + 1,
    },
    divides_in_loop: false,
    start_trip: false,
    rays_end: true,
    modes_agree: true,
    reads_nodes: true,
    counts_levels: true,
    short_loop: false,
    has_trim: true,
    trim_fits: |_| true,
    has_lod: true,
    has_blocks: true,
    has_bilinear: false,
    clock_by_units: false,
    from_fixed: float::hit_word,
    limits: &[widths, pyramid::no_windows],
    ignores: &[],
    forget: pyramid::forget,
    arithmetic: |path, _| {
        let (f, r) = (path.fraction_bits, path.reciprocal_bits);
        // Usually the reciprocal is as wide.
        if f.max(LEAST) == r { format!("fixed Q.{f}") } else { format!("fixed Q.{f}, reciprocal {r}") }
    },
    label: pyramid::label,
    way: pyramid::way,
    sentence: pyramid::sentence,
    has_mode: |_| true,
    ways: pyramid::ways,
    searches: by_windows::searches,
    reference: |d| *d,
    settled: |d| *d,
    nets: pyramid::PLANE_NETS,
    ladder,
    narrower: |d| {
        let bits = d.datapath.reciprocal_bits;
        let path = DatapathConfig { reciprocal_bits: bits.saturating_sub(1), ..d.datapath };
        (bits > LEAST).then_some(Design { datapath: path, ..*d })
    },
};

/// Every fraction width with a reciprocal as wide.
fn ladder(d: &Design) -> Vec<Vec<Design>> {
    let at = |bits: u32| {
        let datapath = DatapathConfig { fraction_bits: bits, reciprocal_bits: bits, ..d.datapath };
        vec![Design { datapath, ..*d }]
    };
    (LEAST..=28).map(at).collect()
}

/// The bounds that keep every intermediate result inside its width (`docs/fixed.md`, Parameters).
pub(super) fn widths(c: &Config, problems: &mut Vec<String>) {
    let (f, w) = (c.datapath.fraction_bits, c.datapath.reciprocal_bits);
    let (levels, height, tiles) = (c.traverse.levels, c.traverse.height_bits, c.traverse.tile_bits);
    let mut most = |what: &str, value: u32, why: &str, limit: u32| {
        if value > limit {
            problems.push(format!("{what} = {value} is too large: {why} may be at most {limit}"));
        }
    };
    most("traverse.levels", levels, "with datapath.fraction_bits a texel's corner is exact, so it", f);
    most("traverse.height_bits", height, "with datapath.fraction_bits a height code is exact, so it", f);
    let index = c.traverse.idx_bits();
    most("traverse.levels + traverse.tile_bits + 2", index, "a texel coordinate", 24);
    most("datapath.fraction_bits + traverse.tile_bits", f + tiles, "a travel's magnitude", 32);
    let product = f + tiles + w;
    most("datapath.fraction_bits + traverse.tile_bits + datapath.reciprocal_bits", product, "their sum", 63);
}
