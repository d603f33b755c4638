//! `predicted_hit`: the texel coordinate, along one axis, that the ray has reached at parameter m; never ahead of it.
//!
//! The reciprocal, and with it a plane's parameter, may be too large by one part in 2^RECIP_W; a parameter smaller by as much
//! makes up for it, and everything else is rounded down (`docs/fixed.md`).
use super::params::{LENGTH, Params, TIME, bindings, time_width};
use crate::quantity::{BIT, TEXELS, integer};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Builds `predicted_hit`.
pub fn predicted_hit(d: &Design) -> Arc<Module> {
    let b = Builder::new("predicted_hit", file!(), "texel coordinate reached at parameter m, rounded backwards");
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
    let m = b.input("m", &time, TIME, "parameter");
    let out = b.output("e", &idx, TEXELS, "signed coordinate");
    b.plan(d.latency.mul + d.latency.add.min(1), &[("way", 10), ("position", 4)]);
    b.section("way", "");
    // A bit more, so that the shift never is as wide as its word and still can leave nothing.
    let tall = b.cat(&[b.zeros(1), m]).named("m_tall");
    let recip_bits = b
        .konst(w.smaller(&time), 6)
        .named("recip_bits")
        .doc("the reciprocal is too large by one part in 2^this at most");
    let less = (tall - tall.shift_right(recip_bits)).named("m_less");
    b.unused(less.msb());
    let early = less.slice(0, &time).named("early");
    let way = way(&b, s, early, &time, &reach);
    b.section("position", "");
    let at = position(&b, p, way, neg, &reach, None);
    b.unused(at);
    b.drive(out, at.slice(&f - &n, idx).named("texel"));
    b.finish(&bindings())
}

/// How far the ray has come at `t`, rounded down: a word of `reach` bits and one more.
pub(super) fn way<'b>(b: &'b Builder, s: Sig<'b>, t: Sig<'b>, time: &Expr, reach: &Expr) -> Sig<'b> {
    let prod = s.product(t).named("prod");
    b.unused(prod.slice(0, time));
    prod.slice(time, reach + 1).named("way")
}

/// `p + way`, or `p - way` as the complement of `~p + way`; signed. A ray is `further` on by one, if that is asked for.
pub(super) fn position<'b>(
    b: &'b Builder,
    p: Sig<'b>,
    way: Sig<'b>,
    neg: Sig<'b>,
    reach: &Expr,
    further: Option<Sig<'b>>,
) -> Sig<'b> {
    let wide = reach + 2;
    let flip = neg.rep(wide.clone()).named("flip");
    let start = (b.cat(&[b.zeros(&wide - p.width()), p]) ^ flip).named("start");
    let mut end = start + b.cat(&[b.zeros(1), way]);
    if let Some(further) = further {
        end = end + further.zext(&wide);
    }
    (end.named("end_flipped") ^ flip).named("position")
}
