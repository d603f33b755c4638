//! `plane_product`: k times the parameter from plane to plane, as two products that are no wider than a multiplier.
use super::params::{FINE, OPERAND, PLANES, Planes, Widths, bindings};
use crate::quantity::integer;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Module};
use std::sync::Arc;

/// Clocks of the multipliers: their half of a multiplication.
pub fn multiplier_clocks(d: &Design) -> u32 {
    d.latency.mul.div_ceil(2)
}

/// Bits of a plane's parameter that the lower multiplier takes.
pub fn low_width(p: &Planes) -> Expr {
    Expr::from(OPERAND).smaller(&p.plane - 1)
}

/// Builds `plane_product`.
pub fn plane_product(d: &Design) -> Arc<Module> {
    let b = Builder::new("plane_product", file!(), "k times the parameter from plane to plane, as two products");
    let p = Widths::new(&b, d).planes();
    let low_w = b.local("LowW", low_width(&p), "bits of the lower part of an operand");
    b.clock();
    b.clock_enable();
    let k = b.input("k", &p.count, PLANES, "planes that the ray has passed");
    let q = b.input("q", &p.plane, FINE, "parameter from plane to plane");
    let low = b.output("low", &p.count + &low_w, FINE, "k times the lower bits of q");
    let high = b.output("high", &p.count + &p.plane - &low_w, integer("2^LowW of low"), "k times its upper bits");
    b.at_least(multiplier_clocks(d));
    b.drive(low, k.product(q.slice(0, &low_w)).named("low_product"));
    b.drive(high, k.product(q.slice(&low_w, &p.plane - &low_w)).named("high_product"));
    b.finish(&bindings())
}
