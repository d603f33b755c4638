//! `fp_add`: the sum of two numbers, rounded once. Subtract by flipping the sign bit of `b`.
//!
//! Far/near (dual-path) adder, `p = MAN_W + 1`. The far path aligns, adds, normalizes by at most one bit and rounds. The near path handles
//! effective subtractions with cancellation of two leading bits or more: the exponents differ by at most one, the difference is exact,
//! and it is normalized but never rounded. The two top bits of the far sum select the path, so no comparison of the exponents is on the
//! critical path. The hidden bit is 1 unconditionally: a zero operand only clears the aligned significand,
//! and no zero detection precedes a carry chain. Zero, infinity, NaN and flushed results share the near path's output.
//! PIDM-HW section 4.3 gives the format only; rounding and specials are this project's (`docs/datapath.md`).
use super::fields::{Fields, FormatParams};
use super::general;
use crate::lzc::lzc;
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

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
    let Widths { near: near_w, count: count_w, amount: amount_w, shift: shift_w, exp_sum: e_w } =
        Widths::declare(&b, &f);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, "float", "first operand");
    let b_in = b.input("b", &f.width, "float", "second operand");
    let out = b.output("result", &f.width, "float", "a + b");
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
                .slice(1, &amount_w - 1),
            b.zeros(1),
        ])
        .named("amount")
        .doc("alignment shift, even [bits]");
    b.unused(wide.bit(0));
    let beyond = wide
        .slice(&amount_w, &shift_w - &amount_w)
        .any()
        .named("beyond")
        .doc("the shift moves the smaller significand out altogether");
    let small = b.cat(&[o.sig_small, b.zeros(1)]).named("sig_small_ext").doc("with a guard bit");
    let small_is_lost =
        (beyond | o.small_zero).named("small_is_lost").doc("nothing is left of the smaller operand but its sticky bit");
    let near = (b.cat(&[o.one, large_frac, b.zeros(1)]) - o.sig_small)
        .named("near")
        .doc("difference of significands whose exponents differ by at most 1, exact");
    let underflow_mask = (!b.ones(&near_w).shift_right(large_exp))
        .named("underflow_mask")
        .doc("places at which a leading 1 means a result below the smallest normal");
    let near_max = (large_exp.slice(1, &f.exp - 1).all() & !large_exp.bit(0))
        .named("near_max")
        .doc("the exponent is the largest finite one");
    let bottom = (large_exp.slice(1, &f.exp - 1).none() & large_exp.bit(0))
        .named("bottom")
        .doc("the exponent is the smallest one");
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
    let near_zero = near.none().named("near_zero").doc("the operands cancel");
    let count = halves.map_or_else(|| lzc(&b, "u_lzc", near, "lz_count"), |h| h.count(&b, &count_w));
    let flush = (near & underflow_mask).none().named("flush").doc("the difference is below the smallest normal");

    b.section(
        "normalize",
        "The far sum is normalized by one bit at most; the near difference by a coarse and a fine left shift. The near result is that difference, or zero, infinity or NaN.",
    );
    let carry = sum.msb().named("carry").doc("the sum is 2 or more");
    let top = sum.bit(&f.man + 3).named("top").doc("the sum is 1 or more");
    let next = sum.bit(&f.man + 2).named("next").doc("the sum is 1/2 or more");
    let at = |lo: i64| sum.slice(lo, f.man.clone());
    let frac = carry.mux(at(4), top.mux(at(3), at(2))).named("frac").doc("fraction of the far result, before rounding");
    let exp = carry.mux(exp_up, top.mux(large_exp, exp_down)).named("exp").doc("exponent of the far result");
    let low = sum.slice(0, 2).any();
    let up = |lsb: i64, rest: Sig<'_>| (sum.bit(lsb - 1) & (sum.bit(lsb) | rest)).id();
    let ups = [up(4, sum.bit(2) | low), up(3, low), up(2, sum.bit(0))].map(|i| b.sig(i));
    let round_up =
        carry.mux(ups[0], top.mux(ups[1], ups[2])).named("round_up").doc("the far result is rounded away from zero");
    // The coarse shift uses the top bits of the count, which arrive first.
    let fine_w = b.local("FineW", count_w.clone().div(2));
    let coarse = b.cat(&[count.slice(&fine_w, &count_w - &fine_w), b.zeros(&fine_w)]);
    let near_coarse = near.shift_left(coarse).named("near_coarse").doc("near, shifted by the top bits of the count");
    let count_fine = count.slice(0, &fine_w).named("lzc_fine").doc("the rest of the count [bits]");
    let less = (large_exp.zext(&e_w) - count.zext(&e_w))
        .named("exp_less_lzc")
        .doc("exponent of the near result, with its sign");
    let near_exp = less.slice(0, &f.exp).named("near_exp").doc("exponent of the near result");
    let inf = (any_exp_max | (near_max & !subtract)).named("give_inf").doc("the result is infinity or NaN");
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
    let keep = (!(flush | inf)).named("keep").doc("the near result is a number");
    let near_e = near_exp & keep.rep(&f.exp) | inf.rep(&f.exp);
    let near_f = near_frac & keep.rep(&f.man);
    let quiet = b.cat(&[is_nan, b.zeros(&f.man - 1)]);
    let body = near_result
        .mux(b.cat(&[near_e, near_f | quiet]), number)
        .named("body")
        .doc("exponent and fraction of the result");
    let sign = (o.large_sign & !no_sign).named("sign").doc("sign of the result");
    b.drive(out, b.cat(&[sign, body]).named("value").doc("the result"), Some(latency));
    b.finish(Some(latency), &super::bindings())
}

