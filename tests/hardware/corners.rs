//! Every unit at the corners of its parameters: the least, the next and the greatest value of each that `manifest.json` allows, crossed with
//! those of the others, against the golden model.
use crate::files::write;
use crate::simulators::skip;
use rayon::prelude::*;
use reliefrtl::bench::{Simulator, bench_files, run_bench};
use reliefrtl::catalogue::{check_interp, find, units, vector_set};
use reliefrtl::config::{Config, DatapathKind, Design, ExtraUnits, FetchConfig, ModeConfig, Profile, Trim};
use reliefrtl::emit;
use reliefrtl::format::{FloatFormat, Rounding, Specials, Subnormals};
use reliefrtl::ir::{Binding, Module, hold};
use reliefrtl::project::accepts;
use reliefrtl::units::{all, arithmetic, available};
use reliefrtl::vectors::{Plan, set_files};
use std::collections::BTreeSet;

/// No width of a unit is larger, nor a word in a row of vectors.
const WIDEST: i64 = 64;

/// Values of each parameter to cross: the ends of what is legal beside the others' defaults, and beside the others' least values.
fn ends(m: &Module) -> Vec<(String, Vec<i64>)> {
    let legal = |base: &Binding, name: &str| -> Vec<i64> {
        let at = |v: i64| base.iter().map(|(k, w)| (k.clone(), if k == name { v } else { *w })).collect::<Binding>();
        (0..=WIDEST).filter(|v| hold(&m.checks, &at(*v))).collect()
    };
    let defaults = m.default_binding();
    let few = |v: &[i64]| v.iter().copied().take(2).chain(v.iter().rev().copied().take(2)).collect::<Vec<_>>();
    let mut least = defaults.clone();
    for p in &m.params {
        if let Some(v) = legal(&least, &p.name).first() {
            least.insert(p.name.clone(), *v);
        }
    }
    let of = |name: &str| {
        let all: BTreeSet<i64> = [few(&legal(&defaults, name)), few(&legal(&least, name)), vec![defaults[name]]]
            .concat()
            .into_iter()
            .collect();
        all.into_iter().collect()
    };
    m.params.iter().map(|p| (p.name.clone(), of(&p.name))).collect()
}

/// At most `most` of the legal combinations, spread over all of them.
fn corners(m: &Module, most: usize) -> Vec<Binding> {
    let ends = ends(m);
    let all: usize = ends.iter().map(|e| e.1.len()).product();
    let pick = |mut k: usize| -> Binding {
        let of = |(name, v): &(String, Vec<i64>)| {
            let value = v[k % v.len()];
            k /= v.len();
            (name.clone(), value)
        };
        ends.iter().map(of).collect()
    };
    // A stride without a factor in common with the sizes visits them all evenly.
    let stride = (0..)
        .map(|k| all * 618 / 1000 + k)
        .find(|s| (1..=all).all(|p| p == 1 || s % p != 0 || !all.is_multiple_of(p)))
        .unwrap_or(1);
    (0..all)
        .map(|k| pick(k * stride.max(1) % all))
        .filter(|b| hold(&m.checks, b) && m.ports.iter().all(|p| p.width.eval(b) <= WIDEST))
        .take(most)
        .collect()
}

/// What is wrong with a unit at its corners, and rows that were compared.
fn check(d: &Design, m: &Module, most: usize, rows: usize) -> (Vec<String>, usize) {
    let list = corners(m, most);
    assert!(!list.is_empty(), "{} has no legal parameters", m.name);
    let one = |b: &Binding| -> Result<usize, String> {
        let run = || {
            let set = vector_set(d, m, b, Plan { rows, seed: 5 });
            let report = check_interp(m, &set).map_err(|e| e.to_string())?;
            report.verdict(&set, m).map_err(|e| e.to_string())?;
            Ok(report.checked)
        };
        let done = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run));
        done.unwrap_or_else(|_| Err("a panic".to_string())).map_err(|e| format!("{} at {b:?}: {e}", m.name))
    };
    let (good, bad): (Vec<_>, Vec<_>) =
        list.par_iter().map(one).collect::<Vec<_>>().into_iter().partition(Result::is_ok);
    (bad.into_iter().filter_map(Result::err).collect(), good.into_iter().flatten().sum())
}

