//! `boundary_time`: the ray parameter just beyond a plane, (plane +- nudge - p) / d, by a divider in the loop
//! (PIDM-HW section 4.2, table 1).
//!
//! The nudge is this project's: without it a crossing position often rounds back into the node that it should leave, and
//! a ray toward smaller coordinates lands on the plane itself, which belongs to the old node (`docs/published.md`).
use crate::float::{FormatParams, fp_add, fp_div, fp_from_fixed};
use crate::quantity::{BIT, TEXELS, float};
use crate::traversal::params::index_width;
use reliefrtl_config::Design;
use reliefrtl_ir::{Binding, Builder, Expr, Module};
use std::sync::Arc;

/// Declares NUDGE_W and what it may be.
pub fn nudge_width(b: &Builder, d: &Design) -> Expr {
    let nudge = b.param("NUDGE_W", d.datapath.nudge_bits, "crossings aim 2^-NUDGE_W texels past the plane; 0: none");
    b.require(0, &nudge);
    b.require(&nudge, 16);
    nudge
}

/// Builds `boundary_time`.
pub fn boundary_time(d: &Design) -> Arc<Module> {
    let b = Builder::new("boundary_time", file!(), "ray parameter just beyond a plane: (plane +- nudge - p) / d");
    let f = FormatParams::declare(&b, d.format);
    let idx = index_width(&b, &d.traverse, None);
    let nudge = nudge_width(&b, d);
    b.require(2, &idx);
    b.require(&idx + &nudge + &f.man, 60);
    let div = fp_div(d.format, &d.latency);
    let wide = b.local("FixedW", &idx + &nudge + 1, "bits of a position: texel, then fraction");
    b.clock();
    b.clock_enable();
    let plane = b.input("plane", &idx, TEXELS, "coordinate of the plane, signed");
    let neg = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let p = b.input("p", &f.width, float("texels"), "coordinate of the entry point");
    let dir = b.input("d", &f.width, float("texels"), "travel over the height range");
    let out = b.output("t", &f.width, float("height range"), "infinity if the ray does not move along this axis");

    b.section("nudge", "In fixed point: a plane has no fraction bits, so the nudge is its last one.");
    let by = b.konst(&nudge, 5).named("nudge_bits").doc("fraction bits of a position, the last of which is the nudge");
    let at = plane.sext(&wide).shift_left(by).named("plane_fixed");
    let step = b.konst(nudge.smaller(1), 1).named("has_nudge").doc("1 if there is a nudge at all").zext(&wide);
    let target = neg.mux(at - step, at + step).named("target").reg();

    b.section("distance", "");
    let fixed = d.traverse.idx_bits() + d.datapath.nudge_bits + 1;
    let from = fp_from_fixed(d.format, fixed, d.datapath.nudge_bits, d.latency.from_int);
    let params = [("INT_W", wide), ("FRAC_W", nudge)];
    let at = b.inst(&from, "u_from_fixed", &params, &[("a", target)]).only().named("plane_float");
    let minus_p = b.cat(&[!p.msb(), p.slice(0, &f.width - 1)]).named("minus_p");
    let add = fp_add(d.format, d.latency.add);
    let dist = b.inst(&add, "u_sub", &[], &[("a", at), ("b", minus_p)]).only().named("distance");

    b.section("parameter", "");
    let t = b.inst(&div, "u_div", &[], &[("a", dist), ("b", dir)]).only().named("plane_parameter");
    b.drive(out, t);
    let at = |n: i64, e: i64, m: i64| Binding::from([("NUDGE_W".into(), n), ("EXP_W".into(), e), ("MAN_W".into(), m)]);
    b.finish(&[at(0, 7, 16), at(1, 5, 10), at(13, 8, 23), at(16, 7, 16)])
}
