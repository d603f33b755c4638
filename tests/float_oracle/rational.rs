//! The second oracle: exact fractions, rounded once as a textbook says it.
use crate::Op;
use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;
use reliefrtl::format::FloatFormat;

/// An operand as the schoolbook knows it: an exact fraction, or one of the special cases.
enum Exact {
    Nan,
    Infinite(bool),
    /// The sign stands beside the value because zeros have one.
    Number(bool, RBig),
}

fn exact(fmt: FloatFormat, a: u64) -> Exact {
    let negative = a >> (fmt.exp + fmt.man) & 1 == 1;
    let (field, fraction) = ((a >> fmt.man) % (1 << fmt.exp), a % (1 << fmt.man));
    if field == (1 << fmt.exp) - 1 {
        return if fraction == 0 { Exact::Infinite(negative) } else { Exact::Nan };
    }
    if field == 0 {
        return Exact::Number(negative, RBig::ZERO);
    }
    let e = field as i64 - i64::from(fmt.bias()) - i64::from(fmt.man);
    let magnitude = RBig::from(fraction + (1 << fmt.man)) * power(e);
    Exact::Number(negative, if negative { -magnitude } else { magnitude })
}

/// 2^e.
fn power(e: i64) -> RBig {
    let big = UBig::ONE << e.unsigned_abs() as usize;
    if e < 0 { RBig::from_parts(IBig::ONE, big) } else { RBig::from(big) }
}

/// Rounds an exact nonzero value: the two neighbours with man + 1 bits, the nearer one, the even one on a tie; then the range.
pub fn round_exact(fmt: FloatFormat, x: &RBig) -> u64 {
    let sign = if *x < RBig::ZERO { fmt.sign_bit() } else { 0 };
    let x = if *x < RBig::ZERO { -x.clone() } else { x.clone() };
    // 2^e <= x < 2^(e + 1), found from the lengths of numerator and denominator.
    use dashu::base::BitTest;
    let mut e = x.numerator().bit_len() as i64 - x.denominator().bit_len() as i64;
    if power(e) > x {
        e -= 1;
    }
    assert!(power(e) <= x && x < power(e + 1));
    let unit = power(e - i64::from(fmt.man));
    let below = (&x / &unit).floor();
    let remainder = &x / &unit - RBig::from(below.clone());
    let half = RBig::from_parts(IBig::ONE, UBig::from(2u8));
    let odd = below.bit(0);
    let mut kept = u64::try_from(below).expect("man + 1 bits");
    if remainder > half || (remainder == half && odd) {
        kept += 1;
    }
    if kept == 2 << fmt.man {
        kept /= 2;
        e += 1;
    }
    let field = e + i64::from(fmt.bias());
    if field < 1 {
        sign
    } else if field >= (1 << fmt.exp) - 1 {
        sign | fmt.infinity()
    } else {
        sign | ((field as u64) << fmt.man) | (kept - (1 << fmt.man))
    }
}

/// Result by exact fractions, rounded once.
pub fn rational(op: Op, fmt: FloatFormat, a: u64, b: u64) -> u64 {
    use Exact::{Infinite, Nan, Number};
    let zero = |negative| if negative { fmt.sign_bit() } else { 0 };
    let infinity = |negative| zero(negative) | fmt.infinity();
    let result = |negative: bool, x: RBig| if x == RBig::ZERO { zero(negative) } else { round_exact(fmt, &x) };
    match (op, exact(fmt, a), exact(fmt, b)) {
        (Op::Lt, Nan, _) | (Op::Lt, _, Nan) => 0,
        (Op::Lt, Infinite(s), Infinite(t)) => u64::from(s && !t),
        (Op::Lt, Infinite(s), Number(..)) => u64::from(s),
        (Op::Lt, Number(..), Infinite(t)) => u64::from(!t),
        (Op::Lt, Number(_, x), Number(_, y)) => u64::from(x < y),
        (_, Nan, _) | (_, _, Nan) => fmt.nan(),
        (Op::Add, Infinite(s), Infinite(t)) => {
            if s == t {
                infinity(s)
            } else {
                fmt.nan()
            }
        }
        (Op::Add, Infinite(s), _) | (Op::Add, _, Infinite(s)) => infinity(s),
        (Op::Add, Number(s, x), Number(t, y)) => {
            let both_zero = x == RBig::ZERO && y == RBig::ZERO;
            result(both_zero && s && t, x + y)
        }
        (Op::Mul, Infinite(s), Infinite(t)) => infinity(s != t),
        (Op::Mul, Infinite(s), Number(t, x)) | (Op::Mul, Number(t, x), Infinite(s)) => {
            if x == RBig::ZERO {
                fmt.nan()
            } else {
                infinity(s != t)
            }
        }
        (Op::Mul, Number(s, x), Number(t, y)) => result(s != t, x * y),
        (Op::Div, Infinite(_), Infinite(_)) => fmt.nan(),
        (Op::Div, Infinite(s), Number(t, _)) => infinity(s != t),
        (Op::Div, Number(s, _), Infinite(t)) => zero(s != t),
        (Op::Div, Number(s, x), Number(t, y)) => match (x == RBig::ZERO, y == RBig::ZERO) {
            (true, true) => fmt.nan(),
            (false, true) => infinity(s != t),
            _ => result(s != t, x / y),
        },
    }
}
