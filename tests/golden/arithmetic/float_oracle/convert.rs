//! The golden conversions against exact fractions and rustc_apfloat.
use super::apfloat::Fp24;
use super::env;
use super::operands::corners;
use super::rational::round_exact;
use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;
use proptest::prelude::*;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::format::FloatFormat;
use reliefrtl::golden::float;
use rustc_apfloat::ieee::IeeeFloat;
use rustc_apfloat::{Float, Round};

const FORMATS: [FloatFormat; 5] = [
    FloatFormat::new(3, 2),
    FloatFormat::new(4, 3),
    FloatFormat::new(5, 10),
    FloatFormat::FP24,
    FloatFormat::new(8, 23),
];

fn fixed(v: i64, frac: u32) -> RBig {
    RBig::from_parts(IBig::from(v), UBig::ONE << frac as usize)
}

fn integers(count: u64) -> impl Iterator<Item = i64> {
    let mut rng = ChaCha8Rng::seed_from_u64(env("RELIEFRTL_SEED", 1));
    let random = (0..count).map(move |_| rng.random::<i64>() >> rng.random_range(0..63));
    let edges = (0..63).flat_map(|k| [(1i64 << k) - 1, 1 << k, (1 << k) + 1].map(|v| [v, -v])).flatten();
    (-70_000..70_000).chain(edges).chain([i64::MIN, i64::MAX]).chain(random)
}

#[test]
fn from_fixed_rounds_the_exact_fraction() {
    let mut compared = 0u64;
    for fmt in FORMATS {
        for v in integers(env("RELIEFRTL_PAIRS", 200_000) / 20) {
            let frac = (v % 40).unsigned_abs() as u32;
            for frac in [0, frac] {
                let expected = if v == 0 { 0 } else { round_exact(fmt, &fixed(v, frac)) };
                assert_eq!(float::from_fixed(fmt, v, frac), expected, "{fmt} {v} / 2^{frac}");
                compared += 1;
            }
            assert_eq!(float::from_int(fmt, v), float::from_fixed(fmt, v, 0));
        }
    }
    println!("from_fixed: 0 of {compared} mismatched");
    assert!(compared > 0);
}

#[test]
fn from_int_and_to_int_agree_with_apfloat() {
    let fmt = FloatFormat::FP24;
    let mut compared = 0u64;
    for v in integers(env("RELIEFRTL_PAIRS", 200_000)) {
        let by: IeeeFloat<Fp24> = IeeeFloat::from_i128_r(i128::from(v), Round::NearestTiesToEven).value;
        assert_eq!(u128::from(float::from_int(fmt, v)), by.to_bits(), "{v}");
        compared += 1;
    }
    // All codes whose value apfloat does not read as subnormal.
    for a in 0..1u64 << 24 {
        let x: IeeeFloat<Fp24> = IeeeFloat::from_bits(u128::from(a));
        if x.is_denormal() || x.is_nan() {
            continue;
        }
        let width = 2 + (a % 40) as u32;
        let by = x.to_i128_r(width as usize, Round::TowardNegative, &mut false).value;
        assert_eq!(i128::from(float::to_int(fmt, a, width)), by, "{a:#x} to {width} bits");
        compared += 1;
    }
    println!("from_int, to_int: 0 of {compared} mismatched");
}

#[test]
fn to_fixed_is_the_saturated_floor() {
    let mut compared = 0u64;
    let mut rng = ChaCha8Rng::seed_from_u64(env("RELIEFRTL_SEED", 1));
    for fmt in FORMATS {
        let codes = 1u64 << fmt.width();
        let random: Vec<u64> = (0..20_000).map(|_| rng.random_range(0..codes)).collect();
        let all = if fmt.width() <= 16 { (0..codes).collect() } else { [random, corners(fmt)].concat() };
        for a in all {
            let (width, frac) = (rng.random_range(2..=63u32), rng.random_range(0..20));
            let got = float::to_fixed(fmt, a, width, frac);
            let (min, max) = (-(1i64 << (width - 1)), (1i64 << (width - 1)) - 1);
            let x = float::to_f64(fmt, a);
            let expected = if x.is_nan() {
                0
            } else if x.is_infinite() {
                if x > 0.0 { max } else { min }
            } else {
                let floor = (RBig::try_from(x).unwrap() * RBig::from(UBig::ONE << frac as usize)).floor();
                i64::try_from(floor.clamp(IBig::from(min), IBig::from(max))).unwrap()
            };
            assert_eq!(got, expected, "{fmt} {a:#x} to {width} bits, {frac} of them fraction");
            compared += 1;
        }
    }
    println!("to_fixed: 0 of {compared} mismatched");
    assert!(compared > 0);
}

