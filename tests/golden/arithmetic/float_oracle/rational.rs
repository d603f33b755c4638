//! The second oracle: exact fractions, rounded once as a textbook says it.
use super::Op;
use dashu::base::{BitTest, SquareRoot};
use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;
use reliefrtl::format::{FloatFormat, Rounding};
use std::cmp::Ordering;

/// An operand or result as the schoolbook knows it: an exact fraction, or one of the special cases.
#[derive(Clone, Debug)]
pub enum Exact {
    Nan,
    Infinite(bool),
    /// The sign stands beside the value because zeros have one.
    Number(bool, RBig),
    /// An answer that is no number: of a comparison.
    Code(u64),
    /// No answer, where there is no NaN; a zero of this sign stands for it.
    Invalid(bool),
}

fn exact(fmt: FloatFormat, a: u64) -> Exact {
    let negative = a >> (fmt.exp + fmt.man) & 1 == 1;
    let (field, fraction) = ((a >> fmt.man) % (1 << fmt.exp), a % (1 << fmt.man));
    if field == (1 << fmt.exp) - 1 && !fmt.is_finite() {
        return if fraction == 0 { Exact::Infinite(negative) } else { Exact::Nan };
    }
    let (field, sig) = match field {
        0 if fmt.is_gradual() => (1, fraction),
        0 => (1, 0),
        _ => (field, fraction + (1 << fmt.man)),
    };
    let e = field as i64 - i64::from(fmt.bias()) - i64::from(fmt.man);
    let magnitude = RBig::from(sig) * power(e);
    Exact::Number(negative, if negative { -magnitude } else { magnitude })
}

/// The value of a code that is a number.
pub fn value(fmt: FloatFormat, a: u64) -> Option<RBig> {
    if let Exact::Number(_, x) = exact(fmt, a) { Some(x) } else { None }
}

/// 2^e.
fn power(e: i64) -> RBig {
    let big = UBig::ONE << e.unsigned_abs() as usize;
    if e < 0 { RBig::from_parts(IBig::ONE, big) } else { RBig::from(big) }
}

/// Where an exact nonzero value stands between its neighbours.
pub struct Place {
    negative: bool,
    /// The neighbour toward zero, in units of 2^last.
    below: u64,
    last: i64,
    /// The part above it, compared with 0 and with half a unit.
    rest: bool,
    half: Ordering,
}

impl Place {
    /// Neighbours of man + 1 bits, or of fewer where numbers are subnormal.
    pub fn of(fmt: FloatFormat, x: &RBig) -> Self {
        let negative = *x < RBig::ZERO;
        let x = if negative { -x.clone() } else { x.clone() };
        // 2^e <= x < 2^(e + 1), found from the lengths of numerator and denominator.
        let mut e = x.numerator().bit_len() as i64 - x.denominator().bit_len() as i64;
        if power(e) > x {
            e -= 1;
        }
        assert!(power(e) <= x && x < power(e + 1));
        let least = 1 - i64::from(fmt.bias());
        let last = if fmt.is_gradual() { e.max(least) } else { e } - i64::from(fmt.man);
        let scaled = &x / power(last);
        let below = scaled.floor();
        let rest = scaled - RBig::from(below.clone());
        let half = rest.cmp(&RBig::from_parts(IBig::ONE, UBig::from(2u8)));
        Self { negative, below: u64::try_from(below).expect("man + 1 bits"), last, rest: rest > RBig::ZERO, half }
    }
    /// The code of the neighbour that the format's rounding chooses; then the range.
    pub fn round(&self, fmt: FloatFormat) -> u64 {
        let sign = if self.negative { fmt.sign_bit() } else { 0 };
        let outward = match fmt.rounding {
            Rounding::NearestEven => {
                self.half == Ordering::Greater || (self.half == Ordering::Equal && self.below % 2 == 1)
            }
            Rounding::NearestAway => self.half != Ordering::Less,
            Rounding::TowardZero => false,
            Rounding::Up => self.rest && !self.negative,
            Rounding::Down => self.rest && self.negative,
        };
        let (mut kept, mut last) = (self.below + u64::from(outward), self.last);
        if kept == 2 << fmt.man {
            kept /= 2;
            last += 1;
        }
        let field = last + i64::from(fmt.man) + i64::from(fmt.bias());
        let top = (1i64 << fmt.exp) - 1;
        let (infinity, largest, most) = match fmt.is_finite() {
            true => (fmt.sign_bit() - 1, fmt.sign_bit() - 1, top),
            false => (fmt.infinity(), fmt.infinity() - 1, top - 1),
        };
        if field > most {
            let inward = match fmt.rounding {
                Rounding::TowardZero => true,
                Rounding::Up => self.negative,
                Rounding::Down => !self.negative,
                Rounding::NearestEven | Rounding::NearestAway => false,
            };
            sign | if inward { largest } else { infinity }
        } else if field < 1 {
            sign
        } else if kept < 1 << fmt.man {
            sign | kept
        } else {
            sign | ((field as u64) << fmt.man) | (kept - (1 << fmt.man))
        }
    }
}

