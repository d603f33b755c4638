//! Rounding and packing: the one place where the hardware decides about rounding, overflow and flushing.
use super::fields::FormatParams;
use crate::ir::{Builder, Expr, Sig};

/// A result before rounding.
pub struct Unrounded<'b> {
    /// Sign.
    pub sign: Sig<'b>,
    /// Biased exponent, signed, of `EXP_W + 2` bits or more.
    pub exp: Sig<'b>,
    /// Significand with its leading one on top, MAN_W + 1 bits.
    pub sig: Sig<'b>,
    /// First bit below the significand.
    pub guard: Sig<'b>,
    /// Any bit below that; `None` where a guard bit never stands alone, so that no tie can occur.
    pub sticky: Option<Sig<'b>>,
}

/// What overrides the rounded number; NaN wins over infinity, infinity over zero.
pub struct Special<'b> {
    /// The result is NaN.
    pub nan: Option<Sig<'b>>,
    /// The result is infinity.
    pub inf: Option<Sig<'b>>,
    /// Sign of that infinity; `None` where it is the number's.
    pub inf_sign: Option<Sig<'b>>,
    /// The result is an exact zero.
    pub zero: Sig<'b>,
    /// Sign of that zero; `None` where it is the number's.
    pub zero_sign: Option<Sig<'b>>,
}

/// Rounds to nearest even and packs. Overflow gives infinity; a rounded exponent below 1 gives zero of the sign
/// (the flush is decided after rounding with unbounded exponent).
pub fn round_pack<'b>(b: &'b Builder, f: &FormatParams, x: &Unrounded<'b>, s: &Special<'b>) -> Sig<'b> {
    let up = match x.sticky {
        Some(sticky) => (x.guard & (sticky | x.sig.bit(0))).named("round_up"),
        None => x.guard,
    };
    let p = f.man.clone() + 1;
    let sum = (x.sig.zext(p.clone() + 1) + up.zext(p.clone() + 1)).named("rounded");
    let carry = sum.msb();
    let frac = carry.mux(sum.slice(1, f.man.clone()), sum.slice(0, f.man.clone())).named("frac");
    let exp = (x.exp + carry.zext(x.exp.width())).named("exp");
    let limit = b.ones(f.exp.clone()).zext(x.exp.width());
    let too_big = (!exp.slt(limit)).named("overflow");
    let too_small = exp.slt(b.lit(1, x.exp.width())).named("underflow");
    pack(b, f, Rounded { sign: x.sign, exp: exp.slice(0, f.exp.clone()), frac, too_big, too_small }, s)
}

struct Rounded<'b> {
    sign: Sig<'b>,
    exp: Sig<'b>,
    frac: Sig<'b>,
    too_big: Sig<'b>,
    too_small: Sig<'b>,
}

fn pack<'b>(b: &'b Builder, f: &FormatParams, r: Rounded<'b>, s: &Special<'b>) -> Sig<'b> {
    let canonical_nan = || b.cat(&[b.zeros(1), b.ones(f.exp.clone()), b.lit(1, 1), b.zeros(f.man.clone() - 1)]);
    let overflow = r.too_big & !s.zero;
    let inf = s.inf.map_or(overflow, |inf| inf | overflow).named("give_inf");
    let zero = (s.zero | r.too_small).named("give_zero");
    let mut sign = r.sign;
    if let Some(of_zero) = s.zero_sign {
        sign = s.zero.mux(of_zero, sign);
    }
    if let Some((inf, of_inf)) = s.inf.zip(s.inf_sign) {
        sign = inf.mux(of_inf, sign);
    }
    if s.zero_sign.or(s.inf_sign).is_some() {
        sign = sign.named("sign");
    }
    let tail: Expr = f.exp.clone() + f.man.clone();
    let inf_tail = b.cat(&[b.ones(f.exp.clone()), b.zeros(f.man.clone())]);
    let number = b.cat(&[r.exp, r.frac]).named("number");
    let body = inf.mux(inf_tail, zero.mux(b.zeros(tail), number)).named("body");
    let value = b.cat(&[sign, body]);
    s.nan.map_or(value, |is_nan| is_nan.mux(canonical_nan(), value)).named("value")
}
