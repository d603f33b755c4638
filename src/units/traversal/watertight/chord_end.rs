//! `chord_end`: the texel coordinate, along one axis, that the ray has reached when it leaves a node by the other axis' plane; never short of it.
//!
//! The entry point that comes in is moved forward by more than the estimate can err (`docs/datapath.md`, "Chord trim").
use crate::float::{FormatParams, bindings, fp_add, fp_mul, fp_to_int};
use crate::quantity::{BIT, TEXELS, float};
use crate::traversal::params::index_width;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `chord_end`.
pub fn chord_end(d: &Design) -> Arc<Module> {
    let b = Builder::new(
        "chord_end",
        file!(),
        "texel coordinate at an exit, never short of the ray: floor(p_ahead + d * t)",
    );
    let f = FormatParams::declare(&b, d.format);
    let idx = index_width(&b, &d.traverse, None);
    b.require(2, &idx);
    b.clock();
    b.clock_enable();
    let p = b.input("p_ahead", &f.width, float("texels"), "entry point, biased forward");
    let dir = b.input("d", &f.width, float("texels per height code"), "direction");
    let neg = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let t = b.input("t", &f.width, float("height codes"), "parameter of the other axis' exit plane");
    let out = b.output("bound", &idx, TEXELS, "signed coordinate; the farthest one if t is infinite");
    b.section(
        "displacement",
        "The position is rounded down to its texel; the bias keeps it from falling short of the ray.",
    );
    let way =
        b.inst(&fp_mul(d.format, d.latency.mul), "u_mul", &[], &[("a", dir), ("b", t)]).only().named("displacement");
    let pos = b.inst(&fp_add(d.format, d.latency.add), "u_add", &[], &[("a", p), ("b", way)]).only().named("position");
    let to = fp_to_int(d.format, d.traverse.idx_bits(), d.latency.to_int);
    let texel = b.inst(&to, "u_to_int", &[("INT_W", idx.clone())], &[("a", pos)]).only().named("texel");

    b.section(
        "farthest",
        "A ray that never leaves: nothing times infinity is no number, and says nothing about the way.",
    );
    let never = t.slice(f.man.clone(), f.exp.clone()).all().named("is_never");
    let neg = neg.beside(texel);
    let farthest = b.cat(&[neg, (!neg).rep(&idx - 1)]).named("farthest");
    b.drive(out, never.mux(farthest, texel).named("texel_bound"));
    b.finish(&bindings())
}
