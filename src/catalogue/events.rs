//! How often the rows of a unit reach what it has to get right, for the description of its vectors.
use super::models::model;
use crate::config::Design;
use crate::golden::float::{Events, events};
use crate::ir::Module;
use crate::vectors::VectorSet;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Units whose result is a rounded number, and whether they add.
const ROUNDS: &[(&str, bool)] = &[
    ("fp_add", true),
    ("fp_add3", true),
    ("fp_mul", false),
    ("fp_div", false),
    ("fp_recip", false),
    ("fp_sqrt", false),
    ("fp_from_int", false),
    ("fp_from_fixed", false),
];

/// Rows of each event that `set` reaches in the unit `m`, by its name; none for units that don't round, and for comparisons and
/// conversions to integers how often each answer comes.
pub fn count_events(d: &Design, m: &Module, set: &VectorSet) -> BTreeMap<String, usize> {
    let at = super::design_at(d, &set.params);
    let mut out = BTreeMap::new();
    if let Some((_, sum)) = ROUNDS.iter().find(|r| r.0 == m.name) {
        let float: Vec<bool> = m.data_inputs().map(|(_, p)| p.unit.starts_with("float")).collect();
        let of = |x: &Vec<u64>| {
            let op = |format, row: &[u64]| model(&m.name, &Design { format, ..at }, &set.params, row)[0];
            events(at.format, *sum, x, &float, &op)
        };
        let all: Vec<Events> = set.stimulus.par_iter().map(of).collect();
        for (event, name) in Events::ALL {
            let n = all.iter().filter(|e| e.has(*event)).count();
            out.extend((n > 0).then(|| (name.to_string(), n)));
        }
    } else if matches!(m.name.as_str(), "fp_lt" | "fp_compare") {
        for (k, column) in set.outputs.iter().enumerate() {
            for value in 0..2u64 {
                let n = set.expected.iter().filter(|r| r[k] == value).count();
                out.extend((n > 0).then(|| (format!("{} = {value}", column.name), n)));
            }
        }
    } else if matches!(m.name.as_str(), "fp_to_int" | "fp_to_fixed") {
        let largest = crate::bits::mask(set.outputs[0].width) >> 1;
        let is = |v: u64| set.expected.iter().filter(|r| r[0] == v).count();
        let rows = [
            ("largest", is(largest)),
            ("smallest", is(largest + 1)),
            ("zero", is(0)),
            ("minus one", is(2 * largest + 1)),
        ];
        out.extend(rows.into_iter().filter(|r| r.1 > 0).map(|(n, k)| (n.to_string(), k)));
    }
    out
}
