//! Every rounding, with and without subnormals, infinities and NaN.
//!
//! Small formats with every operand (three of them in formats of at most `RELIEFRTL_TRIPLES` bits), larger ones with corners and `RELIEFRTL_CHOICES` random operands of each choice (at 5/10 and 8/23 a fiftieth, 2000 or more).
use super::apfloat::apfloat;
use super::operands::{corners, random_pairs};
use super::rational::{Before, round_exact, value};
use super::{Op, env};
use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;
use rayon::prelude::*;
use reliefrtl::format::{FloatFormat, Rounding, Specials, Subnormals};
use reliefrtl::golden::float;
use reliefrtl::vectors::{Campaign, Kind, Level, Plan, Shard, campaign_rows};

/// Every choice but the rounding.
fn kinds(fmt: FloatFormat) -> impl Iterator<Item = FloatFormat> {
    let each = Subnormals::ALL.iter().flat_map(|s| Specials::ALL.iter().map(move |x| (*s, *x)));
    each.map(move |(subnormals, specials)| FloatFormat { subnormals, specials, ..fmt })
}

/// Compares golden model and both oracles at every rounding; returns how many results agreed.
fn agree(op: Op, kind: FloatFormat, operands: impl ParallelIterator<Item = [u64; 3]>) -> usize {
    operands
        .map(|x| {
            let exact = Before::of(op, kind, x);
            for rounding in Rounding::ALL {
                let fmt = FloatFormat { rounding: *rounding, ..kind };
                let (got, first, second) = (op.golden(fmt, x), apfloat(op, fmt, x), exact.code(fmt));
                assert!(
                    got == first && got == second,
                    "{fmt} {op:?} {x:#x?}: golden {got:#x}, apfloat {first:#x}, rational {second:#x}"
                );
            }
            Rounding::ALL.len()
        })
        .sum()
}

/// The formats of at most 8 bits.
fn small() -> impl Iterator<Item = FloatFormat> {
    (2..=6).flat_map(|exp| (1..=7 - exp).map(move |man| FloatFormat::new(exp, man)))
}

#[test]
fn every_operand_of_every_small_format() {
    let (mut compared, mut formats) = (0, 0);
    for fmt in small() {
        let codes = 1u64 << fmt.width();
        formats += 1;
        for kind in kinds(fmt) {
            for op in Op::ALL {
                let second = if op.arity() == 1 { 1 } else { codes };
                if op.arity() == 3 {
                    continue;
                }
                let pairs = (0..codes * second).into_par_iter().map(|k| [k % codes, k / codes, 0]);
                compared += agree(op, kind, pairs);
            }
        }
    }
    println!("{formats} formats, all roundings, operands and pairs: 0 of {compared} mismatched");
    assert!(formats == 15 && compared > 10_000_000, "{compared} in {formats} formats");
}

#[test]
fn every_three_operands_of_the_smallest_formats() {
    let (mut compared, bits) = (0, env("RELIEFRTL_TRIPLES", 6));
    for fmt in small().filter(|f| f.width() as usize <= bits as usize) {
        let codes = 1u64 << fmt.width();
        for kind in kinds(fmt) {
            let threes = (0..codes.pow(3)).into_par_iter().map(|k| [k % codes, k / codes % codes, k / codes / codes]);
            compared += agree(Op::Add3, kind, threes);
        }
    }
    println!("add3, formats of at most {bits} bits: 0 of {compared} mismatched");
    assert!(compared > 1_000_000, "{compared}");
}

#[test]
fn corners_and_random_operands_of_larger_formats() {
    let (count, seed) = (env("RELIEFRTL_CHOICES", 4_000), env("RELIEFRTL_SEED", 1));
    let mut compared = 0;
    let fewer = (count / 50).max(2_000);
    let formats = [(FloatFormat::FP24, count), (FloatFormat::new(5, 10), fewer), (FloatFormat::new(8, 23), fewer)];
    let kinds = formats.into_iter().flat_map(|(fmt, count)| kinds(fmt).map(move |kind| (kind, count)));
    for (at, (kind, count)) in kinds.enumerate() {
        let table = corners(kind);
        let n = table.len() as u64;
        for op in Op::ALL {
            // One corner in some, at steps that share no factor with the table: every class meets every class.
            let step = 1 + n * n / count;
            let crossed = (0..n * n / step).into_par_iter().map(|k| k * step);
            let at_corner = |k: u64| table[(k % n) as usize];
            compared += agree(op, kind, crossed.map(|k| [at_corner(k), at_corner(k / n), at_corner(k * 7 + k / n)]));
            let (a, b): (Vec<_>, Vec<_>) = random_pairs(kind, seed + at as u64, count).unzip();
            let (c, _): (Vec<_>, Vec<_>) = random_pairs(kind, seed + 100 + at as u64, count).unzip();
            compared +=
                agree(op, kind, (0..a.len()).into_par_iter().map(|k| [a[k], b[k], third(kind, a[k], b[k], c[k])]));
        }
    }
    println!("7/16, 5/10, 8/23, all choices: 0 of {compared} mismatched (seed {seed})");
    assert!(compared > 40 * count as usize, "{compared}");
}

