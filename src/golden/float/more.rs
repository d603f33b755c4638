//! Square root, reciprocal, comparison in full, sum of three.
use super::arith::{div, order, signed, zero_sum};
use super::rounding::round;
use super::value::{Finite, Value, decode, infinity, invalid, zero};
use reliefrtl_base::format::FloatFormat;
use std::cmp::Ordering;

/// The square root, rounded once. Of -0 it is -0; of a negative number NaN, or where there is none, -0.
pub fn sqrt(fmt: FloatFormat, a: u64) -> u64 {
    match decode(fmt, a) {
        Value::Nan => fmt.nan(),
        Value::Zero(s) => zero(fmt, s),
        Value::Infinite(false) => infinity(fmt, false),
        Value::Infinite(true) => fmt.nan(),
        Value::Finite(x) if x.negative => invalid(fmt, true),
        Value::Finite(x) => {
            // The radicand as an integer of 126 or 127 bits times an even power of 2: the root has 63 bits or more.
            let up = x.sig.leading_zeros() as i32 - 1;
            let up = up - (x.exp - up).rem_euclid(2);
            let n = x.sig << up;
            let root = n.isqrt();
            round(fmt, false, root, (x.exp - up) / 2, root * root != n)
        }
    }
}

/// `1 / a`, rounded once; `1 / 0` is infinity, or the largest number where there is none.
pub fn recip(fmt: FloatFormat, a: u64) -> u64 {
    div(fmt, (fmt.bias() as u64) << fmt.man, a)
}

/// How `a` stands to `b`; `None` when either is NaN. The two zeros are equal.
pub fn compare(fmt: FloatFormat, a: u64, b: u64) -> Option<Ordering> {
    Some(order(fmt, a)?.cmp(&order(fmt, b)?))
}

/// `a + b + c`, rounded once. A sum of zero has the sign of its terms if they agree, else + (- when rounding down).
pub fn add3(fmt: FloatFormat, x: [u64; 3]) -> u64 {
    let terms = x.map(|v| decode(fmt, v));
    let infinite = terms.iter().filter_map(|v| if let Value::Infinite(s) = v { Some(*s) } else { None });
    let infinite: Vec<bool> = infinite.collect();
    if terms.contains(&Value::Nan) || (infinite.contains(&true) && infinite.contains(&false)) {
        return fmt.nan();
    }
    if let Some(s) = infinite.first() {
        return infinity(fmt, *s);
    }
    let mut numbers: Vec<Finite> =
        terms.iter().filter_map(|v| if let Value::Finite(f) = v { Some(*f) } else { None }).collect();
    numbers.sort_by_key(|f| f.exp);
    let sum = match numbers.iter().map(|f| Sum::of(*f)).collect::<Vec<_>>()[..] {
        [] => Sum { low: 0, exp: 0, rest: false },
        [one] => one,
        [small, large] => large.plus(small),
        // The larger two may cancel and leave the third: so they come first, unless they are too far apart for that.
        [small, middle, large, ..] if large.exp - middle.exp <= Sum::ROOM => match large.plus(middle) {
            Sum { low: 0, .. } => small,
            two => two.plus(small),
        },
        [small, middle, large, ..] => large.plus(middle.plus(small)),
    };
    match (sum.low, sum.rest) {
        (0, false) => zero_sum(fmt, &x.map(|v| v & fmt.sign_bit() != 0)),
        (low, rest) if low >= 0 => round(fmt, false, low.unsigned_abs(), sum.exp, rest),
        // -(n - r) for a rest r is n - 1 and the rest 1 - r.
        (low, rest) => round(fmt, true, low.unsigned_abs() - u128::from(rest), sum.exp, rest),
    }
}

/// `(low + r) * 2^exp`, `r` being 0, or with `rest` anything strictly between 0 and 1.
#[derive(Clone, Copy)]
struct Sum {
    low: i128,
    exp: i32,
    rest: bool,
}

impl Sum {
    /// Places below a significand to which a sum is kept: more than a second significand, whose sign alone counts there.
    const ROOM: i32 = 71;
    /// Bits in which it stands.
    const BITS: i32 = 53 + Self::ROOM;

    fn of(x: Finite) -> Self {
        Self { low: signed(x), exp: x.exp, rest: false }
    }
    /// The sum with a value whose last place is no higher. What falls below `BITS` bits is a rest.
    fn plus(self, small: Self) -> Self {
        let bits = i128::BITS as i32 - self.low.unsigned_abs().leading_zeros() as i32;
        let up = (self.exp - small.exp).min(Self::BITS - bits).max(0);
        let exp = self.exp - up;
        let down = exp - small.exp;
        let (tail, lost) = match down {
            0..=126 => (small.low >> down, small.low & ((1 << down) - 1) != 0),
            _ => (small.low >> 127, small.low != 0),
        };
        Self { low: (self.low << up) + tail, exp, rest: lost || small.rest }
    }
}
