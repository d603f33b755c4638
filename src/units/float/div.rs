//! `fp_div`: the quotient of two numbers, rounded once.
//!
//! Restoring digit recurrence, `p + 2` rows for `p = MAN_W + 1`. The quotient of two p-bit significands is never a tie
//! (a tie would have p + 1 significant bits, and times the divisor it would not fit the dividend), so one guard bit
//! decides and no sticky bit is needed. Rows are spread over the stages.
use super::fields::{Fields, FormatParams};
use super::round::{Special, Unrounded, round_pack};
use crate::format::FloatFormat;
use crate::ir::{Builder, Expr, Module};
use crate::units::div_rows::div_rows;
use std::sync::Arc;

/// Builds `fp_div` with `latency` clocks from operand to result.
pub fn fp_div(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new("fp_div", file!(), "quotient of two floating-point numbers, rounded once");
    let f = FormatParams::declare(&b, format);
    let e_w = b.local("ExpSumW", &f.exp + 2);
    let p = b.local("SigW", &f.man + 1);
    let rows = b.local("QuotW", &p + 2);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, "float", "dividend");
    let b_in = b.input("b", &f.width, "float", "divisor");
    let out = b.output("result", &f.width, "float", "a / b");
    let chunks = latency.clamp(1, format.man + 3);
    b.require(chunks.saturating_sub(3), &f.man);
    let titles: Vec<String> = (0..chunks).map(|c| format!("rows {c}")).collect();
    let mut plan: Vec<(&str, u32)> = titles.iter().map(|t| (t.as_str(), 60 / chunks + 1)).collect();
    plan.push(("round", 5));
    b.plan(latency, &plan);

    b.section("classes", "The hidden bit is 1 for every operand: a zero operand overrides the result instead.");
    let (fa, fb) = (Fields::of(&f, a_in, "a"), Fields::of(&f, b_in, "b"));
    let sign = (fa.sign ^ fb.sign).named("quot_sign");
    let bias = b.konst(f.bias(), &e_w).named("bias");
    let exp0 = (fa.exp.zext(&e_w) - fb.exp.zext(&e_w) + bias).named("quot_exp");
    let inf = ((fa.is_inf | fb.is_zero) & !fb.is_inf & !fa.is_zero).named("is_inf");
    let zero = ((fa.is_zero | fb.is_inf) & !fa.is_inf & !fb.is_zero).named("is_zero");
    let same = (fa.is_zero & fb.is_zero) | (fa.is_inf & fb.is_inf);
    let nan = (fa.is_nan | fb.is_nan | same).named("is_nan");
    let div = b.cat(&[b.lit(1, 1), fb.frac]).named("divisor");
    let mut rem = b.cat(&[b.lit(1, 2), fa.frac]).named("rem");
    let mut quot = None;
    for (c, title) in titles.iter().enumerate() {
        b.section(title, "Rows of compare, subtract, double: one quotient bit each, the integer bit first.");
        let at = |k: i64| if k == i64::from(chunks) { rows.clone() } else { (rows.clone() * k).div(chunks) };
        let count: Expr = if c == 0 { at(1) } else { at(c as i64 + 1) - at(c as i64) };
        let (r, q) = div_rows(&b, &format!("u_rows_{c}"), rem, div, &p, &count, c);
        rem = r;
        quot = Some(match quot {
            None => q,
            Some(before) => b.cat(&[before, q]).named(&format!("quot_{c}")),
        });
    }
    b.unused(rem);
    let quot = quot.expect("at least one chunk of rows");

    b.section(
        "round",
        "The quotient lies in (1/2, 2): its integer bit picks the significand. No quotient lies half-way between two \
         numbers, so the guard bit alone rounds.",
    );
    let top = quot.msb().named("top");
    let exp = (exp0 - (!top).zext(&e_w)).named("norm_exp");
    let sig = top.mux(quot.slice(2, p.clone()), quot.slice(1, p.clone())).named("sig");
    let guard = top.mux(quot.bit(1), quot.bit(0)).named("guard");
    let x = Unrounded { sign, exp, sig, guard, sticky: None };
    let s = Special { nan: Some(nan), inf: Some(inf), inf_sign: None, zero, zero_sign: None };
    let packed = round_pack(&b, &f, &x, &s);
    b.drive(out, packed, Some(latency));
    b.finish(Some(latency), &super::bindings())
}
