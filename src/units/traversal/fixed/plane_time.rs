//! `plane_time`: the ray parameter of a plane, distance times reciprocal, rounded down. The same formula for every level, so it
//! is a monotone function of the integer plane: what makes the traversal watertight (`docs/fixed.md`).
use super::params::{GUARD, LENGTH, Params, TIME, bindings, shift_width, time_width};
use crate::lzc::lzc;
use crate::quantity::{BIT, BITS, TEXELS, integer};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `plane_time`.
pub fn plane_time(d: &Design) -> Arc<Module> {
    let b = Builder::new("plane_time", file!(), "ray parameter at which the ray meets a plane: |plane - p| * r");
    let of = Params { b: &b, d };
    let f = of.fraction();
    let w = of.recip();
    let n = of.levels(&f);
    let (tile, reach) = of.reach(&f);
    b.require(&reach + &w, 63);
    let idx = of.index(&n, &tile);
    let shift_w = b.local("ShiftW", shift_width(&reach), "bits of a shift");
    let dist_w = b.local("DistW", &reach + 1, "bits of the distance of a plane");
    let time = b.local("TimeW", time_width(&f), "bits of a ray parameter");
    b.clock();
    b.clock_enable();
    let plane = b.input("plane", &idx, TEXELS, "coordinate of the plane, signed; not passed yet");
    let p = b.input("p", &f, LENGTH, "coordinate of the entry point");
    let neg = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let r = b.input("r", &w, integer("a number of RECIP_W bits"), "reciprocal of the travel");
    let z = b.input("z", &shift_w, BITS, "its power of two");
    let out = b.output("t", &time, TIME, "all ones: not before the bottom plane");
    b.plan(d.latency.add + d.latency.mul, &[("distance", 5), ("align", 5), ("multiply", 10)]);

    b.section(
        "distance",
        "Along the ray's direction, so never negative; one bit below the point keeps all widths above 0.",
    );
    let at = b.cat(&[plane.slice(0, &idx - 1), b.zeros(&f - &n + 1)]).named("plane_at");
    let from = b.cat(&[b.zeros(&tile + 1), p, b.zeros(1)]).named("p_at");
    let away = (neg.mux(from, at) - neg.mux(at, from)).named("away");
    b.unused(plane.msb());
    b.unused(away.bit(0));
    let dist = away.slice(1, dist_w.clone()).named("distance");

    b.section("align", "What is moved out at the top is more than the ray travels in all.");
    let count = lzc(&b, "u_lzc", dist, "lz_count");
    let far = count.lt(z).named("is_far");
    let moved = dist.shift_left(z).named("moved");

    b.section("multiply", "A parameter beyond the bottom plane stays at all ones.");
    let prod = moved.product(r).named("prod");
    let below = &w + &tile - GUARD;
    b.unused(prod.slice(0, below.clone()));
    let t = prod.slice(below, &time + 1).named("product");
    let beyond = (far | t.msb()).named("is_beyond");
    let met = (t.slice(0, &time) | beyond.rep(time.clone())).named("plane_parameter");
    b.drive(out, met);
    b.finish(&bindings())
}
