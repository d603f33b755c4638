//! `fp_mul` at any choice of rounding, subnormals and specials.
use super::super::fields::FormatParams;
use super::{Classes, Exact, Operand, Range, any, exponent_width, round};
use crate::quantity::FLOAT;
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `fp_mul` with `latency` clocks from operand to result.
pub fn fp_mul(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new(crate::float::names::MUL, file!(), "product of two floating-point numbers, rounded once");
    let f = FormatParams::declare(&b, format);
    let e_w = exponent_width(&b, &f);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "first factor");
    let b_in = b.input("b", &f.width, FLOAT, "second factor");
    let out = b.output("result", &f.width, FLOAT, "a * b");
    let flat = [("multiply", 55), ("normalize", 12), ("round", 30), ("select", 20)];
    let gradual = [("operands", 50), ("multiply", 45), ("normalize", 12), ("shift", 35), ("round", 30), ("select", 20)];
    b.plan(latency, if format.is_gradual() { &gradual } else { &flat });

    b.section("operands", "");
    let (fa, fb) = (Operand::of(&b, &f, a_in, "a"), Operand::of(&b, &f, b_in, "b"));
    let ((ea, sa), (eb, sb)) = (fa.normalized(&e_w), fb.normalized(&e_w));
    let zero = (fa.zero() | fb.zero()).named("is_zero");
    let inf = any(&[fa.inf(), fb.inf()]).map(|s| s.named("is_inf"));
    let nan = any(&[fa.nan(), fb.nan(), inf.map(|i| i & zero)]).map(|s| s.named("is_nan"));
    let sign = (fa.sign ^ fb.sign).named("prod_sign");

    b.section("multiply", "");
    let prod = sa.product(sb).named("prod");
    let bias = b.konst(f.bias(), &e_w).named("bias").doc("the exponent bias");
    let sum = (ea + eb - bias).named("exp_sum");

    b.section("normalize", "A product of two numbers in [1, 2) lies in [1, 4).");
    let top = prod.msb().named("top");
    let norm = top.mux(prod, b.cat(&[prod.slice(0, &f.man + &f.man + 1), b.zeros(1)])).named("norm");
    let exp = (sum + top.zext(&e_w)).named("norm_exp");
    let (guard, sticky) = (norm.bit(&f.man).named("guard"), norm.slice(0, &f.man).any().named("sticky"));
    let x = Exact { sign, exp, sig: norm.slice(&f.man + 1, &f.man + 1).named("sig"), guard, sticky };
    let value = round(&b, &f, x, Range::Any, &Classes { nan, inf, zero: Some(zero) });
    b.drive(out, value);
    b.finish(&super::super::bindings())
}
