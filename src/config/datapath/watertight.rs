//! `datapath.kind = "watertight"` (`docs/datapath.md`).
use super::facts::{DatapathFacts, Reads};
use super::{float, pyramid};
use crate::{Config, Trim};
use reliefrtl_base::format::FloatFormat;

pub(super) const FACTS: DatapathFacts = DatapathFacts {
    word: "watertight",
    chosen_by: &[("datapath.kind", "watertight")],
    reads: Reads { format: true, nudge_bits: false, fraction_bits: false, window_set: false },
    words: float::words,
    divides_in_loop: false,
    start_trip: false,
    rays_end: true,
    modes_agree: true,
    reads_nodes: true,
    counts_levels: true,
    short_loop: false,
    has_trim: true,
    trim_fits,
    has_lod: true,
    has_blocks: true,
    has_bilinear: true,
    clock_by_units: true,
    from_fixed: float::hit_word,
    limits: &[float::widths, trim_exponents, pyramid::no_windows],
    ignores: &[],
    forget: pyramid::forget,
    arithmetic: |_, f| format!("watertight {}/{}", f.exp, f.man),
    label: pyramid::label,
    way: pyramid::way,
    sentence: pyramid::sentence,
    has_mode: |_| true,
    ways: pyramid::ways,
    searches: |_| Vec::new(),
    reference: |d| *d,
    settled: |d| *d,
    nets: pyramid::PLANE_NETS,
    ladder: float::ladder,
    narrower: |_| None,
};

/// A chord's end is estimated forward by more than all errors, underflow included.
fn trim_fits(f: FloatFormat) -> bool {
    i64::from(f.man) + 4 <= i64::from(f.bias())
}

fn trim_exponents(c: &Config, problems: &mut Vec<String>) {
    let format = c.format.float();
    if c.mode.trim != Trim::None && !trim_fits(format) {
        problems.push(format!(
            "mode.trim = \"{}\" needs exponents of more bits for format.man = {}: format.man + 4 = {} may be at most 2^(exp-1) - 1 = {}",
            c.mode.trim.word(),
            format.man,
            format.man + 4,
            format.bias()
        ));
    }
}
