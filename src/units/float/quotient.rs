//! What both dividers know of a quotient before they divide: sign, exponent, classes.
use super::fields::{Fields, FormatParams};
use super::round::Classes;
use reliefrtl_ir::{Builder, Expr, Sig};

/// A quotient but for its significand.
pub struct Quotient<'b> {
    /// Sign.
    pub sign: Sig<'b>,
    /// Biased, signed exponent if the significand does not lie below 1.
    pub exp: Sig<'b>,
    /// Classes.
    pub classes: Classes<'b>,
    /// Fraction of the dividend.
    pub a_frac: Sig<'b>,
    /// Fraction of the divisor.
    pub b_frac: Sig<'b>,
}

impl<'b> Quotient<'b> {
    /// Of `a / b`, with an exponent of `e_w` bits.
    pub fn of(b: &'b Builder, f: &FormatParams, a: Sig<'b>, by: Sig<'b>, e_w: &Expr) -> Self {
        let (fa, fb) = (Fields::of(f, a, "a"), Fields::of(f, by, "b"));
        let sign = (fa.sign ^ fb.sign).named("quot_sign");
        let bias = b.konst(f.bias(), e_w).named("bias").doc("the exponent bias");
        let exp = (fa.exp.zext(e_w) - fb.exp.zext(e_w) + bias).named("quot_exp");
        let inf = ((fa.is_inf | fb.is_zero) & !fb.is_inf & !fa.is_zero).named("is_inf");
        let zero = ((fa.is_zero | fb.is_inf) & !fa.is_inf & !fb.is_zero).named("is_zero");
        let same = (fa.is_zero & fb.is_zero) | (fa.is_inf & fb.is_inf);
        let nan = (fa.is_nan | fb.is_nan | same).named("is_nan");
        Self { sign, exp, classes: Classes { nan, inf, zero }, a_frac: fa.frac, b_frac: fb.frac }
    }
}
