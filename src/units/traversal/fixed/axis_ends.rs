//! `axis_ends`: the texels, along one axis, of a ray's entry and of the point where it meets the bottom plane.
use super::params::{LENGTH, Params, bindings};
use crate::quantity::TEXELS;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `axis_ends`, for designs that find a start level.
pub fn axis_ends(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("axis_ends", file!(), "texels of a ray's entry and end along one axis: floor(p), floor(p + d)");
    let of = Params { b: &b, d };
    let f = of.fraction();
    let n = of.levels(&f);
    let (tile, reach) = of.reach(&f);
    let idx = of.index(&n, &tile);
    let p = b.input("p", &f, LENGTH, "entry point");
    let travel = b.input("d", &reach + 1, LENGTH, "travel down to the bottom plane, signed");
    let o_first = b.output("first", &idx, TEXELS, "texel of the entry point");
    let o_last = b.output("last", &idx, TEXELS, "texel of the end point p + d");
    b.section("texels", "A coordinate without the bits below a texel.");
    let below = &f - &n;
    let first = p.slice(below.clone(), n).zext(&idx).named("entry_texel").doc("floor of p [texels]");
    let wide = &reach + 2;
    let end = (b.cat(&[b.zeros(&wide - &f), p]) + travel.sext(wide)).named("end_point");
    let end = end.doc("p + d [2^-FRACTION_W tiles]");
    b.unused(end);
    b.drive(o_first, first);
    b.drive(o_last, end.slice(below, idx).named("end_texel").doc("floor of end_point [texels]"));
    b.finish(&bindings())
}
