//! Fields of a floating-point operand, and the classes that the format's policy knows.
use reliefrtl_base::format::{FloatFormat, Rounding};
use reliefrtl_ir::{Binding, Builder, Expr, Sig};

/// The format parameters of a module and its derived widths.
#[derive(Clone)]
pub struct FormatParams {
    /// EXP_W.
    pub exp: Expr,
    /// MAN_W.
    pub man: Expr,
    /// FLOAT_W = 1 + EXP_W + MAN_W.
    pub width: Expr,
    /// The choices besides the widths.
    pub format: FloatFormat,
}

impl FormatParams {
    /// Declares EXP_W, MAN_W and FLOAT_W, and what they may be.
    pub fn declare(b: &Builder, f: FloatFormat) -> Self {
        let exp = b.param("EXP_W", f.exp, "exponent bits");
        let man = b.param("MAN_W", f.man, "fraction bits, the hidden one not counted");
        b.require(2, &exp);
        b.require(&exp, 11);
        b.require(2, &man);
        b.require(&man, 28);
        let width = b.local("FloatW", &exp + &man + 1, "bits of a float: sign, exponent, fraction");
        b.note(note(f));
        b.choice("rounding", f.rounding.word());
        b.choice("subnormals", f.subnormals.word());
        b.choice("specials", f.specials.word());
        Self { exp, man, width, format: f }
    }
    /// The bias.
    pub fn bias(&self) -> Expr {
        (self.exp.clone() - 1).pow2() - 1
    }
}

/// What the banner says of the format.
fn note(f: FloatFormat) -> String {
    let subnormals = if f.is_gradual() {
        "Exponent 0 is a subnormal number"
    } else {
        "Exponent 0 reads as zero of its sign; results below the smallest normal, after rounding, become zero of their sign"
    };
    let specials = if f.is_finite() {
        "exponent all ones is a number like the others and results saturate"
    } else {
        "exponent all ones is infinity (fraction 0) or NaN (every NaN result has the same bits)"
    };
    let rounding = match f.rounding {
        Rounding::NearestEven => "nearest, ties to even",
        Rounding::NearestAway => "nearest, ties away from zero",
        Rounding::TowardZero => "rounded toward zero",
        Rounding::Up => "rounded toward plus infinity",
        Rounding::Down => "rounded toward minus infinity",
    };
    let cancelled = if f.rounding == Rounding::Down { "-0" } else { "+0" };
    format!(
        "Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. {subnormals}; {specials}; {rounding}; \
         x - x is {cancelled}."
    )
}

/// Sign, exponent field and fraction field of an operand.
pub struct Split<'b> {
    /// Sign bit.
    pub sign: Sig<'b>,
    /// Exponent field.
    pub exp: Sig<'b>,
    /// Fraction field.
    pub frac: Sig<'b>,
}

/// An operand taken apart.
pub struct Fields<'b> {
    /// Sign bit.
    pub sign: Sig<'b>,
    /// Exponent field.
    pub exp: Sig<'b>,
    /// Fraction field.
    pub frac: Sig<'b>,
    /// Exponent field is 0: the operand counts as zero.
    pub is_zero: Sig<'b>,
    /// Infinity.
    pub is_inf: Sig<'b>,
    /// NaN.
    pub is_nan: Sig<'b>,
}

impl<'b> Fields<'b> {
    /// Takes `v` apart without asking for its class; net names start with `name`.
    pub fn split(f: &FormatParams, v: Sig<'b>, name: &str) -> Split<'b> {
        Split {
            sign: v.msb().named(&format!("{name}_sign")),
            exp: v.slice(f.man.clone(), f.exp.clone()).named(&format!("{name}_exp")),
            frac: v.slice(0, f.man.clone()).named(&format!("{name}_frac")),
        }
    }
    /// Takes `v` apart; net names start with `name`.
    pub fn of(f: &FormatParams, v: Sig<'b>, name: &str) -> Self {
        let sign = v.msb().named(&format!("{name}_sign"));
        let exp = v.slice(f.man.clone(), f.exp.clone()).named(&format!("{name}_exp"));
        let frac = v.slice(0, f.man.clone()).named(&format!("{name}_frac"));
        let is_zero = exp.none().named(&format!("{name}_is_zero"));
        let top = exp.all().named(&format!("{name}_exp_ones"));
        let some = frac.any().named(&format!("{name}_frac_some"));
        let is_inf = (top & !some).named(&format!("{name}_is_inf"));
        let is_nan = (top & some).named(&format!("{name}_is_nan"));
        Self { sign, exp, frac, is_zero, is_inf, is_nan }
    }
    /// The significand with its hidden bit, all zeros for a zero; MAN_W + 1 bits.
    pub fn significand(&self, b: &'b Builder, name: &str) -> Sig<'b> {
        let frac = self.frac & (!self.is_zero).rep(self.frac.width());
        b.cat(&[!self.is_zero, frac]).named(name)
    }
}

/// Parameter values at which every floating-point module is verified besides its defaults.
pub fn bindings() -> Vec<Binding> {
    let at = |e: i64, m: i64| Binding::from([("EXP_W".into(), e), ("MAN_W".into(), m)]);
    vec![at(7, 16), at(5, 10), at(8, 23), at(4, 3), at(3, 2), at(2, 2), at(11, 28)]
}
