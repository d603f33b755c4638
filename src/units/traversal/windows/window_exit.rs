//! `window_exit`: where the ray leaves a window, and whether it can hold the hit: whether the ray is at its highest code before.
use super::params::{FINE, SPAN_W, Widths, bindings};
use crate::quantity::{BIT, CODES};
use crate::traversal::fixed::params::{GUARD, TIME};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `window_exit`.
pub fn window_exit(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("window_exit", file!(), "where a ray leaves a window, and whether the window can hold the hit");
    let widths = Widths::new(&b, d);
    let (f, p) = (widths.f.clone(), widths.planes());
    let h = widths.of.height(&f);
    let time = widths.time();
    let wide = &p.plane + SPAN_W;
    b.clock();
    b.clock_enable();
    let ends = ["x", "y"].map(|a| b.input(&format!("end_{a}"), &wide, FINE, "parameter of the plane that ends it"));
    let height = b.input("height", &h, CODES, "highest code in the window");
    let t = b.input("t", &time, TIME, "parameter so far");
    let o_exit = b.output("exit", &time, TIME, "parameter of the nearer plane; all ones: not before the bottom plane");
    let o_first = b.output("x_first", 1, BIT, "it is the plane of u, or both at once");
    let o_fraction = b.output("fraction", 1, BIT, "that parameter is no whole height code");
    let o_in = b.output("is_in", 1, BIT, "the window can hold the hit");
    let o_open = b.output("is_open", 1, BIT, "the exit lies after t");
    let o_depth = b.output("depth", &h, CODES, "from the top plane to the highest code");
    // Two comparisons in series.
    b.plan(2 * d.latency.compare, &[("nearer plane", 9), ("exit", 7)]);
    b.section("nearer plane", "Cut to a ray parameter. Of two planes that are never met the first is that of u.");
    let low = f.clone() - &h + GUARD;
    let (mut when, mut parts) = (Vec::new(), Vec::new());
    for (a, end) in ["x", "y"].into_iter().zip(ends) {
        let far = end.slice(&p.plane, SPAN_W).any().named(&format!("{a}_is_beyond"));
        let t_a = (end.slice(&p.guard, &time) | far.rep(time.clone())).named(&format!("t_{a}"));
        parts.push(t_a.slice(0, &low).any().named(&format!("{a}_fraction")));
        when.push(t_a);
        b.unused(end);
    }
    // Of words that are not cut yet, so that the comparison waits for nothing.
    let whole = |k: usize| ends[k].slice(&p.guard, &time + SPAN_W);
    let y_less = (whole(1).lt(whole(0)) & !when[1].all()).named("y_lt_x");
    let x_first = (!y_less).named("x_first");
    b.section("exit", "A depth has only a height code's bits: of the exit its own, and whether any bit below is set.");
    let exit = x_first.mux(when[0], when[1]).named("t_exit");
    let fraction = x_first.mux(parts[0], parts[1]).named("exit_fraction");
    let depth = (!height).named("depth_code");
    let inside = b.cat(&[depth, b.zeros(1)]).lt(b.cat(&[exit.slice(&low, &h), fraction])).named("can_hold");
    b.drive(o_exit, exit);
    b.drive(o_first, x_first);
    b.drive(o_fraction, fraction);
    b.drive(o_in, inside);
    b.drive(o_open, t.lt(exit).named("exit_ahead"));
    b.drive(o_depth, depth);
    b.finish(&bindings())
}
