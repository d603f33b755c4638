//! `window_constants`: once per ray and axis, what an iteration of a search by windows reads: the parameter of the first plane, that from plane to
//! plane, and the estimate's travel and offset (`docs/windows.md`, "Once per ray").
use super::params::{Estimate, FINE, Planes, Widths, bindings};
use crate::lzc::lzc;
use crate::quantity::{BIT, BITS, integer};
use crate::traversal::fixed::params::{LENGTH, shift_width};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Builds `window_constants`.
pub fn window_constants(d: &Design) -> Arc<Module> {
    let b = Builder::new("window_constants", file!(), "constants of a ray along an axis for a search by windows");
    let widths = Widths::new(&b, d);
    let f = widths.f.clone();
    let p = widths.planes();
    let reach = &f + &p.tile;
    let e = Estimate::of(&b, &f, &p.levels, &p.tile);
    let shift_w = b.local("ShiftW", shift_width(&reach), "bits of a shift");
    b.clock();
    b.clock_enable();
    let entry = b.input("p", &f, LENGTH, "entry point");
    let neg = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let r = b.input(
        "r",
        &p.w,
        integer("a number of RECIP_W bits"),
        "reciprocal of the travel: its top bit is 1, or it is 0",
    );
    let z = b.input("z", &shift_w, BITS, "its power of two");
    let s = b.input("s", &reach + 1, integer("2^-(FRACTION_W+HEIGHT_W) tiles"), "travel per height code");
    let o_q = b.output("q", &p.plane, FINE, "parameter from plane to plane; all ones: no plane is met but the first");
    let o_c = b.output("c", &p.plane, FINE, "parameter of the first plane; all ones: never");
    let o_s = b.output(
        "travel",
        &e.travel,
        integer("2^-(EstimateW+HEIGHT_W) texels"),
        "travel per height code, less its bias",
    );
    let o_o = b.output(
        "offset",
        &e.offset,
        integer("2^-EstimateW texels"),
        "how far in its texel the ray begins; its top bit is 0",
    );
    let plan =
        [("distance", 5), ("products", 9), ("product", 6), ("leading zeros", 5), ("align", 5), ("first plane", 2)];
    let clocks = d.latency.add + d.latency.mul + 1;
    b.plan(clocks, &plan);

    let (travel, offset) = estimate(&b, &f, &p, &e, entry, neg, s);
    b.drive(o_s, travel);
    b.drive(o_o, offset);
    b.section("step", "Of a ray that moves, r has its top bit set: how far it may be moved up does not depend on it.");
    let below = (&f - &p.levels).smaller(&p.w + &p.tile - 2);
    let extra =
        b.konst(&f - &p.levels - &below, 6).named("texel_shift").doc("how far a step is moved up at z = 0 [bits]");
    let room = b
        .konst(&p.levels + &p.tile, &shift_w)
        .named("range_bits")
        .doc("the largest z of a ray that meets a plane [bits]");
    let still = (!r.msb()).named("is_still");
    let far = (room.lt(z) | still).named("is_far");
    let step = r.zext(&p.plane).shift_left(extra).named("step_low").shift_left(z).named("step");
    let (step, far) = (step.reg_if(clocks > 1), far.reg_if(clocks > 1));
    b.drive(o_q, (step | far.rep(p.plane.clone())).named("step_plane"));

    let first = first_plane(&b, &f, &p, entry, neg, (r, z), still);
    b.drive(o_c, first);
    b.finish(&bindings())
}

/// The parameter of the first plane, of a ray that moves along this axis.
fn first_plane<'b>(
    b: &'b Builder,
    f: &Expr,
    p: &Planes,
    entry: Sig<'b>,
    neg: Sig<'b>,
    (r, z): (Sig<'b>, Sig<'b>),
    still: Sig<'b>,
) -> Sig<'b> {
    b.section("distance", "Of the first plane, along the ray.");
    let part = f - &p.levels;
    let dist_w = &part + 1;
    let inside = (entry.slice(0, &dist_w)
        & b.konst(part.pow2() - 1, &dist_w).named("texel_mask").doc("what a coordinate has below a texel, all ones"))
    .named("in_texel");
    let dist = neg.mux(inside, b.konst(part.pow2(), &dist_w).named("texel").doc("a texel") - inside).named("distance");
    b.section("products", "The reciprocal's low LowW bits and the rest of it, a product each.");
    let low_w =
        b.local("LowW", Expr::from(super::params::OPERAND).smaller(&p.w - 1), "bits of the lower part of an operand");
    let low = dist.product(r.slice(0, &low_w)).named("low_product");
    let high = dist.product(r.slice(&low_w, &p.w - &low_w)).named("high_product");
    b.section("product", "");
    // As many bits as the plane's parameter has, with what is cut off below.
    let total = f + &p.tile + &p.w;
    let below = b.local("BelowW", part.smaller(&p.w + &p.tile - 2), "bits of the product below a plane parameter");
    let carry =
        (high.zext(&dist_w + &p.w - &low_w) + low.slice(&low_w, &dist_w).zext(&dist_w + &p.w - &low_w)).named("upper");
    let product = b.cat(&[carry, low.slice(0, &low_w)]).zext(&total).named("product");
    b.section("leading zeros", "");
    let count = lzc(b, "u_lzc", product, "lz_count");
    b.section("align", "What is moved out at the top lies beyond the bottom plane.");
    let wide = count.width() + 1;
    let lost = count.zext(&wide).lt(z.zext(&wide)).named("is_lost");
    let moved = product.shift_left(z).named("moved");
    b.unused(moved);
    b.section("first plane", "");
    let never = (lost | still).named("is_never").rep(p.plane.clone());
    (moved.slice(below, &p.plane) | never).named("first_plane")
}

/// Travel and offset of the estimate.
fn estimate<'b>(
    b: &'b Builder,
    f: &Expr,
    p: &Planes,
    e: &Estimate,
    entry: Sig<'b>,
    neg: Sig<'b>,
    s: Sig<'b>,
) -> (Sig<'b>, Sig<'b>) {
    b.section(
        "estimate",
        "Less than the travel by more than a reciprocal that was rounded up adds to a plane's parameter.",
    );
    let from = f - &p.levels - &e.fraction;
    b.unused(s);
    b.unused(entry);
    let v = s.slice(from.clone(), &e.travel + 1).named("v");
    let tall = v.zext(&e.travel + 2).named("v_tall");
    let part = b
        .konst(p.w.smaller(&e.travel + 1), 6)
        .named("bias_shift")
        .doc("the reciprocal is too large by one part in 2^this at most");
    let less = (tall - b.lit(1, &e.travel + 2) - tall.shift_right(part)).named("v_less");
    b.unused(less.msb());
    let over = less.slice(&e.travel, 1).named("is_over");
    let travel =
        ((less.slice(0, &e.travel) | over.rep(e.travel.clone())) & v.any().rep(e.travel.clone())).named("travel");
    let low = entry.slice(from, &e.offset) ^ neg.rep(e.offset.clone());
    let offset = (low
        & b.konst(e.fraction.pow2() - 1, &e.offset).named("offset_mask").doc("the fraction bits of an offset"))
    .named("offset");
    (travel, offset)
}
