//! The floating-point units in the interpreter against the golden model, at every choice of rounding, subnormals and specials:
//! small formats with every operand, others with corners and weighted random rows. In the usual run one in five of unit and choice at each format; 5
//! divides no number of them, so that each choice meets two units or more, and each unit four choices.
//!
//! `RELIEFRTL_ROWS` sets the rows of a unit at 7/16 and the formats around it (default 600).
use crate::budget::share;
use crate::float_units::FLOAT_UNITS;
use rayon::prelude::*;
use reliefrtl::catalogue::{Context, Modelled, check_interp, find, vector_set};
use reliefrtl::config::{Design, LatencyConfig};
use reliefrtl::format::{FloatFormat, Rounding, Specials, Subnormals};
use reliefrtl::ir::Binding;
use reliefrtl::vectors::{Counts, Plan};

fn choices(exp: u32, man: u32) -> Vec<FloatFormat> {
    let mut all = Vec::new();
    for &rounding in Rounding::ALL {
        for &subnormals in Subnormals::ALL {
            all.extend(Specials::ALL.iter().map(|&specials| FloatFormat { exp, man, rounding, subnormals, specials }));
        }
    }
    all
}

fn design(format: FloatFormat, l: u32) -> Design {
    let latency = LatencyConfig {
        add: l,
        mul: l,
        div: l,
        compare: l,
        from_int: l,
        to_int: l,
        sqrt: l,
        add3: l,
        ..LatencyConfig::default()
    };
    Design { format, latency, ..Design::default() }
}

fn at(exp: u32, man: u32) -> Binding {
    Binding::from([("EXP_W".into(), exp.into()), ("MAN_W".into(), man.into())])
}

/// Rows checked of a unit at a format, and whether these were all there are.
fn check(name: &str, format: FloatFormat, l: u32, rows: usize) -> (usize, bool) {
    let d = design(format, l);
    let m = find(&d, name).unwrap();
    let b = at(format.exp, format.man);
    let set = vector_set(&d, &m, &b, Plan { rows, seed: 3 });
    let report = check_interp(&m, &set).unwrap_or_else(|e| panic!("{format}, {l} clocks: {name}: {e}"));
    report.verdict(&set, &m).unwrap_or_else(|e| panic!("{format}, {l} clocks: {e}"));
    (report.checked, set.counts.exhaustive > 0)
}

#[test]
fn every_operand_of_small_formats() {
    let latencies = [0, 1, 2, 3, 5, 8, 13, 20, 32];
    let mut all = Vec::new();
    for (exp, man) in [(4, 3), (3, 2)] {
        for (k, format) in choices(exp, man).into_iter().enumerate() {
            all.extend(FLOAT_UNITS.iter().enumerate().map(|(u, name)| (*name, format, latencies[(k + u) % 9])));
        }
    }
    let all: Vec<_> = all.into_iter().step_by(share(5)).collect();
    let done: Vec<_> = all.par_iter().map(|(name, format, l)| check(name, *format, *l, 1500)).collect();
    let total: usize = done.iter().map(|x| x.0).sum();
    let whole = done.iter().filter(|x| x.1).count();
    println!("4/3 and 3/2: 0 of {total} mismatched, {whole} of {} unit and choice with every operand", done.len());
    // Of conversions and of sums of three, operands have more than 16 bits.
    assert!(whole * share(5) >= 2 * 20 * 7 && total * share(5) > 20 * 4 * 60_000);
}

/// Every three operands at 3/2: 2^18 rows a choice.
#[test]
fn every_sum_of_three() {
    let rows = |f: FloatFormat| {
        let d = design(f, 4);
        let m = find(&d, "fp_add3").unwrap();
        let mut set = vector_set(&d, &m, &at(3, 2), Plan { rows: 1, seed: 1 });
        set.stimulus = (0..1u64 << 18).map(|k| vec![k & 63, k >> 6 & 63, k >> 12]).collect();
        let (unit, c) = (Modelled::of(&d, &m), Context::new(d, &set.params));
        set.expected = set.stimulus.iter().map(|r| unit.results(&c, r)).collect();
        set.counts = Counts { exhaustive: set.stimulus.len(), ..Counts::default() };
        let report = check_interp(&m, &set).unwrap();
        report.verdict(&set, &m).unwrap_or_else(|e| panic!("{f}: {e}"));
        report.checked
    };
    let total: usize = choices(3, 2).into_par_iter().map(rows).sum();
    println!("fp_add3 at 3/2: 0 of {total} mismatched");
    assert_eq!(total, 20 << 18);
}

#[test]
fn larger_formats() {
    let rows = std::env::var("RELIEFRTL_ROWS").map_or(300, |v| v.parse().expect("a number of rows"));
    let mut all = Vec::new();
    for (k, (exp, man)) in [(7, 16), (5, 10), (8, 23), (2, 6), (11, 27)].into_iter().enumerate() {
        for (c, format) in choices(exp, man).into_iter().enumerate() {
            let names = FLOAT_UNITS.iter().enumerate();
            all.extend(names.map(|(u, name)| (*name, format, [2, 4, 7, 1, 12, 26][(k + c + u) % 6])));
        }
    }
    let all: Vec<_> = all.into_iter().step_by(share(5)).collect();
    let total: usize = all.par_iter().map(|(name, format, l)| check(name, *format, *l, rows).0).sum();
    println!("7/16, 5/10, 8/23, 2/6, 11/27: 0 of {total} mismatched (seed 3)");
    assert!(total * share(5) > 5 * 20 * 12 * 200);
}
