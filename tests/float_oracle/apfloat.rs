//! The first oracle: rustc_apfloat with the format's precision.
use crate::Op;
use reliefrtl::format::FloatFormat;
use rustc_apfloat::ieee::{IeeeFloat, Semantics};
use rustc_apfloat::{Float, Round};

/// Exponent bits of the wide type: room for any exponent that a product or quotient can have.
const WIDE: u32 = 13;

/// A type of the same precision as a format with `MAN` fraction bits, in which nothing under- or overflows.
struct Wide<const MAN: usize>;

impl<const MAN: usize> Semantics for Wide<MAN> {
    const BITS: usize = 1 + WIDE as usize + MAN;
    const EXP_BITS: usize = WIDE as usize;
}

/// The format as published, with rustc_apfloat's own range.
pub struct Fp24;

impl Semantics for Fp24 {
    const BITS: usize = 24;
    const EXP_BITS: usize = 7;
}

/// Result by rustc_apfloat: round in the wide type, then look at the range.
pub fn apfloat(op: Op, fmt: FloatFormat, a: u64, b: u64) -> u64 {
    match fmt.man {
        1 => by_apfloat::<1>(op, fmt, a, b),
        2 => by_apfloat::<2>(op, fmt, a, b),
        3 => by_apfloat::<3>(op, fmt, a, b),
        10 => by_apfloat::<10>(op, fmt, a, b),
        16 => by_apfloat::<16>(op, fmt, a, b),
        23 => by_apfloat::<23>(op, fmt, a, b),
        man => panic!("no semantics of {man} fraction bits"),
    }
}

fn by_apfloat<const MAN: usize>(op: Op, fmt: FloatFormat, a: u64, b: u64) -> u64 {
    let (x, y) = (widen::<MAN>(fmt, a), widen::<MAN>(fmt, b));
    let round = Round::NearestTiesToEven;
    match op {
        Op::Add => narrow(fmt, x.add_r(y, round).value),
        Op::Mul => narrow(fmt, x.mul_r(y, round).value),
        Op::Div => narrow(fmt, x.div_r(y, round).value),
        Op::Lt => u64::from(x < y),
    }
}

fn widen<const MAN: usize>(fmt: FloatFormat, a: u64) -> IeeeFloat<Wide<MAN>> {
    let (sign, field, fraction) = (a >> (fmt.width() - 1), (a >> MAN) % (1 << fmt.exp), a % (1 << MAN));
    let value = if field == (1 << fmt.exp) - 1 {
        if fraction == 0 { IeeeFloat::INFINITY } else { IeeeFloat::NAN }
    } else if field == 0 {
        IeeeFloat::ZERO
    } else {
        let field = field + (1 << (WIDE - 1)) - (1 << (fmt.exp - 1));
        IeeeFloat::from_bits(u128::from((field << MAN) | fraction))
    };
    if sign == 1 { -value } else { value }
}

fn narrow<const MAN: usize>(fmt: FloatFormat, x: IeeeFloat<Wide<MAN>>) -> u64 {
    let sign = if x.is_negative() { fmt.sign_bit() } else { 0 };
    if x.is_nan() {
        return fmt.nan();
    }
    let bits = x.to_bits() as u64;
    let field = ((bits >> MAN) % (1 << WIDE)) as i64 - (1 << (WIDE - 1)) + (1 << (fmt.exp - 1));
    if x.is_zero() || field < 1 {
        sign
    } else if x.is_infinite() || field >= (1 << fmt.exp) - 1 {
        sign | fmt.infinity()
    } else {
        sign | ((field as u64) << MAN) | (bits % (1 << MAN))
    }
}
