//! An operand, read as the format's choices say.
use super::super::fields::{Fields, FormatParams, Split};
use crate::lzc::lzc;
use reliefrtl_ir::{Builder, Expr, Sig};

/// An operand taken apart; net names start with its own.
pub struct Operand<'b> {
    b: &'b Builder,
    f: FormatParams,
    name: &'static str,
    /// Sign bit.
    pub sign: Sig<'b>,
    /// Exponent field.
    pub exp: Sig<'b>,
    /// Fraction field.
    pub frac: Sig<'b>,
}

/// Declares the width of a signed exponent that holds any sum, difference or normalized exponent.
pub fn exponent_width(b: &Builder, f: &FormatParams) -> Expr {
    b.local("ExpSumW", f.exp.larger((&f.man + 2).clog2()) + 3, "bits of an exponent sum, with room for its sign")
}

impl<'b> Operand<'b> {
    /// Takes `v` apart.
    pub fn of(b: &'b Builder, f: &FormatParams, v: Sig<'b>, name: &'static str) -> Self {
        let Split { sign, exp, frac } = Fields::split(f, v, name);
        Self { b, f: f.clone(), name, sign, exp, frac }
    }
    fn called(&self, s: Sig<'b>, what: &str) -> Sig<'b> {
        s.named(&format!("{}_{what}", self.name))
    }
    /// It counts as zero.
    pub fn zero(&self) -> Sig<'b> {
        let zero = if self.f.format.is_gradual() { self.exp.none() & self.frac.none() } else { self.exp.none() };
        self.called(zero, "is_zero")
    }
    /// Infinity, where there is one.
    pub fn inf(&self) -> Option<Sig<'b>> {
        (!self.f.format.is_finite()).then(|| self.called(self.exp.all() & self.frac.none(), "is_inf"))
    }
    /// NaN, where there is one.
    pub fn nan(&self) -> Option<Sig<'b>> {
        (!self.f.format.is_finite()).then(|| self.called(self.exp.all() & self.frac.any(), "is_nan"))
    }
    /// Significand with its hidden bit, MAN_W + 1 bits; where subnormals are flushed, all zeros for a zero.
    pub fn sig(&self) -> Sig<'b> {
        let hidden = self.exp.any();
        let frac = if self.f.format.is_gradual() { self.frac } else { self.frac & hidden.rep(&self.f.man) };
        self.called(self.b.cat(&[hidden, frac]), "sig")
    }
    /// Exponent field of the significand's weight: 1 instead of 0 where subnormals are numbers.
    pub fn weight(&self) -> Sig<'b> {
        if !self.f.format.is_gradual() {
            return self.exp;
        }
        let low = self.exp.bit(0) | self.exp.none();
        self.called(self.b.cat(&[self.exp.slice(1, &self.f.exp - 1), low]), "weight")
    }
    /// Signed exponent of `e_w` bits, and the significand with a one on top unless the operand is zero.
    pub fn normalized(&self, e_w: &Expr) -> (Sig<'b>, Sig<'b>) {
        if !self.f.format.is_gradual() {
            return (self.exp.zext(e_w), self.b.cat(&[self.b.lit(1, 1), self.frac]));
        }
        let sig = self.sig();
        let count = lzc(self.b, &format!("u_{}_lzc", self.name), sig, &format!("{}_lzc", self.name));
        let exp = self.called(self.weight().zext(e_w) - count.zext(e_w), "norm_exp");
        (exp, self.called(sig.shift_left(count), "norm"))
    }
}
