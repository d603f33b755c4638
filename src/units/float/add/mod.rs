//! `fp_add`: the sum of two numbers, rounded once. Subtract by flipping the sign bit of `b`.
//!
//! Far/near (dual-path) adder, `p = MAN_W + 1`. The far path aligns, adds, normalizes by at most one bit and rounds. The near path handles
//! effective subtractions with cancellation of two leading bits or more: the exponents differ by at most one, the difference is exact,
//! and it is normalized but never rounded. The two top bits of the far sum select the path, so no comparison of the exponents is on the
//! critical path. The hidden bit is 1 unconditionally: a zero operand only clears the aligned significand,
//! and no zero detection precedes a carry chain. Zero, infinity, NaN and flushed results share the near path's output.
//! PIDM-HW section 4.3 gives the format only; rounding and specials are this project's (`docs/datapath.md`).
use super::fields::FormatParams;
use super::general;
use crate::lzc::lzc;
use crate::quantity::FLOAT;
use align::{Halves, align};
use far::Far;
use order::Ordered;
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

mod align;
mod far;
mod order;

/// Sections and how long each takes, in tenths of a nanosecond on ECP5.
const PLAN: &[(&str, u32)] =
    &[("compare", 26), ("order", 12), ("align", 28), ("add", 36), ("normalize", 30), ("round", 24)];

/// The same from 7 clocks on, where both shifts and the count take two steps.
const DEEP: &[(&str, u32)] = &[
    ("compare", 26),
    ("order", 12),
    ("align", 20),
    ("fine shift", 18),
    ("add", 24),
    ("normalize", 22),
    ("round", 20),
    ("select", 10),
];

/// Builds `fp_add` with `latency` clocks from operand to result.
pub fn fp_add(format: FloatFormat, latency: u32) -> Arc<Module> {
    if !format.is_plain() {
        return general::fp_add(format, latency);
    }
    let b = Builder::new(
        crate::float::names::ADD,
        file!(),
        "sum of two floating-point numbers, rounded once; flip b's sign to subtract",
    );
    let f = FormatParams::declare(&b, format);
    let Widths { near: near_w, count: count_w, shift: shift_w, exp_sum: e_w } = Widths::declare(&b, &f);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "first operand");
    let b_in = b.input("b", &f.width, FLOAT, "second operand");
    let out = b.output("result", &f.width, FLOAT, "a + b");
    let deep = latency as usize > PLAN.len();
    b.plan(latency, if deep { DEEP } else { PLAN });
    let mag_w = &f.exp + &f.man;

    let o = Ordered::of(&b, &f, a_in, b_in);
    let (subtract, large_exp, large_frac, any_exp_max) = (o.subtract, o.large_exp, o.large_frac, o.any_exp_max);

    b.section("align", "Guard, round and sticky bits below the significand suffice to round the result.");
    let wide = o.shift.zext(&shift_w);
    let amount = b
        .cat(&[
            wide.named("wide_shift")
                .doc("shift, in bits enough for its top bits to say that all is lost")
                .slice(1, &count_w - 1),
            b.zeros(1),
        ])
        .named("amount")
        .doc("alignment shift, even [bits]");
    b.unused(wide.bit(0));
    let beyond = wide.slice(&count_w, &shift_w - &count_w).any().named("beyond").doc("the shift is 2^LzcW or more");
    let small = b.cat(&[o.sig_small, b.zeros(1)]).named("sig_small_ext").doc("with a guard bit");
    let small_is_lost = (beyond | o.small_zero).named("small_is_lost").doc("a sticky bit is left of it at most");
    let near = (b.cat(&[o.one, large_frac, b.zeros(1)]) - o.sig_small)
        .named("near")
        .doc("difference of significands whose exponents differ by at most 1, exact");
    let normal_mask = (!b.ones(&near_w).shift_right(large_exp))
        .named("normal_mask")
        .doc("the top large_exp places: a leading 1 there is a normal result");
    let (near_max, bottom) = ends(&f, large_exp);
    let is_nan = (any_exp_max & (o.inf_minus_inf | large_frac.any())).named("is_nan").doc("the result is NaN");
    let (aligned, lost) = align(&b, small, amount, small_is_lost, deep);
    let aligned = aligned.named("aligned").doc("the smaller significand at the place of the larger one");
    let sticky = ((beyond | lost) & !o.small_zero).named("sticky").doc("a 1 was shifted out");
    let halves = deep.then(|| Halves::of(&b, near, &count_w));

    b.section("add", "");
    let x = b
        .cat(&[b.lit(1, 2), large_frac, b.zeros(3)])
        .named("augend")
        .doc("larger significand, with room for carry, guard, round and sticky");
    let y = b.cat(&[b.zeros(1), aligned, sticky]).named("addend").doc("smaller significand, likewise");
    let sum = subtract.mux(x - y, x + y).named("sum").doc("far sum or difference, not normalized");
    let exp_up = (large_exp + b.lit(1, &f.exp)).named("exp_up").doc("exponent after a carry");
    let exp_down = (large_exp - b.lit(1, &f.exp)).named("exp_down").doc("exponent after a shift by one bit");
    let near_zero = near.none().named("near_is_zero").doc("the operands cancel");
    let count = halves.map_or_else(|| lzc(&b, "u_lzc", near, "lz_count"), |h| h.count(&b, &count_w));
    let flush = (near & normal_mask).none().named("flush").doc("the difference is below the smallest normal");

    b.section(
        "normalize",
        "The far sum is normalized by one bit at most; the near difference by a coarse and a fine left shift. The near result is that difference, or zero, infinity or NaN.",
    );
    let Far { carry, top, next, exp, frac, round_up } = Far::of(&b, &f, sum, large_exp, [exp_up, exp_down]);
    let (near_coarse, count_fine) = coarse(&b, near, count);
    let less = (large_exp.zext(&e_w) - count.zext(&e_w))
        .named("exp_less_lzc")
        .doc("larger exponent less the count; wraps where the result is flushed");
    let near_exp = less.slice(0, &f.exp).named("near_exp").doc("exponent of the near result");
    let inf = (any_exp_max | (near_max & !subtract))
        .named("give_inf")
        .doc("the near result, if it is selected, is infinity or NaN");
    let near_result = (any_exp_max | o.both_zero | (carry & near_max) | !(carry | top | (next & !bottom)))
        .named("use_near_result")
        .doc("the result is the near one, or a special one");
    let no_sign = (is_nan | (subtract & !any_exp_max & (o.both_zero | (near_zero & !(carry | top | next)))))
        .named("no_sign")
        .doc("the result is +0 or NaN");

    b.section("round", "The rounding increment may carry into the exponent, and from the largest number to infinity: both give the right encoding.");
    let number = b.cat(&[exp, frac]).named("unrounded").doc("far result, exponent and fraction");
    let number = (number + round_up.zext(mag_w)).named("rounded").doc("the same, rounded");
    let near_norm = near_coarse.shift_left(count_fine).named("near_norm").doc("near, normalized");
    let near_frac = near_norm.slice(1, &f.man).named("near_frac").doc("fraction of the near result");
    b.unused(b.cat(&[near_norm, less]));

    b.section("select", "");
    let near = near_value(&b, &f, (near_exp, near_frac), (flush, inf, is_nan));
    let body = near_result.mux(near, number).named("body").doc("exponent and fraction of the result");
    let sign = (o.large_sign & !no_sign).named("sign").doc("sign of the result");
    b.drive(out, b.cat(&[sign, body]).named("value").doc("the result"));
    b.finish(&super::bindings())
}

