//! `window_advance`: the parameter up to which the ray is known to hit nothing, and the planes that it passes by the exit of a window.
use super::params::{PLANES, SPAN_W, Widths, bindings, count_width};
use crate::quantity::{BIT, CODES, TEXELS};
use crate::traversal::fixed::params::{GUARD, TIME};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `window_advance`.
pub fn window_advance(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("window_advance", file!(), "how far the way is empty, and the planes that are passed by an exit");
    let widths = Widths::new(&b, d);
    let f = widths.f.clone();
    let (levels, tile) = widths.map();
    let h = widths.of.height(&f);
    let time = widths.time();
    let count = b.local("CountW", count_width(&levels, &tile), "bits of a count of planes");
    let low = &f - &h + GUARD;
    b.clock();
    b.clock_enable();
    let t = b.input("t", &time, TIME, "parameter so far");
    let exit = b.input("exit", &time, TIME, "exit of an empty window");
    let fraction = b.input("fraction", 1, BIT, "the exit is no whole height code: of its lower bits one is set");
    let depth = b.input("depth", &h, CODES, "depth of a hit, or of a window");
    let takes_exit = b.input("takes_exit", 1, BIT, "the exit counts");
    let takes_depth = b.input("takes_depth", 1, BIT, "the depth counts");
    let x_first = b.input("x_first", 1, BIT, "the exit is a plane of u");
    let crosses = b.input("crosses", 1, BIT, "the ray goes beyond the exit");
    let axes = ["x", "y"].map(|a| {
        let k = b.input(&format!("k_{a}"), &count, PLANES, "planes that the ray has passed");
        (a, k, b.input(&format!("past_{a}"), SPAN_W, TEXELS, "texels of the window beyond this one"))
    });
    let o_m = b.output("m", &time, TIME, "the largest of t and what counts");
    let o_below = b.output("below", 1, BIT, "the depth lies before t: a hit would be on a wall");
    let o_k = ["x", "y"].map(|a| b.output(&format!("passed_{a}"), &count, PLANES, "planes passed by way of the exit"));
    b.at_least(d.latency.compare);
    b.section("parameter", "Three comparisons at once. A depth has only a height code's bits.");
    let high = t.slice(&low, &h);
    let exit_is_greater = (t.lt(exit) & takes_exit).named("exit_is_greater");
    let depth_is_greater = (high.lt(depth) & takes_depth).named("depth_is_greater");
    let depth_last = b.cat(&[exit.slice(&low, &h), fraction]).lt(b.cat(&[depth, b.zeros(1)])).named("depth_last");
    let at_exit = (exit_is_greater & !(depth_is_greater & depth_last)).named("at_exit");
    let code = b.cat(&[depth, b.zeros(&low)]);
    let m = at_exit.mux(exit, depth_is_greater.mux(code, t)).named("m_chosen");
    b.drive(o_m, m);
    let past = (depth.lt(high) | (depth.eq(high) & t.slice(0, &low).any())).named("is_below");
    b.drive(o_below, past);
    b.section("planes", "");
    for ((a, k, texels), out) in axes.into_iter().zip(o_k) {
        let moves = if a == "x" { crosses & x_first } else { crosses & !x_first }.named(&format!("moves_{a}"));
        let by = (texels & moves.rep(SPAN_W)).named(&format!("by_{a}"));
        // One more, as the carry into the sum.
        let tall = &count + 1;
        let by = by.zext(&count + SPAN_W).named(&format!("by_{a}_tall"));
        b.unused(by);
        let sum = b.cat(&[k, moves]) + b.cat(&[by.slice(0, &count), moves]);
        let sum = sum.named(&format!("sum_{a}"));
        b.unused(sum);
        b.drive(out, sum.slice(1, &tall - 1).named(&format!("k_{a}_passed")));
    }
    b.finish(&bindings())
}
