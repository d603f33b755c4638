//! `fp_mul`: the product of two numbers, rounded once.
//!
//! `p = MAN_W + 1`: one p x p multiplier; its top bit picks which p bits are the significand. Formats: `docs/datapath.md`.
use super::fields::{Fields, FormatParams};
use super::round::{Special, Unrounded, round_pack};
use crate::format::FloatFormat;
use crate::ir::{Builder, Module};
use std::sync::Arc;

/// Builds `fp_mul` with `latency` clocks from operand to result.
pub fn fp_mul(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new("fp_mul", file!(), "product of two floating-point numbers, rounded once");
    let f = FormatParams::declare(&b, format);
    let e_w = b.local("ExpSumW", &f.exp + 2);
    let p = &f.man + 1;
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, "float", "first factor");
    let b_in = b.input("b", &f.width, "float", "second factor");
    let out = b.output("result", &f.width, "float", "a * b");
    b.plan(latency, &[("multiply", 8), ("normalize", 2), ("round", 6)]);

    b.section("multiply", "The hidden bit is 1 for every operand: a zero operand overrides the result instead.");
    let (fa, fb) = (Fields::of(&f, a_in, "a"), Fields::of(&f, b_in, "b"));
    let sign = (fa.sign ^ fb.sign).named("prod_sign");
    let sa = b.cat(&[b.lit(1, 1), fa.frac]);
    let sb = b.cat(&[b.lit(1, 1), fb.frac]);
    let prod = sa.product(sb).named("prod");
    let bias = b.konst(f.bias(), &e_w).named("bias");
    let exp0 = (fa.exp.zext(&e_w) + fb.exp.zext(&e_w) - bias).named("prod_exp");
    let zero = (fa.is_zero | fb.is_zero).named("is_zero");
    let inf = (fa.is_inf | fb.is_inf).named("is_inf");
    let nan = (fa.is_nan | fb.is_nan | (zero & inf)).named("is_nan");

    b.section("normalize", "A product of two numbers in [1, 2) lies in [1, 4).");
    let top = prod.msb().named("top");
    let exp = (exp0 + top.zext(&e_w)).named("norm_exp");
    let norm = top.mux(prod.slice(1, &p + &p - 1), prod.slice(0, &p + &p - 1)).named("norm");
    let lost = (top & prod.bit(0)).named("lost");

    b.section("round", "");
    let sig = norm.slice(&p - 1, p.clone()).named("sig");
    let guard = norm.bit(&p - 2);
    let sticky = norm.slice(0, &p - 2).any() | lost;
    let x = Unrounded { sign, exp, sig, guard, sticky: Some(sticky.named("sticky")) };
    let s = Special { nan: Some(nan), inf: Some(inf), inf_sign: None, zero, zero_sign: None };
    let packed = round_pack(&b, &f, &x, &s);
    b.drive(out, packed, Some(latency));
    b.finish(Some(latency), &super::bindings())
}
