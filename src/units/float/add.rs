//! `fp_add`: the sum of two numbers, rounded once. Subtract by flipping the sign bit of `b`.
//!
//! Two paths, `p = MAN_W + 1`. The far one aligns, adds, moves by at most one place and rounds. The near one serves
//! differences that lose two leading bits or more: their operands are at most one exponent apart, the difference is exact,
//! and it is shifted up but never rounded. Which one counts is read off the far sum's two top bits, so nobody asks for the
//! distance of the exponents. The hidden bit is taken as 1 everywhere: a zero operand only kills the aligned significand,
//! and no test for zero stands before a carry chain. Zero, infinity, NaN and flushed results share the near path's leg.
//! PIDM-HW section 4.3 gives the format only; rounding and specials are this project's (`docs/datapath.md`).
use super::fields::{Fields, FormatParams};
use super::general;
use crate::format::FloatFormat;
use crate::ir::{Builder, Expr, Module, Sig};
use crate::units::lzc::lzc;
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
        crate::units::float::names::ADD,
        file!(),
        "sum of two floating-point numbers, rounded once; flip b's sign to subtract",
    );
    let f = FormatParams::declare(&b, format);
    let near_w = b.local("NearW", &f.man + 2);
    let lead_w = b.local("LeadW", (&near_w + 1).clog2());
    let amount_w = b.local("AmountW", (&f.man + 3).clog2());
    let shift_w = b.local("ShiftW", f.exp.larger(&amount_w + 1));
    let e_w = b.local("ExpSumW", f.exp.larger(&lead_w));
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, "float", "first operand");
    let b_in = b.input("b", &f.width, "float", "second operand");
    let out = b.output("result", &f.width, "float", "a + b");
    let deep = latency as usize > PLAN.len();
    b.plan(latency, if deep { DEEP } else { PLAN });
    let mag_w = &f.exp + &f.man;

    b.section("compare", "Both differences of the exponents, so that neither waits for which operand is larger.");
    let (fa, fb) = (Fields::split(&f, a_in, "a"), Fields::split(&f, b_in, "b"));
    let swap = a_in.slice(0, mag_w.clone()).lt(b_in.slice(0, mag_w.clone())).named("swap");
    let e1 = &f.exp + 1;
    let a_above = (fa.exp.zext(&e1) - fb.exp.zext(&e1)).named("a_above");
    let b_above = (fb.exp - fa.exp).named("b_above");
    let subtract = (fa.sign ^ fb.sign).named("subtract");
    let odd = (fa.exp.bit(0) ^ fb.exp.bit(0)).named("odd");
    let (a_zero, b_zero) = (fa.exp.none().named("a_is_zero"), fb.exp.none().named("b_is_zero"));
    let (a_ones, b_ones) = (fa.exp.all().named("a_exp_ones"), fb.exp.all().named("b_exp_ones"));

    b.section(
        "order",
        "The operand of larger magnitude comes first, so the difference of the significands is not negative.",
    );
    let big_sign = swap.mux(fb.sign, fa.sign).named("big_sign");
    let big_exp = swap.mux(fb.exp, fa.exp).named("big_exp");
    let big_frac = swap.mux(fb.frac, fa.frac).named("big_frac");
    let one = b.lit(1, 1);
    let halved = |frac| odd.mux(b.cat(&[b.lit(1, 2), frac]), b.cat(&[one, frac, b.zeros(1)]));
    let lower = swap.mux(halved(fa.frac).named("a_halved"), halved(fb.frac).named("b_halved")).named("lower");
    let small_zero = swap.mux(a_zero, b_zero).named("small_is_zero");
    let shift = a_above.msb().mux(b_above, a_above.slice(0, &f.exp)).named("shift");
    let both_zero = (a_zero & b_zero).named("both_zero");
    let huge = (a_ones | b_ones).named("huge");
    let both_huge = (a_ones & b_ones & subtract).named("inf_minus_inf");

    b.section(
        "align",
        "Three bits below the significand, the last one sticky, are enough to round a sum or difference.",
    );
    let wide = shift.zext(&shift_w);
    let amount = b.cat(&[wide.named("wide_shift").slice(1, &amount_w - 1), b.zeros(1)]).named("amount");
    b.unused(wide.bit(0));
    let beyond = wide.slice(&amount_w, &shift_w - &amount_w).any().named("beyond");
    let small = b.cat(&[lower, b.zeros(1)]).named("small_sig");
    let kill = (beyond | small_zero).named("kill");
    let near = (b.cat(&[one, big_frac, b.zeros(1)]) - lower).named("near");
    let reach = (!b.ones(&near_w).shift_right(big_exp)).named("reach");
    let near_max = (big_exp.slice(1, &f.exp - 1).all() & !big_exp.bit(0)).named("near_max");
    let bottom = (big_exp.slice(1, &f.exp - 1).none() & big_exp.bit(0)).named("bottom");
    let is_nan = (huge & (both_huge | big_frac.any())).named("is_nan");
    let (aligned, lost) = align(&b, small, amount, kill, deep);
    let aligned = aligned.named("aligned");
    let sticky = ((beyond | lost) & !small_zero).named("sticky");
    let halves = deep.then(|| Halves::of(&b, near, &lead_w));

    b.section("add", "");
    let x = b.cat(&[b.lit(1, 2), big_frac, b.zeros(3)]).named("augend");
    let y = b.cat(&[b.zeros(1), aligned, sticky]).named("addend");
    let sum = subtract.mux(x - y, x + y).named("sum");
    let exp_up = (big_exp + b.lit(1, &f.exp)).named("exp_up");
    let exp_down = (big_exp - b.lit(1, &f.exp)).named("exp_down");
    let near_zero = near.none().named("near_zero");
    let lead = halves.map_or_else(|| lzc(&b, "u_lzc", near, "lead"), |h| h.lead(&b, &lead_w));
    let flush = (near & reach).none().named("flush");

    b.section(
        "normalize",
        "The far sum moves by one place at most; the near difference goes up, the coarse steps first. The leg is the near difference, or zero, infinity or NaN in its place.",
    );
    let carry = sum.msb().named("carry");
    let top = sum.bit(&f.man + 3).named("top");
    let next = sum.bit(&f.man + 2).named("next");
    let at = |lo: i64| sum.slice(lo, f.man.clone());
    let frac = carry.mux(at(4), top.mux(at(3), at(2))).named("frac");
    let exp = carry.mux(exp_up, top.mux(big_exp, exp_down)).named("exp");
    let low = sum.slice(0, 2).any();
    let up = |lsb: i64, rest: Sig<'_>| (sum.bit(lsb - 1) & (sum.bit(lsb) | rest)).id();
    let ups = [up(4, sum.bit(2) | low), up(3, low), up(2, sum.bit(0))].map(|i| b.sig(i));
    let round_up = carry.mux(ups[0], top.mux(ups[1], ups[2])).named("round_up");
    // The top bits of the count come first: they are the first that are known.
    let fine_w = b.local("FineW", lead_w.clone().div(2));
    let coarse = b.cat(&[lead.slice(&fine_w, &lead_w - &fine_w), b.zeros(&fine_w)]);
    let near_coarse = near.shift_left(coarse).named("near_coarse");
    let lead_fine = lead.slice(0, &fine_w).named("lead_fine");
    let less = (big_exp.zext(&e_w) - lead.zext(&e_w)).named("exp_less_lead");
    let near_exp = less.slice(0, &f.exp).named("near_exp");
    let inf = (huge | (near_max & !subtract)).named("give_inf");
    let leg = (huge | both_zero | (carry & near_max) | !(carry | top | (next & !bottom))).named("use_leg");
    let no_sign = (is_nan | (subtract & !huge & (both_zero | (near_zero & !(carry | top | next))))).named("no_sign");

    b.section("round", "One place up can carry into the exponent, and from the largest number to infinity, by itself.");
    let number = b.cat(&[exp, frac]).named("unrounded");
    let number = (number + round_up.zext(mag_w)).named("rounded");
    let near_norm = near_coarse.shift_left(lead_fine).named("near_norm");
    let near_frac = near_norm.slice(1, &f.man).named("near_frac");
    b.unused(b.cat(&[near_norm, less]));

    b.section("select", "");
    let keep = (!(flush | inf)).named("keep");
    let near_e = near_exp & keep.rep(&f.exp) | inf.rep(&f.exp);
    let near_f = near_frac & keep.rep(&f.man);
    let quiet = b.cat(&[is_nan, b.zeros(&f.man - 1)]);
    let body = leg.mux(b.cat(&[near_e, near_f | quiet]), number).named("body");
    let sign = (big_sign & !no_sign).named("sign");
    b.drive(out, b.cat(&[sign, body]).named("value"), Some(latency));
    b.finish(Some(latency), &super::bindings())
}