#[test]
fn reciprocals_are_rounded_once() {
    for fmt in FORMATS {
        for m in (1..70_000u64).chain((0..64).map(|k| u64::MAX >> k)) {
            let x = RBig::from_parts(IBig::ONE, UBig::from(m));
            assert_eq!(float::recip_int(fmt, m), round_exact(fmt, &x), "{fmt} 1/{m}");
        }
    }
}

#[test]
fn f64_and_back() {
    for fmt in [FloatFormat::new(3, 2), FloatFormat::new(5, 10), FloatFormat::FP24] {
        for a in 0..1u64 << fmt.width() {
            let x = float::to_f64(fmt, a);
            let expected = match float::decode(fmt, a) {
                float::Value::Nan => fmt.nan(),
                float::Value::Zero(_) => a & fmt.sign_bit(),
                _ => a,
            };
            assert_eq!(float::from_f64(fmt, x), expected, "{fmt} {a:#x}");
        }
    }
    let small = FloatFormat::new(3, 2);
    assert_eq!(float::to_f64(small, 0b00_0100), 0.25);
    assert_eq!(float::to_f64(small, 0b11_1011), -14.0);
    // Just below the smallest normal number: three bits decide, before the range does.
    assert_eq!(float::from_f64(small, 0.25 - 0.25 / 32.0), 0b00_0100);
    assert_eq!(float::from_f64(small, 0.25 - 0.25 / 8.0), 0);
    assert_eq!(float::from_f64(small, -f64::from_bits(1)), small.sign_bit());
    assert_eq!(float::from_f64(small, 15.0), small.infinity());
    assert_eq!(float::from_f64(small, 14.99), 0b01_1011);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn from_f64_rounds_the_exact_value(x in proptest::num::f64::NORMAL | proptest::num::f64::SUBNORMAL, at in 0..FORMATS.len(), e in -90i32..90) {
        let fmt = FORMATS[at];
        for x in [x, f64::from_bits((x.to_bits() & !(0x7ff << 52)) | ((1023 + e) as u64) << 52)] {
            let expected = round_exact(fmt, &RBig::try_from(x).unwrap());
            prop_assert_eq!(float::from_f64(fmt, x), expected);
        }
    }

    /// The traversal rests on it: rounding never turns the order round.
    #[test]
    fn operations_are_monotone(a in 0u64..1 << 24, b in 0u64..1 << 24, c in 0u64..1 << 24) {
        let fmt = FloatFormat::FP24;
        let (a, b) = if float::lt(fmt, a, b) { (a, b) } else { (b, a) };
        // Equal ones, and NaNs, have no order to keep.
        if !float::lt(fmt, a, b) {
            return Ok(());
        }
        let not_less = |x, y| !float::lt(fmt, y, x);
        prop_assert!(not_less(float::add(fmt, a, c), float::add(fmt, b, c)));
        let positive = c & !fmt.sign_bit();
        prop_assert!(not_less(float::mul(fmt, a, positive), float::mul(fmt, b, positive)));
        prop_assert!(not_less(float::div(fmt, a, positive), float::div(fmt, b, positive)));
        prop_assert!(float::to_int(fmt, a, 24) <= float::to_int(fmt, b, 24));
        prop_assert!(float::to_fixed(fmt, a, 30, 12) <= float::to_fixed(fmt, b, 30, 12));
    }

    #[test]
    fn integers_are_monotone(a: i64, b: i64, frac in 0u32..60) {
        let fmt = FloatFormat::FP24;
        let (a, b) = (a.min(b), a.max(b));
        prop_assert!(!float::lt(fmt, float::from_fixed(fmt, b, frac), float::from_fixed(fmt, a, frac)));
    }
}
