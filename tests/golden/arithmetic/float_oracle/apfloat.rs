//! The first oracle: rustc_apfloat with the format's precision.
use super::Op;
use reliefrtl::format::{FloatFormat, Rounding};
use rustc_apfloat::ieee::{IeeeFloat, Semantics};
use rustc_apfloat::{Float, FloatConvert, Round, Status, StatusAnd};

/// Exponent bits of the wide type: room for any exponent that a product or quotient can have.
const WIDE: u32 = 13;

/// A type of the same precision as a format with `MAN` fraction bits, in which nothing under- or overflows.
struct Wide<const MAN: usize>;

impl<const MAN: usize> Semantics for Wide<MAN> {
    const BITS: usize = 1 + WIDE as usize + MAN;
    const EXP_BITS: usize = WIDE as usize;
}

/// A type of 113 bits, for results that are rounded later: toward zero with the last bit set if something was lost, they round
/// to any precision of at most 111 bits as the exact ones do.
struct Long;

impl Semantics for Long {
    const BITS: usize = 128;
    const EXP_BITS: usize = 15;
}

type Exact = IeeeFloat<Long>;

/// The format as published, with rustc_apfloat's own range.
pub struct Fp24;

impl Semantics for Fp24 {
    const BITS: usize = 24;
    const EXP_BITS: usize = 7;
}

/// Result by rustc_apfloat: round in the wide type, then look at the range. Sqrt and Recip take the first operand.
pub fn apfloat(op: Op, fmt: FloatFormat, x: [u64; 3]) -> u64 {
    match fmt.man {
        1 => by_apfloat::<1>(op, fmt, x),
        2 => by_apfloat::<2>(op, fmt, x),
        3 => by_apfloat::<3>(op, fmt, x),
        4 => by_apfloat::<4>(op, fmt, x),
        5 => by_apfloat::<5>(op, fmt, x),
        10 => by_apfloat::<10>(op, fmt, x),
        16 => by_apfloat::<16>(op, fmt, x),
        23 => by_apfloat::<23>(op, fmt, x),
        man => panic!("no semantics of {man} fraction bits"),
    }
}

/// The name that rustc_apfloat has for a rounding.
pub fn direction(fmt: FloatFormat) -> Round {
    match fmt.rounding {
        Rounding::NearestEven => Round::NearestTiesToEven,
        Rounding::NearestAway => Round::NearestTiesToAway,
        Rounding::TowardZero => Round::TowardZero,
        Rounding::Up => Round::TowardPositive,
        Rounding::Down => Round::TowardNegative,
    }
}

fn by_apfloat<const MAN: usize>(op: Op, fmt: FloatFormat, x: [u64; 3]) -> u64 {
    let [a, b, c] = x.map(|v| read(fmt, v));
    let one = read(fmt, (fmt.bias() as u64) << fmt.man);
    let round = direction(fmt);
    let order = |lt: u64, eq: u64, gt: u64, none: u64| match a.partial_cmp(&b) {
        Some(std::cmp::Ordering::Less) => lt,
        Some(std::cmp::Ordering::Equal) => eq,
        Some(std::cmp::Ordering::Greater) => gt,
        None => none,
    };
    // Where it can round at once, it does.
    if !fmt.is_gradual() && matches!(op, Op::Add | Op::Mul | Op::Div) {
        let [x, y] = [a, b].map(wide::<MAN>);
        let r = match op {
            Op::Add => x.add_r(y, round),
            Op::Mul => x.mul_r(y, round),
            _ => x.div_r(y, round),
        };
        return write(fmt, r.value, (a.is_negative()) != (b.is_negative()));
    }
    let (exact, sign) = match op {
        Op::Lt => return order(1, 0, 0, 0),
        Op::Compare => return order(1, 2, 4, 8),
        Op::Add => (sum(a, b, round), false),
        Op::Mul => (odd(a.mul_r(b, Round::TowardZero)), false),
        Op::Div => (odd(a.div_r(b, Round::TowardZero)), a.is_negative() != b.is_negative()),
        Op::Recip => (odd(one.div_r(a, Round::TowardZero)), a.is_negative()),
        Op::Sqrt => (root(a), true),
        Op::Add3 => (sum3([a, b, c], round), false),
    };
    if !fmt.is_gradual() || !exact.is_finite_non_zero() {
        return write(fmt, narrow::<MAN>(exact, round), sign);
    }
    // The least exponents fall together, so that subnormals are those of the wide type.
    let down = <Wide<MAN> as Semantics>::MIN_EXP - (1 - fmt.bias());
    let rounded = narrow::<MAN>(exact.scalbn_r(down, round), round);
    write(fmt, rounded.scalbn_r(-down, round), sign)
}

