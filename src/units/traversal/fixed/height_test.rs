//! `height_test`: how far the ray may go before it meets the node's height: max(t, M - height), M the largest code.
use super::params::{GUARD, Params, TIME, bindings, time_width};
use crate::quantity::{BIT, CODES};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `height_test`, `latency.compare` clocks.
pub fn height_test(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("height_test", file!(), "parameter at which the ray is in the node and at or below its height");
    let of = Params { b: &b, d };
    let f = of.fraction();
    let h = of.height(&f);
    let time = b.local("TimeW", time_width(&f), "bits of a ray parameter");
    b.clock();
    b.clock_enable();
    let height = b.input("height", &h, CODES, "largest height in the node");
    let t = b.input("t", &time, TIME, "parameter so far");
    let out = b.output("m", &time, TIME, "the larger of t and the height plane's parameter");
    let below = b.output("below", 1, BIT, "the ray is below the node's height already: a hit would be on a wall");

    b.section("depth", "The complement of a code is its distance from the top plane, and a parameter as it stands.");
    let t_v = b.cat(&[!height, b.zeros(&f - &h + GUARD)]).named("t_v");
    b.at_least(d.latency.compare);
    b.drive(out, t.lt(t_v).mux(t_v, t).named("max_parameter"));
    b.drive(below, t_v.lt(t).named("is_below"));
    b.finish(&bindings())
}
