//! `fp_add` at any choice of rounding, subnormals and specials: one path.
use super::super::fields::FormatParams;
use super::{Classes, Exact, Operand, Range, any, exponent_width, round};
use crate::lzc::lzc;
use crate::quantity::FLOAT;
use reliefrtl_base::format::{FloatFormat, Rounding};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Sections and how long each takes, in tenths of a nanosecond on ECP5.
const PLAN: &[(&str, u32)] = &[
    ("compare", 30),
    ("order", 12),
    ("align", 28),
    ("add", 28),
    ("count", 20),
    ("normalize", 25),
    ("round", 30),
    ("select", 20),
];

/// Builds `fp_add` with `latency` clocks from operand to result.
pub fn fp_add(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new(
        crate::float::names::ADD,
        file!(),
        "sum of two floating-point numbers, rounded once; flip b's sign to subtract",
    );
    let f = FormatParams::declare(&b, format);
    let e_w = exponent_width(&b, &f);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "first operand");
    let b_in = b.input("b", &f.width, FLOAT, "second operand");
    let out = b.output("result", &f.width, FLOAT, "a + b");
    b.plan(latency, PLAN);

    b.section("compare", "");
    let (fa, fb) = (Operand::of(&b, &f, a_in, "a"), Operand::of(&b, &f, b_in, "b"));
    let mag_w = &f.exp + &f.man;
    let swap = a_in.slice(0, &mag_w).lt(b_in.slice(0, &mag_w)).named("swap");
    let (a_sig, b_sig, a_weight, b_weight) = (fa.sig(), fb.sig(), fa.weight(), fb.weight());
    let (exp_diff_ab, exp_diff_ba) =
        ((a_weight - b_weight).named("exp_diff_ab"), (b_weight - a_weight).named("exp_diff_ba"));
    let subtract = (fa.sign ^ fb.sign).named("subtract");
    let inf = any(&[fa.inf(), fb.inf()]).map(|s| s.named("is_inf"));
    let both = (!format.is_finite()).then(|| fa.exp.all() & fb.exp.all() & subtract);
    let nan = any(&[fa.nan(), fb.nan(), both]).map(|s| s.named("is_nan"));
    let (a_sign, b_sign) = (fa.sign, fb.sign);

    b.section(
        "order",
        "The operand of larger magnitude comes first, so the difference of the significands is not negative.",
    );
    let large_sign = swap.mux(b_sign, a_sign).named("large_sign");
    let large_exp = swap.mux(b_weight, a_weight).named("large_exp");
    let (large, small) = (swap.mux(b_sig, a_sig).named("large_sig"), swap.mux(a_sig, b_sig).named("small_sig"));
    let shift = swap.mux(exp_diff_ba, exp_diff_ab).named("shift");

    b.section("align", "Two bits below the significand and a sticky one are enough to round a sum or difference.");
    let wide = b.cat(&[small, b.zeros(2)]).named("unaligned");
    let lost = (wide & !b.ones(wide.width()).shift_left(shift)).any().named("lost");
    let aligned = wide.shift_right(shift).named("aligned");

    b.section("add", "");
    let x = b.cat(&[b.zeros(1), large, b.zeros(3)]).named("augend");
    let y = b.cat(&[b.zeros(1), aligned, lost]).named("addend");
    let sum = subtract.mux(x - y, x + y).named("sum");

    b.section("count", "");
    let count = lzc(&b, "u_lzc", sum, "lz_count");
    let none = sum.none().named("sum_is_zero");

    b.section("normalize", "Up to a leading one; where subnormals are numbers, not beyond their exponent.");
    let top = (large_exp.zext(&e_w) + b.lit(1, &e_w)).named("top_exp");
    let (exp, up) = if format.is_gradual() {
        let most = large_exp.zext(&e_w);
        let count = count.zext(&e_w);
        let short = most.lt(count).named("short");
        (short.mux(b.lit(1, &e_w), top - count).named("exp"), short.mux(most, count).named("up"))
    } else {
        ((top - count.zext(&e_w)).named("exp"), count)
    };
    let norm = sum.shift_left(up).named("norm");
    let (guard, sticky) = (norm.bit(3).named("guard"), norm.slice(0, 3).any().named("sticky"));
    let down = if format.rounding == Rounding::Down { b.lit(1, 1) } else { b.zeros(1) };
    // Two zeros of one sign keep it; all else that gives zero has terms of both signs.
    let sign = (none & subtract).mux(down, large_sign).named("sum_sign");
    let x = Exact { sign, exp, sig: norm.slice(4, &f.man + 1).named("sig"), guard, sticky };
    let range = if format.is_gradual() { Range::Aligned } else { Range::Any };
    // An infinity's sign is that of the larger operand, which it is.
    let value = round(&b, &f, x, range, &Classes { nan, inf, zero: Some(none) });
    b.drive(out, value);
    b.finish(&super::super::bindings())
}
