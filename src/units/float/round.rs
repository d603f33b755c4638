//! Rounding and packing at the default choices (nearest even, subnormals flushed, IEEE specials), with fewer levels of logic than the general
//! rounding. `fp_add` and `fp_div` by a table round in code of their own. Each is proved equal to `general` for every operand, but for the division by a table,
//! which is held against the golden model (`tests/proofs/roundings.rs`, `tests/golden/arithmetic/div_table.rs`).
use super::fields::FormatParams;
use reliefrtl_ir::{Builder, Expr, Sig};

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
/// (the flush is decided after rounding with unbounded exponent). From the sum on it is the section "select".
pub fn round_pack<'b>(b: &'b Builder, f: &FormatParams, x: &Unrounded<'b>, s: &Special<'b>) -> Sig<'b> {
    let up = match x.sticky {
        Some(sticky) => (x.guard & (sticky | x.sig.bit(0))).named("round_up"),
        None => x.guard,
    };
    let p = f.man.clone() + 1;
    let sum = (x.sig.zext(p.clone() + 1) + up.zext(p.clone() + 1)).named("rounded");
    b.section("select", "");
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

/// A positive result rounded so that no carry chain waits for a sticky bit: the guard bit is added, and a tie clears the
/// last bit afterwards. Exponent and fraction are one number: a carry out of the fraction goes on into the exponent, and
/// from the largest number to infinity, by itself.
pub struct Candidate<'b> {
    /// Exponent and fraction, rounded; EXP_W + MAN_W bits.
    body: Sig<'b>,
    /// Below the smallest normal number after rounding.
    too_low: Sig<'b>,
    /// Beyond the largest exponent before rounding; what reaches it by rounding is infinity already.
    over: Sig<'b>,
}

/// Classes of a result; NaN wins over infinity, infinity over zero.
pub struct Classes<'b> {
    /// NaN.
    pub nan: Sig<'b>,
    /// Infinity.
    pub inf: Sig<'b>,
    /// Zero.
    pub zero: Sig<'b>,
}

impl<'b> Candidate<'b> {
    /// Rounds `frac` (MAN_W bits) of biased, signed exponent `exp` (EXP_W + 2 bits) by the bit below it; `tie` says that
    /// nothing stands below that bit, `None` that this can't be. Net names start with `name`.
    pub fn of(
        b: &'b Builder,
        f: &FormatParams,
        exp: Sig<'b>,
        frac: Sig<'b>,
        guard: Sig<'b>,
        tie: Option<Sig<'b>>,
        name: &str,
    ) -> Self {
        let called = |s: Sig<'b>, what: &str| s.named(&format!("{name}_{what}"));
        let mag_w = &f.exp + &f.man;
        let exact = b.cat(&[exp.slice(0, &f.exp), frac]);
        let sum = called(exact + guard.zext(&mag_w), "sum");
        let even = |tie: Sig<'b>| b.cat(&[sum.slice(1, mag_w.clone() - 1), sum.bit(0) & !called(tie, "tie")]);
        let body = tie.map_or(sum, |tie| called(even(tie), "body"));
        // From exponent 0, rounding may still reach the smallest normal number.
        let at_zero = called(exp.none(), "at_zero");
        let too_low = called(exp.msb() | (at_zero & !sum.bit(&f.man)), "too_low");
        let over = called(!exp.msb() & (exp.bit(&f.exp) | exp.slice(0, &f.exp).all()), "over");
        Self { body, too_low, over }
    }
    /// `top ? high : low`.
    pub fn pick(top: Sig<'b>, high: &Self, low: &Self) -> Self {
        Self {
            body: top.mux(high.body, low.body).named("picked"),
            too_low: top.mux(high.too_low, low.too_low),
            over: top.mux(high.over, low.over),
        }
    }
    /// The encoded number.
    pub fn pack(&self, b: &'b Builder, f: &FormatParams, sign: Sig<'b>, c: &Classes<'b>) -> Sig<'b> {
        let inf = (c.nan | c.inf | (self.over & !c.zero)).named("give_inf");
        let keep = (!(inf | c.zero | self.too_low)).named("keep");
        let exp = self.body.slice(&f.man, &f.exp) & keep.rep(&f.exp) | inf.rep(&f.exp);
        let frac = self.body.slice(0, &f.man) & keep.rep(&f.man) | b.cat(&[c.nan, b.zeros(&f.man - 1)]);
        b.cat(&[(sign & !c.nan).named("sign"), exp, frac]).named("value")
    }
}
