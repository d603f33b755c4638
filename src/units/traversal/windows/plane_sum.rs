//! `plane_sum`: the parameter of the plane ahead of the texel, C + kQ, and whether it has more bits than that.
use super::params::{FINE, Widths, bindings};
use super::plane_product::low_width;
use crate::quantity::integer;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `plane_sum`.
pub fn plane_sum(d: &Design) -> Arc<Module> {
    let b = Builder::new("plane_sum", file!(), "parameter of the plane ahead: that of the first plane and k steps");
    let p = Widths::new(&b, d).planes();
    let low_w = b.local("LowW", low_width(&p), "bits of the lower part of an operand");
    b.clock();
    b.clock_enable();
    let c = b.input("c", &p.plane, FINE, "parameter of the first plane");
    let low = b.input("low", &p.count + &low_w, FINE, "k times the lower bits of q");
    let high = b.input("high", &p.count + &p.plane - &low_w, integer("2^LowW of low"), "k times its upper bits");
    let out = b.output("plane", &p.plane + 1, FINE, "the parameter; top bit 1: beyond all that a word holds");
    b.plan(d.latency.add.min(2), &[("lower product", 7), ("upper product", 7)]);
    b.section("lower product", "");
    let tall = b.local("StartW", (&p.plane + 1).larger(&p.count + &low_w + 1), "bits of the sum of the lower product");
    let start = (c.zext(&tall) + low.zext(&tall)).named("start");
    b.section("upper product", "All bits above a word are one: such a plane is never met.");
    let upper_w = &p.plane + &p.count + 1 - &low_w;
    let upper = high.zext(&upper_w) + start.slice(&low_w, &tall - &low_w).zext(&upper_w);
    let upper = upper.named("upper");
    let rest = &p.plane - &low_w;
    let beyond = upper.slice(&rest, &p.count + 1).any().named("is_beyond");
    let plane = b.cat(&[beyond, upper.slice(0, rest), start.slice(0, &low_w)]).named("plane_ahead");
    b.drive(out, plane);
    b.finish(&bindings())
}
