//! The golden model of the floating-point arithmetic, which more than one datapath stands on.
use crate::bits::{mask, signed};
use crate::config::Design;
use crate::golden::float as gf;
use crate::ir::Binding;
use std::cmp::Ordering;

/// Expected outputs of `unit` for one row of inputs, as [`super::model`].
///
/// # Panics
/// If the unit has no model: the catalogue and the units went apart.
pub(super) fn model(unit: &str, d: &Design, b: &Binding, x: &[u64]) -> Vec<u64> {
    let f = d.format;
    let p = |name: &str| b[name] as u32;
    match unit {
        "fp_add" => vec![gf::add(f, x[0], x[1])],
        "fp_mul" => vec![gf::mul(f, x[0], x[1])],
        "fp_div" => vec![gf::div(f, x[0], x[1])],
        "fp_lt" => vec![u64::from(gf::lt(f, x[0], x[1]))],
        "fp_sqrt" => vec![gf::sqrt(f, x[0])],
        "fp_recip" => vec![gf::recip(f, x[0])],
        "fp_add3" => vec![gf::add3(f, [x[0], x[1], x[2]])],
        "fp_compare" => {
            let order = gf::compare(f, x[0], x[1]);
            let is = |o: Option<Ordering>| u64::from(order == o);
            let mut out = [Ordering::Less, Ordering::Equal, Ordering::Greater].map(|o| is(Some(o))).to_vec();
            out.extend((!f.is_finite()).then(|| is(None)));
            out
        }
        "fp_from_int" => vec![gf::from_int(f, signed(x[0], p("INT_W")))],
        "fp_from_fixed" => vec![gf::from_fixed(f, signed(x[0], p("INT_W")), p("FRAC_W"))],
        "fp_to_int" => vec![gf::to_int(f, x[0], p("INT_W")) as u64 & mask(p("INT_W"))],
        "fp_to_fixed" => vec![gf::to_fixed(f, x[0], p("INT_W"), p("FRAC_W")) as u64 & mask(p("INT_W"))],
        other => panic!("{other} has no golden model"),
    }
}
