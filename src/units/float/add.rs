//! `fp_add`: the sum of two numbers, rounded once. Subtract by flipping the sign bit of `b`.
//!
//! Single path, `p = MAN_W + 1`: order by magnitude, align the smaller with guard, round and sticky bits
//! (p + 3 bits), add or subtract, count leading zeros, shift, round. PIDM-HW section 4.3 gives the format only;
//! rounding and specials are this project's (`docs/datapath.md`).
use super::fields::{Fields, FormatParams};
use super::round::{Special, Unrounded, round_pack};
use crate::format::FloatFormat;
use crate::ir::{Builder, Module};
use crate::units::lzc::lzc;
use std::sync::Arc;

/// Builds `fp_add` with `latency` clocks from operand to result.
pub fn fp_add(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b =
        Builder::new("fp_add", file!(), "sum of two floating-point numbers, rounded once; flip b's sign to subtract");
    let f = FormatParams::declare(&b, format);
    let sig_w = b.local("SigW", &f.man + 4);
    let lz_w = b.local("LzW", (&sig_w + 2).clog2());
    let e_w = b.local("ExpSumW", f.exp.larger(&lz_w) + 2);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, "float", "first operand");
    let b_in = b.input("b", &f.width, "float", "second operand");
    let out = b.output("result", &f.width, "float", "a + b");
    b.plan(latency, &[("order", 4), ("align", 6), ("add", 4), ("normalize", 8), ("round", 6)]);

    b.section(
        "order",
        "The operand of larger magnitude comes first, so the difference of the significands is not negative.",
    );
    let (fa, fb) = (Fields::of(&f, a_in, "a"), Fields::of(&f, b_in, "b"));
    let (sig_a, sig_b) = (fa.significand(&b, "a_sig"), fb.significand(&b, "b_sig"));
    let mag_w = &f.exp + &f.man;
    let swap = a_in.slice(0, mag_w.clone()).lt(b_in.slice(0, mag_w)).named("swap");
    let big_sign = swap.mux(fb.sign, fa.sign).named("big_sign");
    let big_exp = swap.mux(fb.exp, fa.exp).named("big_exp");
    let small_exp = swap.mux(fa.exp, fb.exp).named("small_exp");
    let big_sig = swap.mux(sig_b, sig_a).named("big_sig");
    let small_sig = swap.mux(sig_a, sig_b).named("small_sig");
    let subtract = (fa.sign ^ fb.sign).named("subtract");
    let nan = (fa.is_nan | fb.is_nan | (fa.is_inf & fb.is_inf & subtract)).named("is_nan");
    let inf = (fa.is_inf | fb.is_inf).named("is_inf");
    let inf_sign = fa.is_inf.mux(fa.sign, fb.sign).named("inf_sign");
    let both_minus = (fa.sign & fb.sign).named("both_minus");

    b.section(
        "align",
        "Three bits below the significand, the last one sticky, are enough to round a sum or difference.",
    );
    let shift = (big_exp - small_exp).named("shift");
    let small_ext = b.cat(&[small_sig, b.zeros(3)]).named("small_ext");
    let shifted = small_ext.shift_right(shift).named("shifted");
    let lost = (small_ext & !b.ones(&sig_w).shift_left(shift)).any().named("lost");
    let aligned = b.cat(&[shifted.slice(1, &sig_w - 1), shifted.bit(0) | lost]).named("aligned");

    b.section("add", "");
    let x = b.cat(&[b.zeros(1), big_sig, b.zeros(3)]).named("augend");
    let y = aligned.zext(&sig_w + 1).named("addend");
    let sum = subtract.mux(x - y, x + y).named("sum");

    b.section("normalize", "");
    let lz = lzc(&b, "u_lzc", sum, "lead");
    let norm = sum.shift_left(lz).named("norm");
    let exp = (big_exp.zext(&e_w) + b.lit(1, &e_w) - lz.zext(&e_w)).named("norm_exp");
    let is_zero = norm.msb();
    let is_zero = (!is_zero).named("sum_is_zero");

    b.section("round", "");
    let sig = norm.slice(4, &f.man + 1).named("sig");
    let guard = norm.bit(3);
    let sticky = norm.slice(0, 3).any();
    let x = Unrounded { sign: big_sign, exp, sig, guard, sticky: Some(sticky) };
    let (nan, inf, inf_sign, zero_sign) = (Some(nan), Some(inf), Some(inf_sign), Some(both_minus));
    let s = Special { nan, inf, inf_sign, zero: is_zero, zero_sign };
    let packed = round_pack(&b, &f, &x, &s);
    b.drive(out, packed, Some(latency));
    b.finish(Some(latency), &super::bindings())
}