/// The exact value of a code.
fn read(fmt: FloatFormat, a: u64) -> Exact {
    let man = fmt.man;
    let (sign, field, fraction) = (a >> (fmt.width() - 1) & 1, (a >> man) % (1 << fmt.exp), a % (1 << man));
    let scaled =
        |sig: u64, field: u64| Exact::from_u128(u128::from(sig)).value.scalbn(field as i32 - fmt.bias() - man as i32);
    let value = if field == (1 << fmt.exp) - 1 && !fmt.is_finite() {
        if fraction == 0 { Exact::INFINITY } else { Exact::NAN }
    } else if field == 0 {
        if fmt.is_gradual() { scaled(fraction, 1) } else { Exact::ZERO }
    } else {
        scaled(fraction + (1 << man), field)
    };
    if sign == 1 { -value } else { value }
}

fn wide<const MAN: usize>(x: Exact) -> IeeeFloat<Wide<MAN>> {
    narrow(x, Round::NearestTiesToEven)
}

fn narrow<const MAN: usize>(x: Exact, round: Round) -> IeeeFloat<Wide<MAN>> {
    let r: StatusAnd<IeeeFloat<Wide<MAN>>> = x.convert_r(round, &mut false);
    r.value
}

/// A result that was rounded toward zero, with its last bit set if it is not exact.
fn odd(r: StatusAnd<Exact>) -> Exact {
    if r.status.contains(Status::INEXACT) { Exact::from_bits(r.value.to_bits() | 1) } else { r.value }
}

fn sum(a: Exact, b: Exact, round: Round) -> Exact {
    let r = a.add_r(b, Round::TowardZero);
    // The direction decides about the sign of an exact zero.
    if r.value.is_zero() { a.add_r(b, round).value } else { odd(r) }
}

fn sum3(mut x: [Exact; 3], round: Round) -> Exact {
    if x.iter().any(|v| !v.is_finite()) {
        return x[0].add_r(x[1], round).value.add_r(x[2], round).value;
    }
    let agree = x.iter().all(|v| v.is_negative() == x[0].is_negative());
    x.sort_by(|a, b| b.abs().partial_cmp(&a.abs()).expect("no NaN"));
    let two = x[0].add_r(x[1], Round::TowardZero);
    let r = if two.status.contains(Status::INEXACT) {
        // So far apart, the second and third count by the sign of their sum.
        sum(x[0], sum(x[1], x[2], round), round)
    } else {
        sum(two.value, x[2], round)
    };
    let minus = if agree { x[0].is_negative() } else { round == Round::TowardNegative };
    match (r.is_zero(), minus) {
        (false, _) => r,
        (true, false) => Exact::ZERO,
        (true, true) => -Exact::ZERO,
    }
}

/// The square root by trial: bit after bit, as long as the exact square is not beyond.
fn root(x: Exact) -> Exact {
    if x.is_nan() || x.is_zero() || (x.is_infinite() && !x.is_negative()) {
        return x;
    }
    if x.is_negative() {
        return Exact::NAN;
    }
    let mut bit = Exact::from_u128(1).value.scalbn(x.ilogb().div_euclid(2));
    let mut r = Exact::ZERO;
    let square = |v: Exact| {
        let s = v.mul_r(v, Round::TowardZero);
        assert!(!s.status.contains(Status::INEXACT), "a square of few bits is exact");
        s.value
    };
    for _ in 0..40 {
        let more = r.add_r(bit, Round::TowardZero).value;
        if square(more) <= x {
            r = more;
        }
        bit = bit.scalbn(-1);
    }
    if square(r) == x { r } else { Exact::from_bits(r.to_bits() | 1) }
}

/// Puts a rounded value into the format; `sign` is that of a result where there is none.
fn write<const MAN: usize>(fmt: FloatFormat, x: IeeeFloat<Wide<MAN>>, sign: bool) -> u64 {
    let with = |negative: bool, code: u64| if negative { fmt.sign_bit() | code } else { code };
    if x.is_nan() {
        return if fmt.is_finite() { with(sign, 0) } else { fmt.nan() };
    }
    let negative = x.is_negative();
    let (top, ones) = ((1i64 << fmt.exp) - 1, fmt.sign_bit() - 1);
    let (infinity, largest) = if fmt.is_finite() { (ones, ones) } else { (fmt.infinity(), fmt.infinity() - 1) };
    let bits = x.to_bits() as u64;
    let field = ((bits >> MAN) % (1 << WIDE)) as i64 - (1 << (WIDE - 1)) + (1 << (fmt.exp - 1));
    let beyond = if fmt.is_finite() { top + 1 } else { top };
    let code = if x.is_zero() {
        0
    } else if x.is_infinite() {
        infinity
    } else if field >= beyond {
        let inward = match fmt.rounding {
            Rounding::NearestEven | Rounding::NearestAway => false,
            Rounding::TowardZero => true,
            Rounding::Up => negative,
            Rounding::Down => !negative,
        };
        if inward { largest } else { infinity }
    } else if field >= 1 {
        ((field as u64) << MAN) | (bits % (1 << MAN))
    } else if fmt.is_gradual() {
        let down = 1 - field;
        assert!(down <= MAN as i64, "rounded to what the format holds");
        ((1 << MAN) | (bits % (1 << MAN))) >> down
    } else {
        0
    };
    with(negative, code)
}