/// Widths that the sections share.
struct Widths {
    near: Expr,
    count: Expr,
    amount: Expr,
    shift: Expr,
    exp_sum: Expr,
}

impl Widths {
    fn declare(b: &Builder, f: &FormatParams) -> Self {
        let near = b.local("NearW", &f.man + 2);
        let count = b.local("LzcW", (&near + 1).clog2());
        let amount = b.local("AmountW", (&f.man + 3).clog2());
        let shift = b.local("ShiftW", f.exp.larger(&amount + 1));
        let exp_sum = b.local("ExpSumW", f.exp.larger(&count));
        Self { near, count, amount, shift, exp_sum }
    }
}

/// The operands by magnitude, and what is known of both.
struct Ordered<'b> {
    subtract: Sig<'b>,
    large_sign: Sig<'b>,
    large_exp: Sig<'b>,
    large_frac: Sig<'b>,
    /// The hidden bit.
    one: Sig<'b>,
    /// Significand of the smaller operand, shifted by one bit where the exponents' lowest bits differ.
    sig_small: Sig<'b>,
    small_zero: Sig<'b>,
    /// Difference of the exponents.
    shift: Sig<'b>,
    both_zero: Sig<'b>,
    any_exp_max: Sig<'b>,
    inf_minus_inf: Sig<'b>,
}

