//! `ray_point`: where the ray is at a parameter, along one axis: p + d * t (PIDM-HW section 3.1). The hit position and the
//! node-crossing position are both of this form, and so is the ray's end.
use crate::float::{FormatParams, bindings, fp_add, fp_mul};
use crate::quantity::float;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `ray_point`.
pub fn ray_point(d: &Design) -> Arc<Module> {
    let b = Builder::new("ray_point", file!(), "position of the ray at a parameter, along one axis: p + d * t");
    let f = FormatParams::declare(&b, d.format);
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f.width, float("texels"), "coordinate of the entry point");
    let dir = b.input("d", &f.width, float("texels"), "travel over the height range");
    let t = b.input("t", &f.width, float("height range"), "parameter");
    let out = b.output("position", &f.width, float("texels"), "coordinate at t");
    let way =
        b.inst(&fp_mul(d.format, d.latency.mul), "u_mul", &[], &[("a", dir), ("b", t)]).only().named("displacement");
    let at = b.inst(&fp_add(d.format, d.latency.add), "u_add", &[], &[("a", p), ("b", way)]).only().named("at");
    b.drive(out, at);
    b.finish(&bindings())
}
