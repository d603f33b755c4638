//! What happens inside of an operation that rounds: told from its results at more bits and with an exponent of more range, for one row.
use super::value::{Value, decode};
use reliefrtl_base::format::{FloatFormat, Rounding, Specials, Subnormals};

/// Exponent bits with which no operation on formats of at most 11 leaves the range.
const WIDE: u32 = 14;

/// Events of one row, as a set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Events(u32);

macro_rules! events {
    ($($(#[$doc:meta])* $name:ident = $bit:literal $word:literal),+ $(,)?) => {
        impl Events {
            $($(#[$doc])* pub const $name: Self = Self(1 << $bit);)+
            /// Each with its name.
            pub const ALL: &'static [(Self, &'static str)] = &[$((Self::$name, $word)),+];
        }
    };
}
events!(
    /// A number that needs no rounding.
    EXACT = 0 "exact",
    /// Half-way between two numbers.
    TIE = 1 "tie",
    /// Below half-way, by bits after the guard bit alone.
    STICKY = 2 "sticky only",
    /// Above half-way.
    ABOVE = 3 "above half",
    /// Rounding carried into the exponent.
    CARRY = 4 "carry out of rounding",
    /// A sum's leading bit is one place below that of its largest term.
    CANCEL_ONE = 5 "cancellation by one bit",
    /// Two places or more.
    CANCEL_MANY = 6 "cancellation by many bits",
    /// A sum of nonzero terms is zero.
    CANCEL_ALL = 7 "cancellation to zero",
    /// Beyond the largest number before it was rounded.
    OVERFLOW = 8 "overflow",
    /// Beyond it only because it was rounded.
    OVERFLOW_ROUNDED = 9 "overflow by rounding",
    /// Below the smallest normal number, rounded as if exponents had no end.
    UNDERFLOW = 10 "underflow",
    /// Below it, but not any more when rounded.
    NOT_UNDERFLOW = 11 "up to the smallest normal number by rounding",
    /// A number of fewer bits comes out.
    SUBNORMAL = 12 "subnormal result",
    /// Not zero, but zero comes out by rounding or by flushing.
    VANISHES = 13 "zero from another number",
    /// An exact zero from a sum of zeros, a product or a quotient.
    ZERO = 14 "zero",
    /// Infinity or NaN without rounding (where there is none, what stands for it).
    SPECIAL = 15 "infinity or NaN",
);

impl Events {
    /// Whether all of `other` are there.
    pub const fn has(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }
    fn when(self, yes: bool, then: Self) -> Self {
        Self(self.0 | if yes { then.0 } else { 0 })
    }
}

/// Events of the operation `op` on a row `x`, whose words are encoded numbers where `float` says so. `op` gives the result of the row in
/// a format; operands are then encoded in it. `sum` says that cancellation means something.
///
/// # Panics
/// If the format has more than 11 exponent bits.
pub fn events(
    fmt: FloatFormat,
    sum: bool,
    x: &[u64],
    float: &[bool],
    op: &dyn Fn(FloatFormat, &[u64]) -> u64,
) -> Events {
    assert!(fmt.exp <= 11, "{} exponent bits", fmt.exp);
    let at = |man: u32, rounding: Rounding| {
        let wide = FloatFormat { exp: WIDE, man, rounding, subnormals: Subnormals::Flush, specials: Specials::Ieee };
        let row: Vec<u64> = x.iter().zip(float).map(|(v, f)| if *f { widened(fmt, *v, wide) } else { *v }).collect();
        (wide, op(wide, &row))
    };
    // One bit more than the format has, cut: the guard bit. Whether there is more after it, both directions say together.
    let (cut, z) = at(fmt.man + 1, Rounding::TowardZero);
    let after = at(fmt.man + 1, Rounding::Up).1 != at(fmt.man + 1, Rounding::Down).1;
    let terms = || x.iter().zip(float).filter(|(_, f)| **f).map(|(v, _)| top(fmt, *v));
    let (guarded, place) = match decode(cut, z) {
        Value::Nan | Value::Infinite(_) => return Events::SPECIAL,
        Value::Zero(_) if sum && terms().any(|t| t.is_some()) => return Events::CANCEL_ALL,
        Value::Zero(_) => return Events::ZERO,
        Value::Finite(f) => (f.sig, f.exp + cut.man as i32),
    };
    let least = 1 - fmt.bias();
    let greatest = fmt.exp_max() as i32 - fmt.bias() - i32::from(!fmt.is_finite());
    let gradual = fmt.is_gradual() && place < least;
    // The place of the guard bit: further up in a subnormal number.
    let up = if gradual { (least - place).min(100) as u32 } else { 0 };
    let guard = guarded >> up & 1 == 1;
    let sticky = after || guarded & ((1 << up) - 1) != 0;
    let out = op(fmt, x);
    let (rounded, after) = if gradual { (fmt, out) } else { at(fmt.man, fmt.rounding) };
    let after = top(rounded, after);
    let mut e = match (guard, sticky) {
        (false, false) => Events::EXACT,
        (true, false) => Events::TIE,
        (false, true) => Events::STICKY,
        (true, true) => Events::ABOVE,
    };
    if sum {
        let lost = terms().flatten().max().unwrap_or(place) - place;
        e = e.when(lost == 1, Events::CANCEL_ONE).when(lost > 1, Events::CANCEL_MANY);
    }
    let beyond = after.is_some_and(|t| t > greatest);
    let below = after.is_none_or(|t| t < least);
    let code = out & (fmt.sign_bit() - 1);
    e.when(after.is_some_and(|t| t > place), Events::CARRY)
        .when(place > greatest, Events::OVERFLOW)
        .when(place <= greatest && beyond, Events::OVERFLOW_ROUNDED)
        .when(below, Events::UNDERFLOW)
        .when(place < least && !below, Events::NOT_UNDERFLOW)
        .when(fmt.is_gradual() && code != 0 && code <= fmt.man_mask(), Events::SUBNORMAL)
        .when(code == 0, Events::VANISHES)
}

/// The exponent of a number's leading bit; `None` for zeros, infinities and NaN.
fn top(fmt: FloatFormat, a: u64) -> Option<i32> {
    match decode(fmt, a) {
        Value::Finite(f) => Some(f.exp + fmt.man as i32),
        _ => None,
    }
}

/// The same number in a format that has room for it.
fn widened(fmt: FloatFormat, a: u64, wide: FloatFormat) -> u64 {
    let sign = |negative: bool| if negative { wide.sign_bit() } else { 0 };
    match decode(fmt, a) {
        Value::Nan => wide.nan(),
        Value::Infinite(s) => sign(s) | wide.infinity(),
        Value::Zero(s) => sign(s),
        Value::Finite(f) => {
            let field = (f.exp + fmt.man as i32 + wide.bias()) as u64;
            let fraction = (f.sig as u64 & fmt.man_mask()) << (wide.man - fmt.man);
            sign(f.negative) | field << wide.man | fraction
        }
    }
}
