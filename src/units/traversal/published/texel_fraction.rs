//! `texel_fraction`: where in its texel a ray hit, along one axis. The texel is the floor of the same position, so the
//! fraction bits after its point are all that is left to find.
use crate::float::{FormatParams, fp_add, fp_mul, fp_to_fixed};
use crate::quantity::{float, integer};
use crate::traversal::params::index_width;
use reliefrtl_config::Design;
use reliefrtl_ir::{Binding, Builder, Module};
use std::sync::Arc;

/// Builds `texel_fraction`.
pub fn texel_fraction(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b = Builder::new("texel_fraction", file!(), "position of the hit inside its texel: the fraction of p + d * t");
    let f = FormatParams::declare(&b, d.format);
    let idx = index_width(&b, t, None);
    let frac = b.param("FRAC_W", t.frac_bits, "fraction bits of the position");
    b.require(1, &frac);
    b.require(&frac, 16);
    b.require(2, &idx);
    b.require(&idx + &frac + &f.man, 60);
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f.width, float("texels"), "entry point");
    let dir = b.input("d", &f.width, float("texels"), "travel over the height range");
    let at = b.input("t", &f.width, float("height range"), "parameter of the hit");
    let out = b.output("fraction", &frac, integer("1/2^FRAC_W texel"), "position inside the texel");
    let way =
        b.inst(&fp_mul(d.format, d.latency.mul), "u_mul", &[], &[("a", dir), ("b", at)]).only().named("displacement");
    let pos = b.inst(&fp_add(d.format, d.latency.add), "u_add", &[], &[("a", p), ("b", way)]).only().named("position");
    let to = fp_to_fixed(d.format, t.idx_bits() + t.frac_bits, t.frac_bits, d.latency.to_int);
    let int = [("INT_W", &idx + &frac), ("FRAC_W", frac.clone())];
    let fixed = b.inst(&to, "u_to_fixed", &int, &[("a", pos)]).only().named("fixed");
    b.unused(fixed.slice(&frac, &idx));
    // The valid bit beside it decides whether the pipeline moves: it waits for a clock at least.
    b.at_least(1);
    b.drive(out, fixed.slice(0, &frac).named("after_point"));
    let at = |e: i64, m: i64| Binding::from([("EXP_W".into(), e), ("MAN_W".into(), m)]);
    b.finish(&[at(8, 23), at(5, 10), at(6, 12)])
}
