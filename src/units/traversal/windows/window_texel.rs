//! `window_texel`: the texel that the ray is in along one axis, by the planes that it has passed.
use super::params::{PLANES, Widths, bindings, count_width};
use crate::quantity::{BIT, TEXELS};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `window_texel`, combinational.
pub fn window_texel(d: &Design) -> Arc<Module> {
    let b = Builder::new("window_texel", file!(), "texel that a ray is in, by the planes that it has passed");
    let (levels, tile) = Widths::new(&b, d).map();
    let origin = b.input("origin", &levels, TEXELS, "texel of the entry point");
    let neg = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let k = b.input("k", count_width(&levels, &tile), PLANES, "planes that the ray has passed");
    let out = b.output("texel", &levels, TEXELS, "the texel, wrapped");
    b.unused(k);
    let steps = k.slice(0, &levels).named("steps");
    // origin - k is the complement of ~origin + k.
    let flip = neg.rep(levels.clone()).named("flip");
    let ahead = ((origin ^ flip).named("origin_ahead") + steps).named("ahead");
    b.drive(out, (ahead ^ flip).named("at"));
    b.finish(&bindings())
}
