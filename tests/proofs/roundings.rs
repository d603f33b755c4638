//! The fast paths of the default choices round as the general rounding does: proved for every operand, at full width, by ABC's equivalence check.
//!
//! Rounding to nearest even, flushed subnormals and IEEE specials have code of their own in `fp_add` (two paths), in `fp_mul` and `fp_div` (candidates
//! side by side) and in `fp_from_fixed`; every other choice goes through `units::float::general`, and so can this one.
use super::mutants::equal::{Verdict, compare};
use reliefrtl::format::FloatFormat;
use reliefrtl::interp::{Netlist, elaborate};
use reliefrtl::ir::{Binding, Module};
use reliefrtl::units::float::{self, general};
use std::sync::Arc;

/// Seconds for one proof.
const SECONDS: u32 = 300;

fn net(m: &Arc<Module>) -> Netlist {
    elaborate(m, &Binding::new()).unwrap()
}

fn same(what: &str, f: FloatFormat, fast: &Arc<Module>, general: &Arc<Module>) {
    let start = std::time::Instant::now();
    let verdict = compare(&net(fast), &net(general), SECONDS);
    println!("{what} of {} exponent and {} fraction bits: {verdict:?} ({:.1?})", f.exp, f.man, start.elapsed());
    assert_eq!(verdict, Verdict::Same, "{what}, {f:?}");
}

/// The default format, single precision, and small ones whose corners lie side by side.
fn formats() -> Vec<FloatFormat> {
    let plain = reliefrtl::config::Design::default().format;
    [(7, 16), (8, 23), (5, 10), (3, 2), (2, 2)].map(|(exp, man)| FloatFormat { exp, man, ..plain }).to_vec()
}

#[test]
fn sums_round_as_in_general() {
    for f in formats() {
        same("fp_add", f, &float::fp_add(f, 3), &general::fp_add(f, 3));
    }
}

#[test]
fn products_round_as_in_general() {
    for f in formats() {
        same("fp_mul", f, &float::fp_mul(f, 2), &general::fp_mul(f, 2));
    }
}

#[test]
fn quotients_round_as_in_general() {
    for f in formats() {
        let latency = reliefrtl::config::LatencyConfig { div: 4, ..Default::default() };
        same("fp_div", f, &float::fp_div(f, &latency), &general::fp_div(f, 4));
    }
}

#[test]
fn conversions_round_as_in_general() {
    for f in formats() {
        let int = 64 - f.man - 3;
        for (int, frac) in [(int, 0), (int, int / 2), (12, 4)] {
            let fast = float::fp_from_fixed(f, int, frac, 2);
            same("fp_from_fixed", f, &fast, &general::fp_from_fixed(f, int, frac, 2));
        }
    }
}

/// And what is spoiled is not the same.
#[test]
fn another_rounding_is_not_the_same() {
    let f = formats()[0];
    let down = FloatFormat { rounding: reliefrtl::format::Rounding::Down, ..f };
    let verdict = compare(&net(&float::fp_mul(f, 2)), &net(&general::fp_mul(down, 2)), SECONDS);
    assert!(matches!(verdict, Verdict::Different(_)), "{verdict:?}");
}
