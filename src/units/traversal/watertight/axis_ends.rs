//! `axis_ends`: the texels, along one axis, of a ray's entry and of the point where it meets the bottom plane.
use crate::float::{FormatParams, bindings, fp_add, fp_to_int};
use crate::quantity::{TEXELS, float};
use crate::traversal::params::index_width;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `axis_ends`, for designs that find a start level.
pub fn axis_ends(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("axis_ends", file!(), "texels of a ray's entry and end along one axis: floor(p), floor(p + d)");
    let f = FormatParams::declare(&b, d.format);
    let idx = index_width(&b, &d.traverse, None);
    b.require(2, &idx);
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f.width, float("texels"), "entry point");
    let travel = b.input("dn", &f.width, float("texels"), "travel down to the bottom plane");
    let o_first = b.output("first", &idx, TEXELS, "texel of the entry point");
    let o_last = b.output("last", &idx, TEXELS, "texel of the rounded end point p + dn");
    b.section("texels", "");
    let to = fp_to_int(d.format, d.traverse.idx_bits(), d.latency.to_int);
    let texel = |at, unit: &str| b.inst(&to, unit, &[("INT_W", idx.clone())], &[("a", at)]).only();
    let first = texel(p, "u_first").named("entry_texel").doc("floor of p [texels]");
    let end = b.inst(&fp_add(d.format, d.latency.add), "u_end", &[], &[("a", p), ("b", travel)]).only();
    let end = end.named("end_point").doc("p + dn [float, texels]");
    let last = texel(end, "u_last").named("end_texel").doc("floor of end_point [texels]");
    b.drive(o_first, first);
    b.drive(o_last, last);
    b.finish(&bindings())
}
