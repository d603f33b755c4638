//! Parameter values at which the vectors of a unit are checked.
use super::table::entry;
use crate::config::Design;
use crate::interp::elaborate;
use crate::ir::{Binding, Module};

/// Values of parameters, by name.
type Values = &'static [(&'static str, i64)];

/// Values of the parameters that many units have, and of those that follow from them: a unit takes each row with what it has of it.
const TRIED: [(&str, &[Values]); 5] = [
    ("EXP_W", &[&[("EXP_W", 5), ("MAN_W", 10)], &[("EXP_W", 8), ("MAN_W", 23)], &[("EXP_W", 4), ("MAN_W", 3)]]),
    (
        "FRACTION_W",
        &[
            &[("FRACTION_W", 20), ("RECIP_W", 18)],
            &[("FRACTION_W", 12), ("RECIP_W", 10)],
            &[("FRACTION_W", 28), ("RECIP_W", 31)],
        ],
    ),
    ("LEVELS", &[&[("LEVELS", 2), ("IDX_W", 8)], &[("LEVELS", 5), ("IDX_W", 11)], &[("LEVELS", 12), ("IDX_W", 18)]]),
    ("HEIGHT_W", &[&[("HEIGHT_W", 16)]]),
    ("NUDGE_W", &[&[("NUDGE_W", 0)], &[("NUDGE_W", 1)], &[("NUDGE_W", 12)], &[("NUDGE_W", 16)]]),
];

/// Parameter values, besides the defaults, at which a unit's vectors are checked: by the names of its parameters, and those of its entry.
pub fn bindings(d: &Design, m: &Module) -> Vec<Binding> {
    let has = |p: &str| m.params.iter().any(|q| q.name == p);
    let of = |row: &Values| -> Binding { row.iter().map(|(k, v)| (k.to_string(), *v)).collect() };
    let own =
        |row: &Values| -> Binding { row.iter().filter(|(k, _)| has(k)).map(|(k, v)| (k.to_string(), *v)).collect() };
    let tried = TRIED.iter().filter(|(name, _)| has(name)).flat_map(|(_, rows)| rows.iter());
    let mut out: Vec<Binding> = tried.map(own).collect();
    out.extend(entry(d, &m.name).into_iter().flat_map(|u| u.bindings).map(of));
    // Parameters may be legal for the unit and not for one inside of it: a deep divider needs its rows.
    out.retain(|b| m.failed_checks(&m.binding_with(b)).is_empty() && elaborate(m, b).is_ok());
    out
}
