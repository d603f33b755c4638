//! `window_way`: how far the ray has come along one axis by a parameter, for an estimate that is never ahead.
use super::params::{Estimate, Widths, bindings};
use super::plane_product::multiplier_clocks;
use crate::quantity::integer;
use crate::traversal::fixed::params::TIME;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `window_way`, as many clocks as `plane_product`.
pub fn window_way(d: &Design) -> Arc<Module> {
    let b = Builder::new("window_way", file!(), "how far a ray has come along an axis, rounded down");
    let widths = Widths::new(&b, d);
    let (levels, tile) = widths.map();
    let e = Estimate::of(&b, &widths.f, &levels, &tile);
    let time = widths.time();
    b.clock();
    b.clock_enable();
    let travel = b.input(
        "travel",
        &e.travel,
        integer("2^-(EstimateW+HEIGHT_W) texels"),
        "travel per height code, less its bias",
    );
    let m = b.input("m", &time, TIME, "parameter");
    let out = b.output("way", &e.travel, integer("2^-EstimateW texels"), "how far the ray has come");
    b.at_least(multiplier_clocks(d));
    let top = m.slice(&time - &e.time, &e.time);
    b.unused(m);
    let product = travel.product(top).named("product");
    b.unused(product);
    b.drive(out, product.slice(&e.time, &e.travel).named("upper"));
    b.finish(&bindings())
}
