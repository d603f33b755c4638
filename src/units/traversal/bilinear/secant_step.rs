//! `secant_step`: where the chord between the gaps at a window's two ends meets zero.
use super::common::negated;
use crate::float::{Fields, FormatParams, bindings, fp_add, fp_div, fp_lt, fp_mul};
use crate::quantity::{float, integer};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `secant_step`.
pub fn secant_step(d: &Design) -> Arc<Module> {
    let b = Builder::new(
        "secant_step",
        file!(),
        "one secant step between two parameters, and whether there is a root between them",
    );
    let f = FormatParams::declare(&b, d.format);
    b.clock();
    b.clock_enable();
    let begin = b.input("t_begin", &f.width, float("height codes"), "where the window begins");
    let end = b.input("t_end", &f.width, float("height codes"), "where it ends");
    let g_begin = b.input("gap_begin", &f.width, float("height codes"), "height over the surface at the begin");
    let g_end = b.input("gap_end", &f.width, float("height codes"), "height over the surface at the end");
    let o_patch =
        b.output("patch", 2, integer("code"), "1 hit, 2 above the surface at the end, 3 below it at the begin");
    let o_t = b.output("t", &f.width, float("height codes"), "the step's parameter, of a hit");
    let (add, lt) = (fp_add(d.format, d.latency.add), fp_lt(d.format, d.latency.compare));
    let div = fp_div(d.format, &d.latency);
    let zero = b.zeros(&f.width);

    b.section("signs", "Below at the begin: the root was before. Above at the end: it comes after.");
    let below = b.inst(&lt, "u_below", &[], &[("a", g_begin), ("b", zero)]).only().named("is_below");
    let above = b.inst(&lt, "u_above", &[], &[("a", zero), ("b", g_end)]).only().named("is_above");
    let misses = (below | above).named("misses");
    let patch = b.cat(&[misses, below | !above]).named("patch_code");
    // 0 / 0 says nothing: the ray meets the surface where the window begins.
    let fg = Fields::of(&f, g_begin, "gap");
    let at_once = fg.is_zero.named("meets_at_once");
    b.unused(b.cat(&[fg.sign, fg.is_inf, fg.is_nan]));

    b.section("chord", "");
    let (minus_gap, minus_begin) = (negated(&b, g_end, "minus_gap"), negated(&b, begin, "minus_begin"));
    let fall = b.inst(&add, "u_fall", &[], &[("a", g_begin), ("b", minus_gap)]).only().named("fall");
    let part = b.inst(&div, "u_part", &[], &[("a", g_begin), ("b", fall)]).only().named("part");
    let span = b.inst(&add, "u_span", &[], &[("a", end), ("b", minus_begin)]).only().named("span");
    let mul = fp_mul(d.format, d.latency.mul);
    let way = b.inst(&mul, "u_way", &[], &[("a", part), ("b", span)]).only().named("way");
    let met = b.inst(&add, "u_met", &[], &[("a", begin), ("b", way)]).only().named("t_secant");

    b.section("clamp", "Rounding does not lead out of the window.");
    let inside = b.inst(&lt, "u_inside", &[], &[("a", met), ("b", end)]).only().named("is_inside");
    let step = at_once.mux(begin, inside.mux(met, end).named("kept")).named("step");
    b.drive(o_patch, patch);
    b.drive(o_t, step);
    b.finish(&bindings())
}
