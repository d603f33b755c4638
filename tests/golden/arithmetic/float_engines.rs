//! The emitted Verilog of arithmetic alone in Icarus and Verilator: the units that no traversal needs, at their defaults and at other
//! parameter values, and every unit at every choice of rounding, subnormals and specials.
//! `RELIEFRTL_LEVEL=2` crosses the large tables of corners of every unit at five formats (default: the small ones at 7/16, in Verilator of the
//! units that no traversal needs).
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use crate::budget::share;
use crate::files::write;
use crate::float_units::FLOAT_UNITS;
use crate::simulators::skip;
use rayon::prelude::*;
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{campaign_set, vector_set};
use reliefrtl::config::{Config, ExtraUnit};
use reliefrtl::format::{Rounding, Specials, Subnormals};
use reliefrtl::ir::Binding;
use reliefrtl::project::{alone, alone_files};
use reliefrtl::vectors::{Campaign, Level, Plan, Shard, set_files};

fn at(exp: i64, man: i64) -> Binding {
    Binding::from([("EXP_W".into(), exp), ("MAN_W".into(), man)])
}

fn config(sets: &[String]) -> Config {
    let mut c = Config::default();
    // The rows that are replayed are made below.
    c.vectors.arithmetic = 1;
    sets.iter().for_each(|s| c.apply_set(s).unwrap());
    c
}

/// Which vectors are replayed.
#[derive(Clone, Copy)]
enum Rows {
    /// So many of the usual choice.
    Chosen(usize),
    /// Crossed tables of corners, and 2000 random rows.
    Crossed(Level),
}

/// Emits `unit` with `c`, and replays vectors at parameter values `over` in the emitted text; returns the rows compared.
fn replay(sim: Simulator, c: &Config, unit: &str, over: &Binding, rows: Rows) -> usize {
    let m = alone(c, unit).expect("the unit stands alone");
    let set = match rows {
        Rows::Chosen(rows) => vector_set(&c.design(), &m, over, Plan { rows, seed: 5 }),
        Rows::Crossed(level) => {
            let campaign = Campaign { level, shard: Shard::WHOLE };
            campaign_set(&c.design(), &m, over, Plan { rows: 2000, seed: 5 }, campaign)
        }
    };
    let mut files = alone_files(c, std::slice::from_ref(&m), None).unwrap();
    files.extend(set_files(&set).into_iter().map(|(n, t)| (format!("here/{n}"), t)));
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), &files);
    let vectors = [format!("vectors={}", dir.path().join("here").display())];
    let done = run_bench(sim, dir.path(), unit, &set.params, &vectors)
        .unwrap_or_else(|e| panic!("{}, {unit} at {over:?}: {e}", c.format.float()));
    assert_eq!(done.checked, set.stimulus.len());
    done.checked
}

/// The units of floating-point numbers that no traversal needs.
fn floats() -> Vec<&'static str> {
    ExtraUnit::WORDS.iter().copied().filter(|u| u.starts_with("fp_")).collect()
}

/// The units that no traversal needs at their defaults and re-parameterized from outside: the emitted text stays. Their rows divide by fewer
/// registers than a small format has bits.
fn extra(sim: Simulator, formats: &[Binding], rows: usize) {
    let few = ["latency.div=2".to_string(), "latency.sqrt=2".to_string()];
    let cases: Vec<(&str, &Binding)> = floats().iter().flat_map(|u| formats.iter().map(move |b| (*u, b))).collect();
    let checked: usize = cases.par_iter().map(|(u, b)| replay(sim, &config(&few), u, b, Rows::Chosen(rows))).sum();
    println!("{}: {} units at {} formats, 0 of {checked} mismatched", sim.name(), floats().len(), formats.len());
    assert!(checked >= cases.len() * rows.min(256));
}

#[test]
fn extra_units_in_icarus() {
    if !skip() {
        extra(Simulator::Icarus, &[Binding::new(), at(5, 10), at(8, 23), at(4, 3), at(3, 5), at(11, 27)], 600);
    }
}

#[test]
fn extra_units_in_verilator() {
    if !skip() {
        extra(Simulator::Verilator, &[Binding::new(), at(5, 10)], 2000);
    }
}

