//! `window_index`: the planes that the ray has passed after an iteration, the larger of what an exit and what the estimate says.
use super::params::{Estimate, PLANES, Widths, bindings, count_width};
use crate::quantity::integer;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `window_index`, combinational: the loop's registers follow.
pub fn window_index(d: &Design) -> Arc<Module> {
    let b = Builder::new("window_index", file!(), "planes that a ray has passed: by an exit, or by the estimate");
    let widths = Widths::new(&b, d);
    let (levels, tile) = widths.map();
    let e = Estimate::of(&b, &widths.f, &levels, &tile);
    let count = b.local("CountW", count_width(&levels, &tile), "bits of a count of planes");
    let passed = b.input("passed", &count, PLANES, "planes passed by way of the exit");
    let way = b.input("way", &e.travel, integer("2^-EstimateW texels"), "how far the ray has come");
    let offset = b.input("offset", &e.offset, integer("2^-EstimateW texels"), "how far in its texel it began");
    let out = b.output("k", &count, PLANES, "planes that the ray has passed");
    let tall = &e.travel + 1;
    let at = (way.zext(&tall) + offset.zext(&tall)).named("at");
    b.unused(at);
    let reached = at.slice(&e.fraction, &count).named("reached");
    b.drive(out, passed.lt(reached).mux(reached, passed).named("larger"));
    b.finish(&bindings())
}
