//! Every unit of a design in the interpreter against its model.
use reliefrtl::catalogue::{bindings, check_interp, units, vector_set};
use reliefrtl::config::Design;
use reliefrtl::ir::Binding;
use reliefrtl::vectors::Plan;
use reliefrtl::verilog::{Style, print_module};
use std::collections::HashSet;

/// What was compared already: the same text, stimulus and expected words are not run again.
#[derive(Default)]
pub struct Checked {
    seen: HashSet<blake3::Hash>,
    /// Rows compared.
    pub rows: usize,
}

impl Checked {
    /// Compares all units of `d`, at their defaults and at other parameter values.
    pub fn units(&mut self, d: &Design, rows: usize) {
        for m in units(d) {
            let mut text = blake3::Hasher::new();
            for below in m.hierarchy() {
                text.update(print_module(&below, &Style::default()).as_bytes());
            }
            for b in std::iter::once(Binding::new()).chain(bindings(d, &m)) {
                let set = vector_set(d, &m, &b, Plan { rows, seed: 7 });
                let mut key = text.clone();
                key.update(format!("{b:?}").as_bytes());
                for word in set.stimulus.iter().chain(&set.expected).flatten() {
                    key.update(&word.to_le_bytes());
                }
                if !self.seen.insert(key.finalize()) {
                    continue;
                }
                let report = check_interp(&m, &set).unwrap_or_else(|e| panic!("{}: {e} (at {b:?})", m.name));
                assert!(report.checked > 0, "{}", m.name);
                report.verdict(&set, &m).unwrap_or_else(|e| panic!("{e} (at {b:?})"));
                self.rows += report.checked;
            }
        }
    }
}

/// Compares all units of one design; rows compared.
pub fn check_all(d: &Design, rows: usize) -> usize {
    let mut checked = Checked::default();
    checked.units(d, rows);
    checked.rows
}
