//! The rounding at every choice; what is not chosen is not emitted. The faster code of the default choices is proved equal to it.
use super::super::fields::FormatParams;
use super::any;
use reliefrtl_base::format::Rounding;
use reliefrtl_ir::{Builder, Sig};

/// A result before rounding.
pub struct Exact<'b> {
    /// Sign, that of a zero or infinity included.
    pub sign: Sig<'b>,
    /// Biased exponent, signed, of `exponent_width` bits; for normal numbers alone, of EXP_W bits.
    pub exp: Sig<'b>,
    /// Significand of MAN_W + 1 bits, a one on top.
    pub sig: Sig<'b>,
    /// First bit below the significand.
    pub guard: Sig<'b>,
    /// Any bit below that.
    pub sticky: Sig<'b>,
}

/// Where the exponent may stand.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// Anywhere.
    Any,
    /// At 1 or above; a significand without its top bit is a subnormal one and stands at 1.
    Aligned,
    /// Among the normal numbers, even after rounding.
    Normal,
}

/// What overrides the rounded number; NaN wins over infinity, infinity over zero.
#[derive(Default)]
pub struct Classes<'b> {
    /// NaN.
    pub nan: Option<Sig<'b>>,
    /// Infinity; the largest number where there is none.
    pub inf: Option<Sig<'b>>,
    /// Zero.
    pub zero: Option<Sig<'b>>,
}

/// Rounds and packs, in the sections "shift" (subnormal results), "round" and "select".
pub fn round<'b>(b: &'b Builder, f: &FormatParams, x: Exact<'b>, range: Range, c: &Classes<'b>) -> Sig<'b> {
    let gradual = f.format.is_gradual();
    let x = if gradual && range == Range::Any { denormalize(b, f, x) } else { x };
    b.section(
        "round",
        "Exponent and fraction round as one number: a carry out of the fraction continues into the exponent.",
    );
    // A place above the exponent's, where nothing else tells that the largest number was rounded up.
    let e_w = if f.format.is_finite() && range != Range::Normal { &f.exp + 1 } else { f.exp.clone() };
    let mut exp = x.exp.slice(0, &e_w);
    if gradual {
        exp = exp & x.sig.msb().rep(&e_w);
    } else {
        b.unused(x.sig.msb());
    }
    let exact = b.cat(&[exp, x.sig.slice(0, &f.man)]).named("exact");
    let sum = match round_up(f, &x) {
        Some(up) => (exact + up.named("round_up").zext(exact.width())).named("rounded"),
        None => exact,
    };
    if f.format.rounding == Rounding::TowardZero || (f.format.rounding == Rounding::NearestAway) {
        b.unused(x.sticky);
    }
    if f.format.rounding == Rounding::TowardZero {
        b.unused(x.guard);
    }
    let low =
        (!gradual && range == Range::Any).then(|| (x.exp.msb() | (x.exp.none() & !sum.bit(&f.man))).named("too_low"));
    let over = (range != Range::Normal).then(|| over(f, &x, sum));
    // The place above has said what it had to.
    let mag_w = &f.exp + &f.man;
    let sum = if e_w == f.exp { sum } else { sum.slice(0, mag_w).named("in_range") };
    b.section("select", "");
    let over = over.map(|o| any(&[c.nan, c.inf, c.zero]).map_or(o, |s| o & !s).named("overflow"));
    pack(b, f, &x, sum, over, low, c)
}

/// Beyond the largest exponent; what reaches infinity by rounding is infinity already.
fn over<'b>(f: &FormatParams, x: &Exact<'b>, sum: Sig<'b>) -> Sig<'b> {
    let above = if f.format.is_finite() { &f.exp + 1 } else { f.exp.clone() };
    let high = x.exp.slice(&above, x.exp.width() - 1 - &above).any();
    let top = if f.format.is_finite() { x.exp.bit(&f.exp) | sum.msb() } else { x.exp.slice(0, &f.exp).all() };
    (!x.exp.msb() & (high | top)).named("over")
}

