//! `depth_limit`: a plane's parameter rounded up to a height code: depths below it, as integers, are met before the plane (`docs/cells.md`).
use crate::float::{Fields, FormatParams, bindings};
use crate::quantity::{CODES, float};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `depth_limit`.
pub fn depth_limit(d: &Design) -> Arc<Module> {
    let b = Builder::new("depth_limit", file!(), "least depth that is not met before a plane, in height codes");
    let f = FormatParams::declare(&b, d.format);
    let h = b.param("HEIGHT_W", d.traverse.height_bits, "bits of a height code");
    b.require(2, &h);
    b.require(&h, 16);
    // A difference of exponents, signed, and HEIGHT_W beside it.
    let diff_w = b.local("DiffW", &f.exp + 6, "bits of a difference of exponents");
    b.clock();
    b.clock_enable();
    let t = b.input("t", &f.width, float("height codes"), "parameter of the plane");
    let out = b.output("limit", &h + 1, CODES, "t rounded up, 0 to 2^HEIGHT_W; of NaN 0");
    b.plan(d.latency.to_int, &[("class", 5), ("shift", 5), ("round up", 5)]);

    b.section("class", "Of a number below 1 no bit is left, and from 2^HEIGHT_W on nothing is asked.");
    let t = Fields::of(&f, t, "t");
    let none = (t.sign | t.is_zero | t.is_nan).named("is_none");
    let above = (t.exp.zext(&diff_w) - b.konst(f.bias(), &diff_w).named("bias").doc("the exponent bias"))
        .named("exp_above_bias");
    let small = above.msb().named("is_below_one");
    let large = (t.is_inf
        | !(small | above.lt(b.konst(&h, &diff_w).named("height_bits").doc("bits of a height code"))))
    .named("is_beyond_all");
    let by = above.slice(0, 5).named("shift_by");
    b.unused(above);

    b.section("shift", "");
    let wide = b.cat(&[b.zeros(&h - 1), b.lit(1, 1), t.frac]).named("significand");
    let moved = wide.shift_left(by).named("moved");

    b.section("round up", "");
    let rest = moved.slice(0, f.man.clone()).any().named("has_fraction");
    let whole = (moved.slice(f.man.clone(), &h).zext(&h + 1) + rest.zext(&h + 1)).named("whole");
    let one = b.lit(1, &h + 1);
    let most = b.cat(&[b.lit(1, 1), b.zeros(&h)]).named("most");
    let number = large.mux(most, small.mux(one, whole)).named("number");
    let kept = (number & (!none).rep(&h + 1)).named("kept");
    b.drive(out, kept);
    b.finish(&bindings())
}
