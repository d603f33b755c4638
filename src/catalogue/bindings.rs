//! Parameter values at which the vectors of a unit are checked.
use super::table::entry;
use crate::config::Design;
use crate::interp::elaborate;
use crate::ir::{Binding, Module};

/// Parameter values, besides the defaults, at which a unit's vectors are checked: by the names of its parameters, and those of its entry.
pub fn bindings(d: &Design, m: &Module) -> Vec<Binding> {
    let of = |pairs: &[(&str, i64)]| -> Binding { pairs.iter().map(|(k, v)| (k.to_string(), *v)).collect() };
    let has = |p: &str| m.params.iter().any(|q| q.name == p);
    let mut out = Vec::new();
    if has("EXP_W") {
        out.extend([(5, 10), (8, 23), (4, 3)].map(|(e, f)| of(&[("EXP_W", e), ("MAN_W", f)])));
    }
    if has("FRACTION_W") {
        let of =
            |f, w| if has("RECIP_W") { of(&[("FRACTION_W", f), ("RECIP_W", w)]) } else { of(&[("FRACTION_W", f)]) };
        out.extend([of(20, 18), of(12, 10), of(28, 31)]);
    }
    if has("LEVELS") {
        out.extend(
            [2, 5, 12]
                .map(|l| if has("IDX_W") { of(&[("LEVELS", l), ("IDX_W", l + 6)]) } else { of(&[("LEVELS", l)]) }),
        );
    }
    if has("HEIGHT_W") {
        out.push(of(&[("HEIGHT_W", 16)]));
    }
    if has("NUDGE_W") {
        out.extend([0, 1, 12, 16].map(|n| of(&[("NUDGE_W", n)])));
    }
    out.extend(entry(d, &m.name).into_iter().flat_map(|u| u.bindings).map(|pairs| of(pairs)));
    // Parameters may be legal for the unit and not for one inside of it: a deep divider needs its rows.
    out.retain(|b| m.failed_checks(&m.binding_with(b)).is_empty() && elaborate(m, b).is_ok());
    out
}