/// Rounds an exact nonzero value.
pub fn round_exact(fmt: FloatFormat, x: &RBig) -> u64 {
    Place::of(fmt, x).round(fmt)
}

/// A result before its rounding: exact fractions need only be computed once for all of them.
pub enum Before {
    /// Nothing is rounded.
    Special(Exact),
    /// A sum of zero, of terms of these signs.
    Cancelled(Vec<bool>),
    /// A number other than zero.
    At(Place),
}

impl Before {
    /// Of an operation; the format's rounding is not looked at. Sqrt and Recip take the first operand.
    pub fn of(op: Op, fmt: FloatFormat, x: [u64; 3]) -> Self {
        let signs = |n: usize| x[..n].iter().map(|a| a >> (fmt.exp + fmt.man) & 1 == 1).collect();
        match (op, result(op, fmt, x)) {
            (Op::Add, Exact::Number(_, v)) if v == RBig::ZERO => Self::Cancelled(signs(2)),
            (Op::Add3, Exact::Number(_, v)) if v == RBig::ZERO => Self::Cancelled(signs(3)),
            (_, Exact::Number(_, v)) if v != RBig::ZERO => Self::At(Place::of(fmt, &v)),
            (_, special) => Self::Special(special),
        }
    }
    /// The code in this format, which may differ from that of `of` in its rounding.
    pub fn code(&self, fmt: FloatFormat) -> u64 {
        let zero = |negative: bool| if negative { fmt.sign_bit() } else { 0 };
        match self {
            Self::At(place) => place.round(fmt),
            Self::Cancelled(signs) if signs.iter().all(|s| *s == signs[0]) => zero(signs[0]),
            Self::Cancelled(_) => zero(fmt.rounding == Rounding::Down),
            Self::Special(Exact::Nan) => fmt.nan(),
            Self::Special(Exact::Infinite(s)) if fmt.is_finite() => zero(*s) | (fmt.sign_bit() - 1),
            Self::Special(Exact::Infinite(s)) => zero(*s) | fmt.infinity(),
            Self::Special(Exact::Number(s, _) | Exact::Invalid(s)) => zero(*s),
            Self::Special(Exact::Code(c)) => *c,
        }
    }
}

/// Result by exact fractions, rounded once.
pub fn rational(op: Op, fmt: FloatFormat, x: [u64; 3]) -> u64 {
    Before::of(op, fmt, x).code(fmt)
}

