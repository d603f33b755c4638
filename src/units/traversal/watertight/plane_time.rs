//! `plane_time`: the ray parameter of a plane, (plane - p) * r. The same formula for every level, so it is a monotone
//! function of the integer plane: what makes the traversal watertight (`docs/datapath.md`).
use crate::float::{FormatParams, bindings, fp_add, fp_from_int, fp_mul};
use crate::quantity::{BIT, TEXELS, float};
use crate::traversal::params::index_width;
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `plane_time`.
pub fn plane_time(d: &Design) -> Arc<Module> {
    let b = Builder::new("plane_time", file!(), "ray parameter at which the ray meets a plane: (plane - p) * r");
    let f = FormatParams::declare(&b, d.format);
    let idx = index_width(&b, &d.traverse, None);
    b.require(2, &idx);
    b.clock();
    b.clock_enable();
    let plane = b.input("plane", &idx, TEXELS, "coordinate of the plane, signed");
    let p = b.input("p", &f.width, float("texels"), "coordinate of the entry point");
    let r = b.input("r", &f.width, float("height codes per texel"), "slope's reciprocal");
    let never = b.input("never", 1, BIT, "the ray does not move along this axis");
    let out = b.output("t", &f.width, float("height codes"), "infinity if never");

    b.section("distance", "");
    let from = fp_from_int(d.format, d.traverse.idx_bits(), d.latency.from_int);
    let at = b
        .inst(&from, "u_from_int", &[("INT_W", idx)], &[("a", plane)])
        .only()
        .named("plane_float")
        .doc("the plane [float, texels]");
    let minus_p = b.cat(&[!p.msb(), p.slice(0, &f.width - 1)]).named("minus_p");
    let dist = b
        .inst(&fp_add(d.format, d.latency.add), "u_sub", &[], &[("a", at), ("b", minus_p)])
        .only()
        .named("distance")
        .doc("plane - p [float, texels]");

    b.section("parameter", "");
    let t = b
        .inst(&fp_mul(d.format, d.latency.mul), "u_mul", &[], &[("a", dist), ("b", r)])
        .only()
        .named("product")
        .doc("distance * r [float, height codes]");
    let inf = b.cat(&[b.zeros(1), b.ones(&f.exp), b.zeros(&f.man)]);
    let t = never.mux(inf, t).named("plane_parameter");
    b.drive(out, t.reg_if(d.latency.has(Register::Parameter)));
    b.finish(&bindings())
}
