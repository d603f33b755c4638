//! `node_hit`: along one axis, the texel and the position inside it at which a ray ends in a node of a chosen level.
//!
//! Which texel of the node the ray carries depends on the way it came; the hit position, kept in the node, does not.
use super::params::{LevelParams, index_width};
use crate::quantity::{LEVELS, TEXELS, integer};
use reliefrtl_config::TraverseConfig;
use reliefrtl_ir::{Binding, Builder, Module};
use std::sync::Arc;

/// Builds `node_hit`, combinational.
pub fn node_hit(t: &TraverseConfig) -> Arc<Module> {
    let b = Builder::new("node_hit", file!(), "texel and fraction of a position along one axis, kept in a node");
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    let frac = b.param("FRAC_W", t.frac_bits, "fraction bits of the position");
    b.require(1, &frac);
    b.require(&frac, 16);
    let at = b.input("at", &idx + &frac, integer("1/2^FRAC_W texel"), "the position, signed");
    let x = b.input("x", &idx, TEXELS, "a texel of the node, unwrapped");
    let lod = b.input("lod", &level_w, LEVELS, "level of the node");
    let o_texel = b.output("texel", &levels, TEXELS, "the texel, wrapped into the map");
    let o_fraction = b.output("fraction", &frac, integer("1/2^FRAC_W texel"), "position inside the texel");
    let keep = b.ones(&idx).shift_left(lod).named("keep");
    let low = b.cat(&[(x & keep).named("first"), b.zeros(&frac)]).named("low");
    let high = b.cat(&[(x | !keep).named("last"), b.ones(&frac)]).named("high");
    let before = at.slt(low).named("at_lt_low");
    let beyond = high.slt(at).named("is_beyond");
    let kept = before.mux(low, beyond.mux(high, at)).named("kept");
    b.unused(kept);
    b.drive(o_texel, kept.slice(frac.clone(), &levels));
    b.drive(o_fraction, kept.slice(0, &frac));
    let sizes = |l: i64, f: i64| Binding::from([("LEVELS".into(), l), ("IDX_W".into(), l + 6), ("FRAC_W".into(), f)]);
    b.finish(&[sizes(2, 1), sizes(3, 16), sizes(8, 12), sizes(12, 8)])
}
