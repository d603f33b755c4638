//! `predicted_hit`: the texel coordinate, along one axis, that the ray has reached at parameter m; never ahead of it.
//!
//! The entry point that comes in is biased backwards by more than the estimate can err (`docs/datapath.md`).
use crate::float::{FormatParams, bindings, fp_add, fp_mul, fp_to_int};
use crate::quantity::{TEXELS, float};
use crate::traversal::params::index_width;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `predicted_hit`.
pub fn predicted_hit(d: &Design) -> Arc<Module> {
    let b = Builder::new("predicted_hit", file!(), "texel coordinate reached at parameter m: floor(p_back + d * m)");
    let f = FormatParams::declare(&b, d.format);
    let idx = index_width(&b, &d.traverse, None);
    b.require(2, &idx);
    b.clock();
    b.clock_enable();
    let p = b.input("p_back", &f.width, float("texels"), "entry point, biased backwards");
    let dir = b.input("d", &f.width, float("texels per height code"), "direction");
    let m = b.input("m", &f.width, float("height codes"), "parameter");
    let out = b.output("e", &idx, TEXELS, "signed coordinate");
    b.section(
        "displacement",
        "The position is rounded down to its texel; the bias keeps it from lying ahead of the ray.",
    );
    let way =
        b.inst(&fp_mul(d.format, d.latency.mul), "u_mul", &[], &[("a", dir), ("b", m)]).only().named("displacement");
    let pos = b.inst(&fp_add(d.format, d.latency.add), "u_add", &[], &[("a", p), ("b", way)]).only().named("position");
    let to = fp_to_int(d.format, d.traverse.idx_bits(), d.latency.to_int);
    let e = b.inst(&to, "u_to_int", &[("INT_W", idx)], &[("a", pos)]).only().named("texel");
    b.drive(out, e);
    b.finish(&bindings())
}
