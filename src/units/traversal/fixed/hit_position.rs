//! `hit_position`: where in its texel a ray hit, along one axis, as a fraction that never leaves the texel.
use super::params::{LENGTH, Params, TIME, bindings, time_width};
use super::predicted_hit::position;
use crate::quantity::{BIT, LEVELS, TEXELS, integer};
use crate::traversal::node_hit;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Builds `hit_position`. With a level of detail the hit is kept in its node, else in its texel.
pub fn hit_position(d: &Design) -> Arc<Module> {
    let b = Builder::new("hit_position", file!(), "position of the hit inside its texel: p + way - x, kept in [0, 1)");
    let of = Params { b: &b, d };
    let f = of.fraction();
    let n = of.levels(&f);
    let level_w = d.mode.lod.then(|| b.local("LevelW", (&n + 1).clog2(), "bits of a level"));
    let (tile, reach) = of.reach(&f);
    let frac = b.param("FRAC_W", d.traverse.frac_bits, "fraction bits of the position");
    b.require(1, &frac);
    b.require(&frac, 16);
    let idx = of.index(&n, &tile);
    let time = b.local("TimeW", time_width(&f), "bits of a ray parameter");
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f, LENGTH, "entry point");
    let s = b.input("s", &reach + 1, integer("2^-(FRACTION_W+HEIGHT_W) tiles"), "travel per height code");
    let neg = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let t = b.input("t", &time, TIME, "parameter of the hit");
    let x = b.input("x", &idx, TEXELS, "hit texel, unwrapped");
    let lod = level_w.map(|w| b.input("lod", &w, LEVELS, "level of the node that is hit"));
    let out = b.output("fraction", &frac, integer("1/2^FRAC_W texel"), "position inside the texel");
    let o_texel = d.mode.lod.then(|| b.output("texel", &n, TEXELS, "texel of the hit, wrapped"));
    // A register before the multipliers, where there is a clock for it: their operands come from memories far away.
    let plan =
        [("operands", 1), ("products", 9), ("halves", 7), ("way", 7), ("position", 5), ("offset", 5), ("clamp", 4)];
    // At least one, as the valid bit beside it decides whether the pipeline moves.
    b.plan((d.latency.mul + d.latency.add + d.latency.hit).max(1), &plan);
    b.section("operands", "");
    let way = way(&b, s, t, &time, &reach);
    b.section("position", "");
    let at = position(&b, p, way, neg, &reach, None);

    b.section("offset", "");
    if let Some((lod, o_texel)) = lod.zip(o_texel) {
        let long = b.cat(&[at, b.zeros(&frac)]).named("position_long");
        b.unused(long);
        let fixed = long.slice(&f - &n, &idx + &frac).named("fixed");
        let ins = [("at", fixed), ("x", x), ("lod", lod)];
        let kept = b.inst(&node_hit(&d.traverse), "u_node_hit", &[("IDX_W", idx)], &ins);
        b.drive(out, kept["fraction"].named("kept"));
        b.drive(o_texel, kept["texel"].named("hit_texel"));
        return b.finish(&bindings());
    }
    // A bit below the point keeps the texel's corner wider than the texel; a sign bit holds the difference.
    let corner = b.cat(&[x, b.zeros(&f - &n + 1)]).named("corner");
    b.unused(corner.bit(0));
    let wide = &reach + 3;
    let corner = corner.slice(1, &reach + 2).named("corner_at");
    let off = (at.sext(wide.clone()) - corner.sext(wide.clone())).named("offset");
    b.section("clamp", "A hit on a wall lies exactly on a border: the integer texel decides, the fraction follows.");
    let past = off.slice(&f - &n, &idx + 1).any().named("past");
    let long = b.cat(&[off, b.zeros(&frac)]).named("offset_long");
    b.unused(long);
    let inside = long.slice(&f - &n, frac.clone()).named("low_part");
    let kept = off.msb().mux(b.zeros(&frac), past.mux(b.ones(&frac), inside)).named("kept");
    b.drive(out, kept);
    b.finish(&bindings())
}

/// How far the ray has come at `t`, rounded down, as the sum of products that are no wider than a multiplier.
fn way<'b>(b: &'b Builder, s: Sig<'b>, t: Sig<'b>, time: &Expr, reach: &Expr) -> Sig<'b> {
    b.section("products", "Each half of one by each half of the other.");
    let (s_w, t_w) = (reach + 1, time.clone());
    let s_low = b.local(
        "TravelLowW",
        Expr::from(18).smaller(&s_w - 1).smaller(time),
        "bits of the lower part of a travel: one operand of a multiplier",
    );
    let t_low = b.local(
        "TimeLowW",
        Expr::from(18).smaller(&t_w - 1),
        "bits of the lower part of a parameter: one operand of a multiplier",
    );
    let (s_high, t_high) = (&s_w - &s_low, &t_w - &t_low);
    let halves = |v: Sig<'b>, low: &Expr, high: &Expr| [v.slice(0, low), v.slice(low, high)];
    let (s, t) = (halves(s, &s_low, &s_high), halves(t, &t_low, &t_high));
    let product = |a: usize, c: usize| s[a].product(t[c]).named(&format!("product_{a}{c}"));
    let products = [product(0, 0), product(0, 1), product(1, 0), product(1, 1)];
    b.section("halves", "");
    // The lower half of t is below the sum that the upper one adds to.
    let half = |low: Sig<'b>, high: Sig<'b>, s_w: &Expr, net: &str| {
        let wide = s_w + &t_high;
        let sum = high + low.slice(&t_low, s_w).zext(&wide);
        b.cat(&[sum.named(&format!("{net}_sum")), low.slice(0, &t_low)]).named(net)
    };
    let low = half(products[0], products[1], &s_low, "low_half");
    let high = half(products[2], products[3], &s_high, "high_half");
    b.section("way", "");
    let wide = &s_high + &t_w;
    let sum = (high + low.slice(&s_low, &t_w).zext(&wide)).named("way_sum");
    b.unused(low.at(sum.stage().expect("a product has a stage")));
    b.unused(sum);
    // What lies below the point of s * t is cut off.
    let below = time - &s_low;
    sum.slice(below, reach + 1).named("way")
}
