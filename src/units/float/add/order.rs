//! `fp_add`: the operands by magnitude, and what is known of both.
use crate::float::fields::{Fields, FormatParams};
use reliefrtl_ir::{Builder, Sig};

/// The operands by magnitude, and what is known of both.
pub(super) struct Ordered<'b> {
    pub subtract: Sig<'b>,
    pub large_sign: Sig<'b>,
    pub large_exp: Sig<'b>,
    pub large_frac: Sig<'b>,
    /// The hidden bit.
    pub one: Sig<'b>,
    /// Significand of the smaller operand, shifted by one bit where the exponents' lowest bits differ.
    pub sig_small: Sig<'b>,
    pub small_zero: Sig<'b>,
    /// Difference of the exponents.
    pub shift: Sig<'b>,
    pub both_zero: Sig<'b>,
    pub any_exp_max: Sig<'b>,
    pub inf_minus_inf: Sig<'b>,
}

impl<'b> Ordered<'b> {
    pub(super) fn of(b: &'b Builder, f: &FormatParams, a_in: Sig<'b>, b_in: Sig<'b>) -> Self {
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