/// `small >> amount` (an even number), zero if `kill`; and whether ones were shifted out. In two steps if `deep`.
fn align<'b>(b: &'b Builder, small: Sig<'b>, amount: Sig<'b>, kill: Sig<'b>, deep: bool) -> (Sig<'b>, Sig<'b>) {
    let w = small.width();
    let keep = |x: Sig<'b>| x & (!kill).rep(&w);
    let below = |n: Sig<'b>| !b.ones(&w).shift_left(n);
    if !deep {
        let lost = (small & below(amount)).any();
        return (keep(small.shift_right(amount)), lost);
    }
    let fine_w = b.local("AlignFineW", amount.width().div(2) + 1);
    let coarse = b.cat(&[amount.slice(&fine_w, amount.width() - &fine_w), b.zeros(&fine_w)]).named("coarse");
    let near_place = keep(small.shift_right(coarse)).named("near_place");
    let lost_coarse = (small & below(coarse)).any().named("lost_coarse");
    let fine = amount.slice(0, &fine_w).named("fine");
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
    fn of(b: &'b Builder, word: Sig<'b>, lead_w: &Expr) -> Self {
        let bits = b.local("UpperW", (lead_w - 2).pow2());
        let rest_w = b.local("RestW", word.width() - &bits);
        let upper = lzc(b, "u_lzc_upper", word.slice(&rest_w, &bits), "lead_upper");
        Self { upper, rest: lzc(b, "u_lzc_rest", word.slice(0, &rest_w), "lead_rest"), bits }
    }
    /// Of the whole word, `lead_w` bits.
    fn lead(&self, b: &'b Builder, lead_w: &Expr) -> Sig<'b> {
        let behind = b.konst(&self.bits, lead_w).named("upper_bits") + self.rest.zext(lead_w);
        self.upper.msb().mux(behind, self.upper.zext(lead_w)).named("lead")
    }
}