/// Puts the value together from the rounded number and what overrides it.
fn pack<'b>(
    b: &'b Builder,
    f: &FormatParams,
    x: &Exact<'b>,
    sum: Sig<'b>,
    over: Option<Sig<'b>>,
    low: Option<Sig<'b>>,
    c: &Classes<'b>,
) -> Sig<'b> {
    let (to_inf, to_max) = match (over, f.format.rounding) {
        _ if f.format.is_finite() => (None, any(&[c.inf.map(|i| c.zero.map_or(i, |z| i & !z)), over])),
        (None, _) => (c.inf, None),
        (Some(o), Rounding::NearestEven | Rounding::NearestAway) => (any(&[c.inf, Some(o)]), None),
        (Some(o), Rounding::TowardZero) => (c.inf, Some(o)),
        (Some(o), Rounding::Up) => (any(&[c.inf, Some(o & !x.sign)]), Some(o & x.sign)),
        (Some(o), Rounding::Down) => (any(&[c.inf, Some(o & x.sign)]), Some(o & !x.sign)),
    };
    let to_inf = any(&[c.nan, to_inf]).map(|s| s.named("give_inf"));
    let to_max = to_max.map(|s| s.named("give_max"));
    let keep = any(&[to_inf, to_max, c.zero, low]).map(|s| (!s).named("keep"));
    let (mut exp, mut frac) = (sum.slice(&f.man, &f.exp), sum.slice(0, &f.man));
    if let Some(keep) = keep {
        (exp, frac) = (exp & keep.rep(&f.exp), frac & keep.rep(&f.man));
    }
    if let Some(ones) = any(&[to_inf, to_max]) {
        let last = if f.format.is_finite() { to_max } else { to_inf };
        let last = last.unwrap_or_else(|| b.zeros(1));
        exp = exp | b.cat(&[ones.rep(&f.exp - 1), last]);
    }
    if let Some(max) = to_max {
        frac = frac | max.rep(&f.man);
    }
    let mut sign = x.sign;
    if let Some(nan) = c.nan {
        frac = frac | b.cat(&[nan, b.zeros(&f.man - 1)]);
        sign = (sign & !nan).named("sign");
    }
    b.cat(&[sign, exp, frac]).named("value")
}

/// Whether the magnitude grows by one in the last place; `None` is never.
fn round_up<'b>(f: &FormatParams, x: &Exact<'b>) -> Option<Sig<'b>> {
    match f.format.rounding {
        Rounding::NearestEven => Some(x.guard & (x.sticky | x.sig.bit(0))),
        Rounding::NearestAway => Some(x.guard),
        Rounding::TowardZero => None,
        Rounding::Up => Some((x.guard | x.sticky) & !x.sign),
        Rounding::Down => Some((x.guard | x.sticky) & x.sign),
    }
}

/// Moves a significand below the smallest normal number to where its last bit is that of the subnormal ones.
fn denormalize<'b>(b: &'b Builder, f: &FormatParams, x: Exact<'b>) -> Exact<'b> {
    b.section(
        "shift",
        "A result below the smallest normal number has fewer bits: it is rounded at the place that they have.",
    );
    let e_w = x.exp.width();
    let tiny = (x.exp.msb() | x.exp.none()).named("tiny");
    let down = (b.lit(1, &e_w) - x.exp).named("down");
    let wide = b.cat(&[x.sig, x.guard, x.sticky]).named("wide");
    let lost = (wide & !b.ones(wide.width()).shift_left(down)).any().named("lost");
    let moved = wide.shift_right(down).named("moved");
    let moved = b.cat(&[moved.slice(1, &f.man + 2), moved.bit(0) | lost]);
    let at = tiny.mux(moved, wide).named("positioned");
    let exp = (x.exp & (!tiny).rep(&e_w)).named("at_exp");
    let (guard, sticky) = (at.bit(1).named("at_guard"), at.bit(0).named("at_sticky"));
    Exact { exp, sig: at.slice(2, &f.man + 1).named("at_sig"), guard, sticky, ..x }
}