/// Whether an exponent is the largest of a finite number, and whether it is that of the smallest normal one.
fn ends<'b>(f: &FormatParams, large_exp: Sig<'b>) -> (Sig<'b>, Sig<'b>) {
    let near_max = (large_exp.slice(1, &f.exp - 1).all() & !large_exp.bit(0))
        .named("exp_is_largest")
        .doc("the exponent is the largest of a finite number");
    let bottom = (large_exp.slice(1, &f.exp - 1).none() & large_exp.bit(0))
        .named("exp_is_least")
        .doc("the exponent is that of the smallest normal number");
    (near_max, bottom)
}

/// Exponent and fraction of the near result: all zeros if it is flushed, infinity or NaN.
fn near_value<'b>(
    b: &'b Builder,
    f: &FormatParams,
    (near_exp, near_frac): (Sig<'b>, Sig<'b>),
    (flush, inf, is_nan): (Sig<'b>, Sig<'b>, Sig<'b>),
) -> Sig<'b> {
    let keep = (!(flush | inf)).named("keep").doc("the near result is finite and not zero");
    let near_e = near_exp & keep.rep(&f.exp) | inf.rep(&f.exp);
    let near_f = near_frac & keep.rep(&f.man);
    let quiet = b.cat(&[is_nan, b.zeros(&f.man - 1)]);
    b.cat(&[near_e, near_f | quiet])
}

/// The near difference, shifted by the top bits of its leading-zero count, which arrive first; and the rest of the count.
fn coarse<'b>(b: &'b Builder, near: Sig<'b>, count: Sig<'b>) -> (Sig<'b>, Sig<'b>) {
    let count_w = count.width();
    let fine_w = b.local("FineW", count_w.clone().div(2), "bits of the fine shift, which follows the coarse one");
    let coarse = b.cat(&[count.slice(&fine_w, &count_w - &fine_w), b.zeros(&fine_w)]);
    let near_coarse = near.shift_left(coarse).named("near_coarse").doc("near, shifted by the top bits of the count");
    (near_coarse, count.slice(0, &fine_w).named("lzc_fine").doc("the rest of the count [bits]"))
}

/// Widths that the sections share.
struct Widths {
    near: Expr,
    count: Expr,
    shift: Expr,
    exp_sum: Expr,
}

impl Widths {
    fn declare(b: &Builder, f: &FormatParams) -> Self {
        let near = b.local("NearW", &f.man + 2, "bits of a cancelling difference: a significand and a guard bit");
        let count = b.local(
            "LzcW",
            (&near + 1).clog2(),
            "bits of the leading zeros of NearW bits; the largest alignment has as many",
        );
        let shift = b.local(
            "ShiftW",
            f.exp.larger(&count + 1),
            "bits of an exponent difference, with one above LzcW that says it is larger",
        );
        let exp_sum =
            b.local("ExpSumW", f.exp.larger(&count), "bits of an exponent, or of the leading zeros that lower it");
        Self { near, count, shift, exp_sum }
    }
}