/// The large tables of corners crossed whole: one of `RELIEFRTL_PARTS` parts of them (default 40; 1 is all), every choice.
#[test]
fn crossed_corners_of_the_published_format() {
    let of = env("RELIEFRTL_PARTS", 40) as u32;
    let campaign = Campaign { level: Level::Two, shard: Shard { index: 1, of } };
    let mut compared = 0;
    for kind in kinds(FloatFormat::FP24) {
        for op in Op::ALL {
            let columns = vec![Kind::Float(kind); op.arity() as usize];
            let rows = campaign_rows(&columns, Plan { rows: 0, seed: 1 }, campaign).0;
            let of_row = |r: &Vec<u64>| [r[0], r.get(1).copied().unwrap_or(0), r.get(2).copied().unwrap_or(0)];
            compared += agree(op, kind, rows.par_iter().map(of_row));
        }
    }
    println!("7/16, all choices, corners of level 2, part 1 of {of}: 0 of {compared} mismatched");
    assert!(compared > 40_000_000 / of as usize, "{compared}");
}

/// A third term that is sometimes nearly what cancels the other two, or far below what they leave.
fn third(fmt: FloatFormat, a: u64, b: u64, any: u64) -> u64 {
    match any % 5 {
        0 => (a ^ fmt.sign_bit()).wrapping_add(any / 5 % 3) & (fmt.sign_bit() * 2 - 1),
        1 => b ^ fmt.sign_bit(),
        2 => (b & (fmt.exp_max() << fmt.man)).wrapping_sub((any / 5 % 40) << fmt.man) & (fmt.sign_bit() * 2 - 1),
        _ => any,
    }
}

#[test]
fn conversions_with_every_choice() {
    let mut compared = 0;
    let formats = [FloatFormat::new(3, 2), FloatFormat::new(4, 3), FloatFormat::new(5, 10), FloatFormat::FP24];
    for kind in formats.into_iter().flat_map(kinds) {
        let small = (-600i64..600).map(|v| (v, (v & 15) as u32));
        let large = (0..62).flat_map(|k| [-1i64, 0, 1].map(|d| ((1 << k) + d, k as u32 / 2)));
        for (v, frac) in small.chain(large.clone()).chain(large.map(|(v, f)| (-v, f))) {
            let x = RBig::from_parts(IBig::from(v), UBig::ONE << frac as usize);
            for rounding in Rounding::ALL {
                let fmt = FloatFormat { rounding: *rounding, ..kind };
                let expected = if v == 0 { 0 } else { round_exact(fmt, &x) };
                assert_eq!(float::from_fixed(fmt, v, frac), expected, "{fmt} {v} / 2^{frac}");
                compared += 1;
            }
        }
        let step = 1 << kind.width().saturating_sub(12);
        for (k, a) in (0..1u64 << kind.width()).step_by(step).chain(corners(kind)).enumerate() {
            let (width, frac) = (2 + (k % 40) as u32, (k % 17) as u32);
            let Some(x) = value(kind, a) else { continue };
            let (min, max) = (-(1i64 << (width - 1)), (1i64 << (width - 1)) - 1);
            let floor = (&x * RBig::from(UBig::ONE << frac as usize)).floor();
            let expected = i64::try_from(floor.clamp(IBig::from(min), IBig::from(max))).unwrap();
            assert_eq!(
                float::to_fixed(kind, a, width, frac),
                expected,
                "{kind} {a:#x} to {width} bits, {frac} of them fraction"
            );
            assert_eq!(RBig::try_from(float::to_f64(kind, a)).unwrap(), x, "{kind} {a:#x}");
            compared += 1;
        }
    }
    println!("conversions, all choices: 0 of {compared} mismatched");
    assert!(compared > 100_000, "{compared}");
}
