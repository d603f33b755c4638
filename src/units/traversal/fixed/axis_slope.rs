//! `axis_slope`: a ray's constants along one axis, from entry point and travel. What each is, to the bit: `docs/fixed.md`, "Once per ray".
use super::params::{LENGTH, Params, bindings, shift_width};
use super::reciprocal::reciprocal;
use crate::quantity::{BIT, BITS, Quantity, TEXELS, integer};
use reliefrtl_config::{Design, Register, Trim};
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Unit of a travel per height code.
pub const PER_CODE: Quantity = integer("2^-(FRACTION_W+HEIGHT_W) tiles");

/// Builds `axis_slope`.
pub fn axis_slope(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("axis_slope", file!(), "a ray's constants along one axis: travel per height code, its reciprocal");
    let of = Params { b: &b, d };
    let f = of.fraction();
    let w = of.recip();
    let trims = d.mode.trim != Trim::None;
    let n = trims.then(|| of.levels(&f));
    let h = of.height(&f);
    let (tile, reach) = of.reach(&f);
    let farthest = n.map(|n| Farthest { idx: of.index(&n, &tile), below: &f - n, f: f.clone(), w: w.clone() });
    b.clock();
    b.clock_enable();
    let p = trims.then(|| b.input("p", &f, LENGTH, "entry point"));
    let travel =
        b.input("d", &reach + 1, LENGTH, "travel down to the bottom plane, signed; the most negative word counts as 0");
    let o_s = b.output("s", &reach + 1, PER_CODE, "travel per height code, its magnitude");
    let o_r = b.output("r", &w, integer("a number of RECIP_W bits"), "reciprocal of the travel");
    let o_z = b.output("z", shift_width(&reach), BITS, "its power of two");
    let o_neg = b.output("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let o_farthest =
        farthest.as_ref().map(|at| b.output("farthest", &at.idx, TEXELS, "a texel that the ray does not get beyond"));

    b.section("magnitude", "");
    let neg = travel.msb().named("is_neg").doc("the travel is negative");
    let low = travel.slice(0, reach.clone()).named("travel_low").doc("the travel without its sign");
    b.drive(o_neg, neg);
    let a = (low ^ neg.rep(reach.clone())) + b.cat(&[b.zeros(&reach - 1), neg]);
    let a = a.named("magnitude").doc("the travel's magnitude [2^-FRACTION_W tiles]");
    // The loop of a search by windows is faster than a sum and a count of zeros in series.
    let a = a.reg_if(d.datapath.kind.facts().short_loop && d.latency.has(Register::Travel));

    b.section("slope", "Height codes per length, and lengths per height code: the travel times 2^HEIGHT_W / M.");
    let o = b.inst(&reciprocal(d), "u_reciprocal", &[], &[("a", a)]);
    let r = o["r"].named("recip").doc("reciprocal of the magnitude, times M");
    b.drive(o_r, r);
    b.drive(o_z, o["z"].named("recip_shift").doc("its power of two [bits]"));
    b.drive(o_s, per_code(&b, &h, &reach, a, r));
    if let Some((at, port)) = farthest.zip(o_farthest) {
        b.drive(port, at.texel(&b, &reach, p.expect("a trim takes the entry point"), a, neg));
    }
    b.finish(&bindings())
}

/// The travel per height code, by four sums; with a register after each, as long as the reciprocal `r` takes longer.
fn per_code<'b>(b: &'b Builder, h: &Expr, reach: &Expr, a: Sig<'b>, r: Sig<'b>) -> Sig<'b> {
    let mut sum = a.zext(reach + 2).named("sum_0").doc("the magnitude");
    for k in 0..4u32 {
        // 2^h / M = 1 / (1 - 2^-h) = (1 + 2^-h) (1 + 2^-2h) (1 + 2^-4h) (1 + 2^-8h) ...
        // A bit more than the sum needs, so that a shift never is as wide as its word and still can leave nothing.
        let (codes, by) = (1 << k, (h.clone() * (1 << k)).smaller(reach + 1));
        let by = b.konst(by, 8).named(&format!("shift_{codes}")).doc(&format!("{codes} times the bits of a code"));
        let next = (sum + sum.shift_right(by)).named(&format!("sum_{}", k + 1));
        sum = next.doc(&format!("sum_{k} times 1 + 2^-({codes} HEIGHT_W), rounded down"));
        if k < 3 && sum.stage().is_some_and(|stage| Some(stage + 1) < r.stage()) {
            sum = sum.reg();
        }
    }
    b.unused(sum.msb());
    sum.slice(0, reach + 1).named("per_code").doc("travel per height code [2^-(FRACTION_W+HEIGHT_W) tiles]")
}

/// Where a ray ends at most.
struct Farthest {
    f: Expr,
    w: Expr,
    /// Bits of a coordinate below a texel.
    below: Expr,
    /// Bits of a texel index.
    idx: Expr,
}

impl Farthest {
    /// A texel that the ray does not get beyond, by the parameters of its planes.
    fn texel<'b>(self, b: &'b Builder, reach: &Expr, p: Sig<'b>, a: Sig<'b>, neg: Sig<'b>) -> Sig<'b> {
        b.section(
            "farthest",
            "The travel, and more than what the reciprocal and the rounding of a parameter add to it. No travel stays none.",
        );
        let wide = reach + 2;
        let tall = a.zext(wide.clone()).named("magnitude_wide").doc("the magnitude, with room for the sum");
        let part = |by: Expr, net: &str, doc: &str| tall.shift_right(b.konst(by.smaller(reach), 6).named(net).doc(doc));
        let recip = part(&self.w - 1, "recip_part", "the reciprocal is too small by one part in 2^this at most");
        let time = part(&self.f + 1, "time_part", "the rounding of a parameter takes one part in 2^this at most");
        let whole = (tall + recip + time + a.any().zext(&wide)).named("farthest_travel");
        let whole = whole.doc("more than the ray travels [2^-FRACTION_W tiles]");
        let flip = neg.rep(wide.clone()).named("mirror").doc("ones where the ray runs toward smaller coordinates");
        // Toward smaller coordinates a texel is left when the ray is at its border.
        let end = (b.cat(&[b.zeros(&wide - &self.f), p]) ^ flip) + whole + neg.zext(&wide);
        let end = end.named("farthest_mirrored").doc("the end, along the direction [2^-FRACTION_W tiles]");
        let end = (end ^ flip).named("farthest_end").doc("the end [2^-FRACTION_W tiles]");
        b.unused(end);
        end.slice(self.below, self.idx).named("farthest_texel").doc("floor of farthest_end [texels]")
    }
}
