//! `fp_add`: the shift that aligns the smaller significand, and the count of zeros that normalizes a difference.
use crate::lzc::lzc;
use reliefrtl_ir::{Builder, Expr, Sig};

/// Alignment shift: `small >> amount` (an even amount), zero if `small_is_lost`; and the sticky OR of what is shifted out. Two stages if `deep`.
pub(super) fn align<'b>(
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
    let fine_w =
        b.local("AlignFineW", amount.width().div(2) + 1, "bits of the fine shift, which follows the coarse one");
    let coarse = b
        .cat(&[amount.slice(&fine_w, amount.width() - &fine_w), b.zeros(&fine_w)])
        .named("coarse")
        .doc("top bits of the shift");
    let coarse_shifted = keep(small.shift_right(coarse)).named("coarse_shifted").doc("shifted by them");
    let lost_coarse = (small & below(coarse)).any().named("lost_coarse").doc("a 1 was shifted out by them");
    let fine = amount.slice(0, &fine_w).named("fine").doc("the rest of the shift");
    b.section("fine shift", "");
    let lost = lost_coarse | (coarse_shifted & below(fine)).any();
    (coarse_shifted.shift_right(fine), lost)
}

/// Leading zeros of the upper bits and of the rest.
pub(super) struct Halves<'b> {
    upper: Sig<'b>,
    rest: Sig<'b>,
    bits: Expr,
}

impl<'b> Halves<'b> {
    pub(super) fn of(b: &'b Builder, word: Sig<'b>, count_w: &Expr) -> Self {
        let bits = b.local("UpperW", (count_w - 2).pow2(), "bits of the upper part, a power of two");
        let rest_w = b.local("RestW", word.width() - &bits, "bits of the lower part");
        let upper = lzc(b, "u_lzc_upper", word.slice(&rest_w, &bits), "lzc_upper");
        Self { upper, rest: lzc(b, "u_lzc_rest", word.slice(0, &rest_w), "lzc_rest"), bits }
    }
    /// Of the whole word, `count_w` bits.
    pub(super) fn count(&self, b: &'b Builder, count_w: &Expr) -> Sig<'b> {
        let rest = b.konst(&self.bits, count_w).named("upper_bits").doc("leading zeros of an upper part of zeros")
            + self.rest.zext(count_w);
        self.upper.msb().mux(rest, self.upper.zext(count_w)).named("lz_count")
    }
}