impl<'b> Ordered<'b> {
    fn of(b: &'b Builder, f: &FormatParams, a_in: Sig<'b>, b_in: Sig<'b>) -> Self {
        let mag_w = &f.exp + &f.man;
        b.section(
            "compare",
            "Both exponent differences in parallel with the magnitude comparison; the select follows.",
        );
        let (fa, fb) = (Fields::split(f, a_in, "a"), Fields::split(f, b_in, "b"));
        let swap =
            a_in.slice(0, mag_w.clone()).lt(b_in.slice(0, mag_w.clone())).named("swap").doc("b is the larger operand");
        let e1 = &f.exp + 1;
        let exp_diff_ab =
            (fa.exp.zext(&e1) - fb.exp.zext(&e1)).named("exp_diff_ab").doc("exponent of a less that of b");
        let exp_diff_ba = (fb.exp - fa.exp).named("exp_diff_ba").doc("the other way round");
        let subtract = (fa.sign ^ fb.sign).named("subtract").doc("the signs differ");
        let odd = (fa.exp.bit(0) ^ fb.exp.bit(0)).named("odd").doc("the exponents differ by an odd number");
        let (a_zero, b_zero) =
            (fa.exp.none().named("a_is_zero").doc("a is zero"), fb.exp.none().named("b_is_zero").doc("b is zero"));
        let (a_ones, b_ones) = (
            fa.exp.all().named("a_exp_ones").doc("a is infinity or NaN"),
            fb.exp.all().named("b_exp_ones").doc("b is infinity or NaN"),
        );

        b.section(
            "order",
            "Swap so that the operand of larger magnitude comes first: the significand difference is not negative.",
        );
        let large_sign = swap.mux(fb.sign, fa.sign).named("large_sign").doc("sign of the larger operand");
        let large_exp = swap.mux(fb.exp, fa.exp).named("large_exp").doc("its exponent");
        let large_frac = swap.mux(fb.frac, fa.frac).named("large_frac").doc("its fraction");
        let one = b.lit(1, 1);
        let prealigned = |frac| odd.mux(b.cat(&[b.lit(1, 2), frac]), b.cat(&[one, frac, b.zeros(1)]));
        let sig_small = swap
            .mux(
                prealigned(fa.frac).named("a_sig_prealigned").doc("significand of a, a bit lower if odd"),
                prealigned(fb.frac).named("b_sig_prealigned").doc("significand of b, a bit lower if odd"),
            )
            .named("sig_small")
            .doc("significand of the smaller operand");
        let small_zero = swap.mux(a_zero, b_zero).named("small_is_zero").doc("the smaller operand is zero");
        let shift = exp_diff_ab
            .msb()
            .mux(exp_diff_ba, exp_diff_ab.slice(0, &f.exp))
            .named("shift")
            .doc("difference of the exponents [bits]");
        let both_zero = (a_zero & b_zero).named("both_zero").doc("both operands are zero");
        let any_exp_max = (a_ones | b_ones).named("any_exp_max").doc("an operand is infinity or NaN");
        let inf_minus_inf = (a_ones & b_ones & subtract).named("inf_minus_inf").doc("both are, with different signs");
        Self {
            subtract,
            large_sign,
            large_exp,
            large_frac,
            one,
            sig_small,
            small_zero,
            shift,
            both_zero,
            any_exp_max,
            inf_minus_inf,
        }
    }
}

/// Alignment shift: `small >> amount` (an even amount), zero if `small_is_lost`; and the sticky OR of what is shifted out. Two stages if `deep`.
fn align<'b>(
    b: &'b Builder,
    small: Sig<'b>,
    amount: Sig<'b>,
    small_is_lost: Sig<'b>,
    deep: bool,
) -> (Sig<'b>, Sig<'b>) {
    let w = small.width();
    let keep = |x: Sig<'b>| x & (!small_is_lost).rep(&w);
    let below = |n: Sig<'b>| !b.ones(&w).shift_left(n);
    if !deep {
        let lost = (small & below(amount)).any();
        return (keep(small.shift_right(amount)), lost);
    }
    let fine_w = b.local("AlignFineW", amount.width().div(2) + 1);
    let coarse = b
        .cat(&[amount.slice(&fine_w, amount.width() - &fine_w), b.zeros(&fine_w)])
        .named("coarse")
        .doc("top bits of the shift");
    let near_place = keep(small.shift_right(coarse)).named("near_place").doc("shifted by them");
    let lost_coarse = (small & below(coarse)).any().named("lost_coarse").doc("a 1 was shifted out by them");
    let fine = amount.slice(0, &fine_w).named("fine").doc("the rest of the shift");
    b.section("fine shift", "");
    let lost = lost_coarse | (near_place & below(fine)).any();
    (near_place.shift_right(fine), lost)
}

/// Leading zeros of the upper bits and of the rest.
struct Halves<'b> {
    upper: Sig<'b>,
    rest: Sig<'b>,
    bits: Expr,
}

impl<'b> Halves<'b> {
    fn of(b: &'b Builder, word: Sig<'b>, count_w: &Expr) -> Self {
        let bits = b.local("UpperW", (count_w - 2).pow2());
        let rest_w = b.local("RestW", word.width() - &bits);
        let upper = lzc(b, "u_lzc_upper", word.slice(&rest_w, &bits), "lzc_upper");
        Self { upper, rest: lzc(b, "u_lzc_rest", word.slice(0, &rest_w), "lzc_rest"), bits }
    }
    /// Of the whole word, `count_w` bits.
    fn count(&self, b: &'b Builder, count_w: &Expr) -> Sig<'b> {
        let rest = b.konst(&self.bits, count_w).named("upper_bits") + self.rest.zext(count_w);
        self.upper.msb().mux(rest, self.upper.zext(count_w)).named("lz_count")
    }
}
