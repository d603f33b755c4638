//! A sample of mutants as Verilog: what the interpreter says of one, Verilator says too.
//! `RELIEFRTL_MUTANTS` sets how many of a unit (default 1). A missing simulator fails unless RELIEFRTL_NO_SIMULATORS=1.
use crate::files::write;
use crate::float_units::FLOAT_UNITS;
use crate::simulators::skip;
use rayon::prelude::*;
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{campaign_set, check_interp};
use reliefrtl::config::Config;
use reliefrtl::error::Error;
use reliefrtl::ir::{Binding, Module, Op};
use reliefrtl::project::{alone, alone_text};
use reliefrtl::vectors::{Campaign, Level, Plan, Shard, set_files};
use std::sync::Arc;

/// What a slip could put in the place of an operation of the description, at the same widths.
fn neighbour(op: &Op) -> Option<Op> {
    match op {
        Op::And => Some(Op::Or),
        Op::Or => Some(Op::And),
        Op::Xor => Some(Op::Or),
        Op::Add => Some(Op::Sub),
        Op::Sub => Some(Op::Add),
        Op::RedOr => Some(Op::RedAnd),
        Op::RedAnd => Some(Op::RedOr),
        Op::Ult => Some(Op::Eq),
        Op::Eq => Some(Op::Ult),
        Op::Shl => Some(Op::Shr),
        Op::Shr => Some(Op::Shl),
        _ => None,
    }
}

/// `count` mutants of a unit, spread over its description, each with the name of what was changed.
fn mutants(m: &Arc<Module>, count: usize) -> Vec<(String, Arc<Module>)> {
    let places: Vec<(usize, Op)> =
        m.nodes.iter().enumerate().filter_map(|(k, n)| neighbour(&n.op).map(|op| (k, op))).collect();
    let spread = (0..count).map(|k| &places[(2 * k + 1) * places.len() / (2 * count)]);
    let change = |(k, op): &(usize, Op)| {
        let mut other = Module::clone(m);
        let was = std::mem::replace(&mut other.nodes[*k].op, op.clone());
        (format!("{}, node {k}: {} -> {}", m.name, was.name(), op.name()), Arc::new(other))
    };
    spread.map(change).collect()
}

/// Rows that differ as a bench in Verilator counts them, and how many it compared.
fn verilator(c: &Config, unit: &str, m: &Arc<Module>, files: &[(String, String)]) -> (usize, usize) {
    let tree = tempfile::tempdir().unwrap();
    write(tree.path(), alone_text(c, std::slice::from_ref(m)).unwrap().into_iter().chain(files.iter().cloned()));
    match run_bench(Simulator::Verilator, tree.path(), unit, &Binding::new(), &[]) {
        Ok(o) => (0, o.checked),
        Err(Error::Mismatch(found)) => {
            // "FAIL unit: N of M ..."
            let text = found.to_string();
            let words: Vec<&str> = text.split(' ').collect();
            let of = words.iter().position(|w| *w == "of").unwrap_or_else(|| panic!("{text}"));
            let number = |w: &str| w.trim_end_matches(',').parse().unwrap_or_else(|_| panic!("{text}"));
            (number(words[of - 1]), number(words[of + 1]))
        }
        Err(e) => panic!("{unit}: {e}"),
    }
}

#[test]
fn verilator_judges_mutants_as_the_interpreter_does() {
    if skip() {
        return;
    }
    let count = std::env::var("RELIEFRTL_MUTANTS").map_or(1, |v| v.parse().expect("a number of mutants"));
    let c = Config::default();
    let all: Vec<_> = FLOAT_UNITS.iter().flat_map(|u| mutants(&alone(&c, u).unwrap(), count)).collect();
    let judge = |(what, m): &(String, Arc<Module>)| {
        let original = alone(&c, &m.name).unwrap();
        let campaign = Campaign { level: Level::One, shard: Shard::WHOLE };
        let set = campaign_set(&c.design(), &original, &Binding::new(), Plan { rows: 500, seed: 1 }, campaign);
        let files = set_files(&set).into_iter().map(|(name, text)| (format!("golden/{}/{name}", m.name), text));
        let (wrong, of) = verilator(&c, &m.name, m, &files.collect::<Vec<_>>());
        let report = check_interp(m, &set).unwrap();
        println!("{what}: {wrong} of {of} in Verilator, {} in the interpreter", report.mismatched);
        assert_eq!((wrong, of), (report.mismatched, set.stimulus.len()), "{what}");
        wrong > 0
    };
    let killed = all.par_iter().map(judge).filter(|k| *k).count();
    println!("{killed} of {} mutants killed, alike in both", all.len());
    assert!(killed * 2 > all.len());
}
