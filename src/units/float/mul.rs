//! `fp_mul`: the product of two numbers, rounded once.
//!
//! `p = MAN_W + 1`: one p x p multiplier. Whether its top bit is set decides where the significand stands, so both
//! candidates are rounded beside each other and one is picked. Each adds its guard bit, and a tie clears the last bit
//! afterwards, so that no carry chain waits for the OR of the lower half. Exponent and fraction round as one number.
//! Formats: `docs/datapath.md`.
use super::fields::{Fields, FormatParams};
use super::general;
use super::round::{Candidate, Classes};
use crate::quantity::FLOAT;
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Sections and how long each takes, in tenths of a nanosecond on ECP5.
const PLAN: &[(&str, u32)] = &[("operands", 10), ("multiply", 55), ("round", 30), ("select", 30)];
/// With registers after the multiplier besides: the first can stand beside the block, wherever the rest is.
const FIVE: &[(&str, u32)] = &[("operands", 10), ("multiply", 55), ("product", 55), ("round", 30), ("select", 30)];
/// And before it.
const DEEP: &[(&str, u32)] =
    &[("operands", 10), ("factors", 55), ("multiply", 55), ("product", 55), ("round", 30), ("select", 30)];

/// Builds `fp_mul` with `latency` clocks from operand to result.
pub fn fp_mul(format: FloatFormat, latency: u32) -> Arc<Module> {
    if !format.is_plain() {
        return general::fp_mul(format, latency);
    }
    let b = Builder::new(crate::float::names::MUL, file!(), "product of two floating-point numbers, rounded once");
    let f = FormatParams::declare(&b, format);
    let e_w = b.local("ExpSumW", &f.exp + 2, "bits of an exponent sum, with room for its sign");
    let p = b.local("SigW", &f.man + 1, "bits of a significand, the hidden one included");
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "first factor");
    let b_in = b.input("b", &f.width, FLOAT, "second factor");
    let out = b.output("result", &f.width, FLOAT, "a * b");
    let plan = match latency {
        0..=4 => PLAN,
        5 => FIVE,
        _ => DEEP,
    };
    b.plan(latency, plan);

    b.section("operands", "");
    let (fa, fb) = (Fields::of(&f, a_in, "a"), Fields::of(&f, b_in, "b"));
    // The bias is one less than a power of two: a carry in and a change of the top bits, no second sum.
    let halves = [fa.exp, fb.exp].map(|e| b.cat(&[e.zext(&e_w), b.lit(1, 1)]));
    let exp_sum = (halves[0] + halves[1]).named("exp_sum");
    b.unused(exp_sum.bit(0));
    let exp_top = exp_sum.slice(&f.exp, 3) - b.lit(1, 3);
    let exp_low = b.cat(&[exp_top.named("exp_top"), exp_sum.slice(1, &f.exp - 1)]).named("exp_low");

    b.section("factors", "");
    b.section("multiply", "The hidden bit is 1 for every operand: a zero operand overrides the result instead.");
    let sa = b.cat(&[b.lit(1, 1), fa.frac]);
    let sb = b.cat(&[b.lit(1, 1), fb.frac]);
    let prod = sa.product(sb).named("prod");
    let exp_high = (exp_low + b.lit(1, &e_w)).named("exp_high");
    let zero = (fa.is_zero | fb.is_zero).named("is_zero");
    let inf = (fa.is_inf | fb.is_inf).named("is_inf");
    let nan = (fa.is_nan | fb.is_nan | (zero & inf)).named("is_nan");
    let sign = (fa.sign ^ fb.sign).named("prod_sign");

    b.section("product", "");
    b.section(
        "round",
        "A product of two numbers in [1, 2) lies in [1, 4): low below 2, high from 2 on. A carry out of the fraction \
         continues into the exponent, and from the largest number to infinity, by itself.",
    );
    let low = candidate(&b, &f, prod, &(&p - 1), exp_low, "low");
    let high = candidate(&b, &f, prod, &p, exp_high, "high");
    let top = prod.msb().named("top");

    b.section("select", "");
    let picked = Candidate::pick(top, &high, &low);
    let value = picked.pack(&b, &f, sign, &Classes { nan, inf, zero });
    b.drive(out, value);
    b.finish(&super::bindings())
}

/// The result if the significand's last bit is bit `lsb` of the product.
fn candidate<'b>(
    b: &'b Builder,
    f: &FormatParams,
    prod: Sig<'b>,
    lsb: &Expr,
    exp: Sig<'b>,
    name: &str,
) -> Candidate<'b> {
    let guard = prod.bit(lsb.clone() - 1).named(&format!("{name}_guard"));
    let tie = guard & prod.slice(0, lsb.clone() - 1).none();
    Candidate::of(b, f, exp, prod.slice(lsb, &f.man), guard, Some(tie), name)
}
