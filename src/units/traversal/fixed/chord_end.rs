//! `chord_end`: the texel coordinate, along one axis, that the ray has reached when it leaves a node by the other axis' plane; never behind it.
//!
//! A plane's parameter may be too small by one part in 2^(RECIP_W-1) and by one unit: a parameter larger by as much, and a way longer by what
//! its factors were rounded down by, bound every plane that is met before (`docs/fixed.md`, "Chord trim").
use super::params::{LENGTH, Params, TIME, bindings, time_width};
use super::predicted_hit::position;
use crate::config::{Design, LatencyConfig};
use crate::ir::{Builder, Module};
use std::sync::Arc;

/// Clocks through `chord_end`.
pub fn latency(l: &LatencyConfig) -> u32 {
    l.mul + l.add.min(1)
}

/// Builds `chord_end`.
pub fn chord_end(d: &Design) -> Arc<Module> {
    let b = Builder::new("chord_end", file!(), "texel coordinate at an exit, never behind the ray");
    let of = Params { b: &b, d };
    let f = of.fraction();
    let w = of.recip();
    let n = of.levels(&f);
    let (tile, reach) = of.reach(&f);
    let idx = of.index(&n, &tile);
    let time = b.local("TimeW", time_width(&f));
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f, LENGTH, "entry point");
    let s = b.input("s", &reach + 1, "2^-(FRACTION_W+HEIGHT_W) tiles", "travel per height code");
    let neg = b.input("neg", 1, "bit", "the ray runs toward smaller coordinates");
    let t = b.input("t", &time, TIME, "parameter of the other axis' exit plane");
    let out = b.output("reach", &idx, "texels", "signed coordinate");
    let l = latency(&d.latency);
    b.plan(l, &[("later", 5), ("way", 10), ("position", 5)]);
    b.section("later", "");
    // A bit more, which the sum needs; and no shift is as wide as its word.
    let tall = b.cat(&[b.zeros(1), t]).named("t_tall");
    let part = b.konst((&w - 1).smaller(&time), 6).named("recip_bits");
    let late = (tall + tall.shift_right(part) + b.lit(3, 2).zext(&time + 1)).named("late");
    b.section("way", "");
    let prod = s.product(late).named("prod");
    b.unused(b.cat(&[prod.msb(), prod.slice(0, &time)]));
    let way = (prod.slice(&time, &reach + 1) + b.lit(8, 4).zext(&reach + 1)).named("way_ahead");
    b.section("position", "");
    let at = position(&b, p, way, neg, &reach);
    b.unused(at);
    b.drive(out, at.slice(&f - &n, idx).named("texel"), Some(l));
    b.finish(Some(l), &bindings())
}