/// The default choices on crossed corners.
fn crossed(sim: Simulator, units: &[&str]) {
    let all = std::env::var("RELIEFRTL_LEVEL").is_ok_and(|v| v == "2");
    let (units, formats, level) = match all {
        true => (&FLOAT_UNITS[..], vec![(7, 16), (5, 10), (8, 23), (6, 9), (4, 12)], Level::Two),
        false => (units, vec![(7, 16)], Level::One),
    };
    let cases: Vec<(&str, (u32, u32))> = formats.iter().flat_map(|f| units.iter().map(move |u| (*u, *f))).collect();
    let one = |(u, (exp, man)): &(&str, (u32, u32))| {
        let c = config(&[format!("format.exp={exp}"), format!("format.man={man}")]);
        replay(sim, &c, u, &Binding::new(), Rows::Crossed(level))
    };
    let checked: usize = cases.par_iter().map(one).sum();
    println!(
        "{}: {} units and formats, corners of level {level:?}, 0 of {checked} mismatched",
        sim.name(),
        cases.len()
    );
    assert!(checked > 2000 * cases.len(), "{checked}");
}

#[test]
fn crossed_corners_in_icarus() {
    if !skip() {
        crossed(Simulator::Icarus, &FLOAT_UNITS);
    }
}

#[test]
fn crossed_corners_in_verilator() {
    if !skip() {
        crossed(Simulator::Verilator, &floats());
    }
}

/// Every choice, with a format and a latency of each.
fn choices() -> Vec<Vec<String>> {
    let mut out = Vec::new();
    for rounding in Rounding::WORDS {
        for subnormals in Subnormals::WORDS {
            for specials in Specials::WORDS {
                let k = out.len();
                let (exp, man) = [(7, 16), (5, 10), (4, 3), (8, 23), (3, 2)][k % 5];
                let clocks = [2, 5, 0, 1, 9, 3][k % 6];
                let mut sets = vec![
                    format!("format.rounding={rounding}"),
                    format!("format.subnormals={subnormals}"),
                    format!("format.specials={specials}"),
                    format!("format.exp={exp}"),
                    format!("format.man={man}"),
                ];
                let kinds = ["add", "mul", "div", "compare", "from_int", "to_int", "sqrt", "add3"];
                sets.extend(kinds.map(|u| format!("latency.{u}={clocks}")));
                out.push(sets);
            }
        }
    }
    out
}

#[test]
fn every_choice_in_icarus() {
    if skip() {
        return;
    }
    let choices = choices();
    let cases: Vec<(&Vec<String>, &str)> =
        choices.iter().flat_map(|c| FLOAT_UNITS.iter().map(move |u| (c, *u))).collect();
    // 7 does not divide the number of units: each choice meets one or two of them, and each unit two choices or more.
    let cases: Vec<_> = cases.into_iter().step_by(share(7)).collect();
    let checked: usize = cases
        .par_iter()
        .map(|(sets, u)| replay(Simulator::Icarus, &config(sets), u, &Binding::new(), Rows::Chosen(300)))
        .sum();
    println!("icarus: {} pairs of a unit and a choice, 0 of {checked} mismatched", cases.len());
    assert!(checked > 250 * cases.len(), "{checked}");
}

/// Each unit once, so that together they have every rounding, with subnormals and without, with specials and without.
#[test]
fn a_sample_of_choices_in_verilator() {
    if skip() {
        return;
    }
    let choices = choices();
    let cases: Vec<(&Vec<String>, &str)> =
        FLOAT_UNITS.iter().enumerate().map(|(k, u)| (&choices[(7 * k + 2) % 20], *u)).collect();
    for word in Rounding::WORDS.iter().chain(Subnormals::WORDS).chain(Specials::WORDS) {
        assert!(cases.iter().any(|(sets, _)| sets.iter().any(|s| s.ends_with(&format!("={word}")))), "{word}");
    }
    let checked: usize = cases
        .par_iter()
        .map(|(sets, u)| replay(Simulator::Verilator, &config(sets), u, &Binding::new(), Rows::Chosen(2000)))
        .sum();
    println!("verilator: {} units, 0 of {checked} mismatched", FLOAT_UNITS.len());
    assert!(checked > 64 * FLOAT_UNITS.len(), "{checked}");
}
