//! `chord_end`: the texel coordinate, along one axis, that the ray has reached when it leaves a node by the other axis' plane; never short of it.
//!
//! The reciprocal, and with it a plane's parameter, may be too small by one part in 2^RECIP_W, and the parameter is rounded down; one that is larger
//! by more, and a travel that is larger by more than its roundings, make up for it (`docs/fixed.md`, "Chord trim").
use super::params::{LENGTH, Params, TIME, bindings, time_width};
use super::predicted_hit::{position, way};
use crate::quantity::{BIT, TEXELS, integer};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// What a travel per height code may lack.
const SLACK: u64 = 6;
/// What rounding takes from a parameter: less than one when it was computed, and less than one when it is made larger.
const ROUNDINGS: u64 = 2;

/// Builds `chord_end`.
pub fn chord_end(d: &Design) -> Arc<Module> {
    let b = Builder::new("chord_end", file!(), "texel coordinate at an exit, never short of the ray");
    let of = Params { b: &b, d };
    let f = of.fraction();
    let w = of.recip();
    let n = of.levels(&f);
    let (tile, reach) = of.reach(&f);
    let idx = of.index(&n, &tile);
    let time = b.local("TimeW", time_width(&f), "bits of a ray parameter");
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f, LENGTH, "entry point");
    let s = b.input("s", &reach + 1, integer("2^-(FRACTION_W+HEIGHT_W) tiles"), "travel per height code");
    let neg = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let t = b.input("t", &time, TIME, "parameter of the other axis' exit plane");
    let out = b.output("bound", &idx, TEXELS, "signed coordinate");
    b.plan(d.latency.mul + d.latency.add.min(1), &[("larger", 3), ("way", 10), ("position", 4)]);
    b.section("larger", "By more than one part in 2^RECIP_W, and by more than all that is rounded down.");
    let more = (s + b.lit(SLACK, &reach + 1)).named("s_more");
    let wide = &time + 1;
    let tall = t.zext(wide.clone()).named("t_tall");
    // At most as far as the word goes, where nothing is left.
    let part = b
        .konst((&w - 1).smaller(&time), 6)
        .named("recip_part")
        .doc("the reciprocal is too small by one part in 2^this at most");
    let late = (tall + tall.shift_right(part) + b.lit(ROUNDINGS, &wide)).named("late");
    b.section("way", "");
    let way = way(&b, more, late, &time, &(&reach + 1));
    b.section("position", "A ray toward smaller coordinates has left a texel when it is at its border.");
    let at = position(&b, p, way, neg, &(&reach + 1), Some(neg));
    b.unused(at);
    b.drive(out, at.slice(&f - &n, idx).named("texel"));
    b.finish(&bindings())
}
