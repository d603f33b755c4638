//! `datapath.kind = "watertight"` (`docs/datapath.md`).
use super::facts::{DatapathFacts, Reads};
use super::float;
use crate::{Config, Trim};
use reliefrtl_base::format::FloatFormat;

pub(super) const FACTS: DatapathFacts = DatapathFacts {
    word: "watertight",
    reads: Reads { format: true, nudge_bits: false, fraction_bits: false },
    words: float::words,
    steps_indices: true,
    divides_in_loop: false,
    start_trip: false,
    modes_agree: true,
    windows: false,
    trim: true,
    trim_fits,
    lod: true,
    bilinear: true,
    clock_by_units: true,
    from_fixed: float::hit_word,
    limits: &[float::widths, trim_exponents],
    label: |_, f| format!("watertight {}/{}", f.exp, f.man),
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