/// A module whose own conditions hold is one in which those of all others hold.
#[test]
fn conditions_of_a_module_hold_for_all_that_stands_in_it() {
    let mut seen: BTreeSet<String> = BTreeSet::new();
    let (mut tried, mut wrong) = (0, Vec::new());
    let profiles = |d: Design| Profile::ALL.into_iter().map(move |p| Design { latency: p.latency_for(&d), ..d });
    for d in designs().into_iter().flat_map(profiles) {
        for m in all(&d).iter().chain(&available(&d)).chain(&arithmetic(&d)) {
            if seen.insert(format!("{} {}", m.name, m.variant())) {
                let list = corners(m, 40);
                tried += list.len();
                wrong.extend(list.iter().filter_map(|b| accepts(m, b).err()).map(|e| e.to_string()));
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {tried}:\n{}", wrong.len(), wrong[..wrong.len().min(20)].join("\n"));
    println!("{} modules at {tried} corners", seen.len());
    assert!(seen.len() > 100 && tried > 2000, "{} modules at {tried} corners", seen.len());
}

fn designs() -> Vec<Design> {
    let base = Config::default().design();
    let of = |kind| Design { datapath: reliefrtl::config::DatapathConfig { kind, ..base.datapath }, ..base };
    let mode = |mode: ModeConfig| Design { mode, ..base };
    vec![
        Design { extra: ExtraUnits::ALL, ..base },
        of(DatapathKind::Fixed),
        of(DatapathKind::Published),
        mode(ModeConfig { trim: Trim::Always, lod: true, ..base.mode }),
        mode(ModeConfig { bilinear: true, ..base.mode }),
        Design { fetch: FetchConfig::BLOCK, ..base },
        Design { fetch: FetchConfig::BLOCK, ..of(DatapathKind::Fixed) },
    ]
}

#[test]
fn every_unit_is_right_at_the_corners_of_its_parameters() {
    let mut seen: BTreeSet<String> = BTreeSet::new();
    let (mut rows, mut wrong) = (0, Vec::new());
    for d in designs() {
        for m in units(&d) {
            // A unit of the same text was checked already.
            let text = format!("{} {:?} {:?}", m.name, m.params, m.nodes.len());
            if seen.insert(text) {
                let (bad, good) = check(&d, &m, 20, 100);
                wrong.extend(bad);
                rows += good;
            }
        }
    }
    assert!(wrong.is_empty(), "{} of them:\n{}", wrong.len(), wrong[..wrong.len().min(200)].join("\n"));
    println!("{} units, {rows} rows", seen.len());
    assert!(seen.len() > 45 && rows > 100_000, "{} {rows}", seen.len());
}

/// All choices of a format at its smallest exponents: here a zero, a subnormal number and the end of a range lie side by side.
#[test]
fn conversions_are_right_at_the_smallest_exponents() {
    let mut rows = 0;
    for subnormals in Subnormals::ALL {
        for specials in Specials::ALL {
            for rounding in Rounding::ALL {
                let format = FloatFormat {
                    rounding: *rounding,
                    subnormals: *subnormals,
                    specials: *specials,
                    ..FloatFormat::new(4, 3)
                };
                let d = Design { format, ..Config::default().design() };
                for name in ["fp_to_fixed", "fp_to_int", "fp_from_fixed", "fp_from_int"] {
                    let m = find(&d, name).unwrap();
                    for (exp, man) in [(2, 2), (2, 3), (2, 7), (3, 2), (4, 4)] {
                        for int in [2, 3, 4, 5, 9] {
                            let fixed = name.ends_with("fixed");
                            for frac in if fixed { (0..=int).collect::<Vec<i64>>() } else { vec![0] } {
                                let mut b: Binding = [("EXP_W", exp), ("MAN_W", man), ("INT_W", int)]
                                    .map(|(k, v)| (k.to_string(), v))
                                    .into();
                                if fixed {
                                    b.insert("FRAC_W".into(), frac);
                                }
                                let set = vector_set(&d, &m, &b, Plan { rows: 100, seed: 2 });
                                let r = check_interp(&m, &set).unwrap();
                                r.verdict(&set, &m).unwrap_or_else(|e| panic!("{e} (at {b:?}, {format})"));
                                rows += r.checked;
                            }
                        }
                    }
                }
            }
        }
    }
    println!("{rows} rows");
    assert!(rows > 500_000, "{rows}");
}

/// Floats of 33 bits, one more than the interpreter's narrow words: the sign of a magnitude is a zero that was put on top of 32 bits.
#[test]
fn floats_of_33_bits_are_right_in_the_interpreter() {
    let base = Config::default().design();
    let d = Design { mode: ModeConfig { bilinear: true, ..base.mode }, ..base };
    let m = find(&d, "bilinear_window").unwrap();
    let b: Binding = [("EXP_W", 5), ("MAN_W", 27), ("HEIGHT_W", 7)].map(|(k, v)| (k.to_string(), v)).into();
    let set = vector_set(&d, &m, &b, Plan { rows: 1000, seed: 1 });
    check_interp(&m, &set).unwrap().verdict(&set, &m).unwrap();
}

/// The emitted text of some, given the values by a simulator.
#[test]
fn corners_are_right_in_icarus() {
    if skip() {
        return;
    }
    let mut c = Config::default();
    c.emit.prefix = String::new();
    c.format.subnormals = Subnormals::Gradual;
    let d = c.design();
    let cases: &[(&str, &[(&str, i64)])] = &[
        ("fp_to_fixed", &[("EXP_W", 2), ("MAN_W", 5), ("INT_W", 6), ("FRAC_W", 6)]),
        ("fp_to_fixed", &[("EXP_W", 2), ("MAN_W", 5), ("INT_W", 6), ("FRAC_W", 5)]),
        ("fp_to_fixed", &[("EXP_W", 2), ("MAN_W", 2), ("INT_W", 2), ("FRAC_W", 0)]),
        ("fp_from_fixed", &[("EXP_W", 2), ("MAN_W", 2), ("INT_W", 9), ("FRAC_W", 9)]),
        ("fp_to_int", &[("EXP_W", 11), ("MAN_W", 28), ("INT_W", 33)]),
        ("fp_from_int", &[("EXP_W", 11), ("MAN_W", 28), ("INT_W", 33)]),
        ("lzc", &[("W", 1)]),
        ("lzc", &[("W", 64)]),
        ("interleave", &[("W", 1)]),
    ];
    for (name, values) in cases {
        let m = find(&d, name).unwrap();
        let over: Binding = values.iter().map(|(k, v)| (k.to_string(), *v)).collect();
        accepts(&m, &over).unwrap();
        let dir = tempfile::tempdir().unwrap();
        let mut files = emit::rtl(&c, &emit::modules(std::slice::from_ref(&m)).unwrap());
        files.extend(bench_files(std::slice::from_ref(&m), None, ""));
        let set = vector_set(&d, &m, &over, Plan { rows: 300, seed: 4 });
        files.extend(set_files(&set).into_iter().map(|(n, t)| (format!("golden/{name}/{n}"), t)));
        write(dir.path(), &files);
        let o =
            run_bench(Simulator::Icarus, dir.path(), name, &over, &[]).unwrap_or_else(|e| panic!("{e} (at {over:?})"));
        assert_eq!(o.checked, set.expected.len());
    }
}