fn result(op: Op, fmt: FloatFormat, x: [u64; 3]) -> Exact {
    use Exact::{Code, Infinite, Invalid, Nan, Number};
    let none = |s: bool| if fmt.is_finite() { Invalid(s) } else { Nan };
    let [a, b, c] = x.map(|v| exact(fmt, v));
    match (op, a, b) {
        (Op::Sqrt, a, _) => root(a, none(true)),
        (Op::Recip, a, _) => quotient(Number(false, RBig::ONE), a, none),
        (Op::Add3, a, b) => sum(sum(a, b), c),
        (Op::Lt | Op::Compare, a, b) => Code(match (op, order(&a, &b)) {
            (Op::Lt, o) => u64::from(o == Some(Ordering::Less)),
            (_, Some(Ordering::Less)) => 1,
            (_, Some(Ordering::Equal)) => 2,
            (_, Some(Ordering::Greater)) => 4,
            (_, None) => 8,
        }),
        (Op::Add, a, b) => sum(a, b),
        (Op::Div, a, b) => quotient(a, b, none),
        (Op::Mul, Nan, _) | (Op::Mul, _, Nan) => Nan,
        (Op::Mul, Infinite(s), Infinite(t)) => Infinite(s != t),
        (Op::Mul, Infinite(s), Number(t, x)) | (Op::Mul, Number(t, x), Infinite(s)) => {
            if x == RBig::ZERO {
                Nan
            } else {
                Infinite(s != t)
            }
        }
        (Op::Mul, Number(s, x), Number(t, y)) => Number(s != t, x * y),
        (op, a, b) => unreachable!("{op:?} of {a:?} and {b:?}"),
    }
}

fn order(a: &Exact, b: &Exact) -> Option<Ordering> {
    use Exact::{Infinite, Number};
    let side = |s: &bool| if *s { Ordering::Less } else { Ordering::Greater };
    match (a, b) {
        (Infinite(s), Infinite(t)) => Some(t.cmp(s)),
        (Infinite(s), Number(..)) => Some(side(s)),
        (Number(..), Infinite(t)) => Some(side(t).reverse()),
        (Number(_, x), Number(_, y)) => Some(x.cmp(y)),
        _ => None,
    }
}

fn sum(a: Exact, b: Exact) -> Exact {
    use Exact::{Infinite, Nan, Number};
    match (a, b) {
        (Infinite(s), Infinite(t)) if s != t => Nan,
        (Nan, _) | (_, Nan) => Nan,
        (Infinite(s), _) | (_, Infinite(s)) => Infinite(s),
        (Number(_, x), Number(_, y)) => Number(false, x + y),
        (a, b) => unreachable!("{a:?} + {b:?}"),
    }
}

fn quotient(a: Exact, b: Exact, none: impl Fn(bool) -> Exact) -> Exact {
    use Exact::{Infinite, Nan, Number};
    match (a, b) {
        (Nan, _) | (_, Nan) | (Infinite(_), Infinite(_)) => Nan,
        (Infinite(s), Number(t, _)) => Infinite(s != t),
        (Number(s, _), Infinite(t)) => Number(s != t, RBig::ZERO),
        (Number(s, x), Number(t, y)) => match (x == RBig::ZERO, y == RBig::ZERO) {
            (true, true) => none(s != t),
            (false, true) => Infinite(s != t),
            _ => Number(s != t, x / y),
        },
        (a, b) => unreachable!("{a:?} / {b:?}"),
    }
}

/// The square root, cut after 64 places and moved to the middle between two of them if it is not exact: it then rounds as the root
/// itself does, which has its neighbours at the same places.
fn root(a: Exact, none: Exact) -> Exact {
    use Exact::{Infinite, Nan, Number};
    match a {
        Number(s, x) if x == RBig::ZERO => Number(s, x),
        Number(true, _) => none,
        Infinite(true) => Nan,
        Number(false, x) => {
            let places = 64 + x.denominator().bit_len();
            let scaled = x * power(2 * places as i64);
            let n = UBig::try_from(scaled.floor()).expect("positive");
            let r = n.sqrt();
            let exact = RBig::from(&r * &r) == scaled;
            Number(
                false,
                (RBig::from(r) * RBig::from(2u8) + RBig::from(u8::from(!exact))) * power(-(places as i64) - 1),
            )
        }
        other => other,
    }
}
