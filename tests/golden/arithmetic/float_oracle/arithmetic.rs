//! Sum, product, quotient and comparison.
use super::apfloat::apfloat;
use super::operands::{corners, random_pairs};
use super::rational::rational;
use super::{Op, env};
use reliefrtl::format::FloatFormat;
use reliefrtl::golden::float;

/// Compares one operation on many operands, prints the count and fails on the first difference.
fn compare(op: Op, fmt: FloatFormat, what: &str, pairs: impl Iterator<Item = (u64, u64)>) {
    let (mut total, mut wrong, mut witness) = (0u64, 0u64, String::new());
    for (a, b) in pairs {
        // A third operand that comes near the others: their order turned round.
        let x = [a, b, b.rotate_left(1) & (u64::MAX >> (64 - fmt.width()))];
        let got = op.golden(fmt, x);
        let (first, second) = (apfloat(op, fmt, x), rational(op, fmt, x));
        total += 1;
        if got != first || got != second {
            wrong += 1;
            if witness.is_empty() {
                witness = format!("{op:?} {x:#x?}: golden {got:#x}, apfloat {first:#x}, rational {second:#x}");
            }
        }
    }
    println!("{fmt} {op:?}: {wrong} of {total} mismatched ({what}) {witness}");
    assert!(total > 0, "nothing was compared");
    assert_eq!(wrong, 0, "{witness}");
}

fn all_pairs(fmt: FloatFormat) {
    let codes = 1u64 << fmt.width();
    for op in Op::ALL {
        compare(op, fmt, "all pairs", (0..codes).flat_map(|a| (0..codes).map(move |b| (a, b))));
    }
}

#[test]
fn every_pair_of_the_smallest_format() {
    all_pairs(FloatFormat::new(3, 2));
}

#[test]
fn every_pair_of_a_small_format() {
    all_pairs(FloatFormat::new(4, 3));
}

#[test]
fn corners_of_the_published_format() {
    for fmt in [FloatFormat::FP24, FloatFormat::new(5, 10), FloatFormat::new(8, 23)] {
        let table = corners(fmt);
        for op in Op::ALL {
            compare(op, fmt, "corners", table.iter().flat_map(|&a| table.iter().map(move |&b| (a, b))));
        }
    }
}

#[test]
fn random_pairs_of_the_published_format() {
    let (count, seed) = (env("RELIEFRTL_PAIRS", 200_000), env("RELIEFRTL_SEED", 1));
    for (at, op) in Op::ALL.into_iter().enumerate() {
        compare(
            op,
            FloatFormat::FP24,
            &format!("seed {seed}"),
            random_pairs(FloatFormat::FP24, seed + at as u64, count),
        );
    }
}

#[test]
fn random_pairs_of_other_formats() {
    let (count, seed) = (env("RELIEFRTL_PAIRS", 200_000) / 10, env("RELIEFRTL_SEED", 1));
    for fmt in [FloatFormat::new(2, 1), FloatFormat::new(5, 10), FloatFormat::new(8, 23)] {
        for op in Op::ALL {
            compare(op, fmt, &format!("seed {seed}"), random_pairs(fmt, seed, count));
        }
    }
}

/// 11/52 is what the machine computes in, except for its subnormals: a third oracle for the widest format.
#[test]
fn the_widest_format_is_f64() {
    let fmt = FloatFormat::new(11, 52);
    let (count, seed) = (env("RELIEFRTL_PAIRS", 200_000), env("RELIEFRTL_SEED", 1));
    let flush = |x: f64| {
        if x.is_nan() {
            fmt.nan()
        } else if x.is_subnormal() {
            x.to_bits() & fmt.sign_bit()
        } else {
            x.to_bits()
        }
    };
    let (mut compared, mut ordinary) = (0u64, 0u64);
    for (a, b) in random_pairs(fmt, seed, count) {
        let (x, y) = (f64::from_bits(flush(f64::from_bits(a))), f64::from_bits(flush(f64::from_bits(b))));
        for (op, z) in [(Op::Add, x + y), (Op::Mul, x * y), (Op::Div, x / y)] {
            // The machine rounds once, at subnormal precision; what may have been rounded up into the normal range is left out.
            if z.abs() != f64::MIN_POSITIVE {
                assert_eq!(op.golden(fmt, [a, b, 0]), flush(z), "{op:?} {a:#x} {b:#x}");
                compared += 1;
                ordinary += u64::from(z.is_normal());
            }
        }
        assert_eq!(float::lt(fmt, a, b), x < y);
    }
    println!("11/52: 0 of {compared} mismatched, {ordinary} of them normal numbers (against f64, seed {seed})");
    assert!(compared > 0 && ordinary > compared / 2, "the operands say too little");
}
