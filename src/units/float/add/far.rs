//! `fp_add`: the far path's sum, normalized by one bit at most, and whether it is rounded up.
use crate::float::fields::FormatParams;
use reliefrtl_ir::{Builder, Sig};

/// The far result before rounding.
pub(super) struct Far<'b> {
    pub carry: Sig<'b>,
    pub top: Sig<'b>,
    pub next: Sig<'b>,
    /// Exponent, EXP_W bits.
    pub exp: Sig<'b>,
    /// Fraction, MAN_W bits.
    pub frac: Sig<'b>,
    pub round_up: Sig<'b>,
}

impl<'b> Far<'b> {
    /// Of `sum` (MAN_W + 5 bits); the exponents are those of the larger operand, after a carry, and after a shift by one bit.
    pub(super) fn of(
        b: &'b Builder,
        f: &FormatParams,
        sum: Sig<'b>,
        large_exp: Sig<'b>,
        [exp_up, exp_down]: [Sig<'b>; 2],
    ) -> Self {
        let carry = sum.msb().named("carry").doc("the sum is 2 or more");
        let top = sum.bit(&f.man + 3).named("top").doc("the sum is 1 or more, where it has no carry");
        let next = sum.bit(&f.man + 2).named("next").doc("the sum is 1/2 or more, without top and carry");
        let at = |lo: i64| sum.slice(lo, f.man.clone());
        let frac =
            carry.mux(at(4), top.mux(at(3), at(2))).named("frac").doc("fraction of the far result, before rounding");
        let exp = carry.mux(exp_up, top.mux(large_exp, exp_down)).named("exp").doc("exponent of the far result");
        let low = sum.slice(0, 2).any();
        let up = |lsb: i64, rest: Sig<'_>| (sum.bit(lsb - 1) & (sum.bit(lsb) | rest)).id();
        let ups = [up(4, sum.bit(2) | low), up(3, low), up(2, sum.bit(0))].map(|i| b.sig(i));
        let round_up = carry
            .mux(ups[0], top.mux(ups[1], ups[2]))
            .named("round_up")
            .doc("the far result is rounded away from zero");
        Self { carry, top, next, exp, frac, round_up }
    }
}
