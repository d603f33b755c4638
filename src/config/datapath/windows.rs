//! `datapath.kind = "fixed"` with `datapath.search = "windows"` (`docs/windows.md`).
use super::facts::DatapathFacts;
use super::fixed;
use crate::windows::ignored;
use crate::{Config, DatapathConfig};
use reliefrtl_base::format::FloatFormat;

pub(super) const FACTS: DatapathFacts = DatapathFacts {
    word: "windows",
    windows: true,
    trim: false,
    trim_fits: |_| false,
    lod: false,
    limits: &[fixed::widths, set, ignored],
    label,
    ..fixed::FACTS
};

/// As that of the pyramid, with the search's name.
fn label(path: &DatapathConfig, format: FloatFormat) -> String {
    (fixed::FACTS.label)(path, format).replacen("fixed", "windows", 1)
}

/// What the map's size asks of the set.
fn set(c: &Config, problems: &mut Vec<String>) {
    let set = c.windows.at(c.traverse.levels);
    problems.extend(set.misfit(c.traverse.levels).map(|problem| format!("windows.set = \"{set}\" {problem}")));
}
