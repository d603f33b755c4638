//! `node_crossing`: does the ray meet the node's height before it leaves, and if not, by which plane does it leave?
use super::params::{Params, TIME, bindings, time_width};
use crate::quantity::BIT;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `node_crossing`, `latency.compare` clocks.
pub fn node_crossing(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("node_crossing", file!(), "node crossing test: hit inside the node, or exit plane and parameter");
    let f = Params { b: &b, d }.fraction();
    let time = b.local("TimeW", time_width(&f), "bits of a ray parameter");
    b.clock();
    b.clock_enable();
    let t = b.input("t", &time, TIME, "parameter so far");
    let m = b.input("m", &time, TIME, "parameter at which the node's height is met");
    let t_x = b.input("t_x", &time, TIME, "parameter of the x exit plane");
    let t_y = b.input("t_y", &time, TIME, "parameter of the y exit plane");
    let inside = b.output("is_inside", 1, BIT, "the height is met before the ray leaves");
    let x_first = b.output("x_first", 1, BIT, "the x plane comes first, or both at once");
    let t_next = b.output("t_next", &time, TIME, "parameter after a crossing, at least t");

    b.section("compare", "All five comparisons at once; the selects follow.");
    let in_both = (m.lt(t_x) & m.lt(t_y)).named("in_both");
    let y_less = t_y.lt(t_x).named("y_lt_x");
    let (grow_x, grow_y) = (t.lt(t_x).named("t_lt_x"), t.lt(t_y).named("t_lt_y"));
    let exit = y_less.mux(t_y, t_x).named("t_exit");
    let next = y_less.mux(grow_y, grow_x).named("t_advances").mux(exit, t).named("t_after");
    b.at_least(d.latency.compare);
    b.drive(inside, in_both);
    b.drive(x_first, (!y_less).named("x_exits_first"));
    b.drive(t_next, next);
    b.finish(&bindings())
}
