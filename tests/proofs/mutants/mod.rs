//! Mutants of the datapath: one operation of a unit is replaced by its neighbour, and the committed vectors have to notice.
//! What survives is listed by name with `cargo test --test proofs mutants -- --nocapture`; of arithmetic, with a proof that it computes the same.
mod aig;
mod blast;
mod control;
pub mod equal;
mod legal;
mod parts;
mod simulated;
mod survivors;

use crate::budget::share;
use crate::float_units::FLOAT_UNITS;
use equal::{Verdict, compare};
use rayon::prelude::*;
use reliefrtl::catalogue::{campaign_set, check_netlist, find};
use reliefrtl::config::Design;
use reliefrtl::interp::{FlatOp, Kind, Netlist, elaborate};
use reliefrtl::ir::Binding;
use reliefrtl::vectors::{Campaign, Level, Plan, Shard, VectorSet};

/// Operations that a slip could put in the place of `op`; each has operands and result of the same widths.
fn neighbours(op: &FlatOp) -> Vec<(&'static str, FlatOp)> {
    let [a, b, c] = op.args;
    let kind = |kind| FlatOp { kind, ..*op };
    let args = |args| FlatOp { args, ..*op };
    match op.kind {
        Kind::And => vec![("or", kind(Kind::Or)), ("left", args([a, a, c]))],
        Kind::Or => vec![("and", kind(Kind::And)), ("left", args([a, a, c])), ("xor", kind(Kind::Xor))],
        Kind::Xor => vec![("or", kind(Kind::Or))],
        Kind::Add => vec![("sub", kind(Kind::Sub)), ("or", kind(Kind::Or))],
        Kind::Sub => vec![("add", kind(Kind::Add)), ("swapped", args([b, a, c]))],
        Kind::Mux => vec![("swapped", args([a, c, b])), ("always", args([a, b, b])), ("never", args([a, c, c]))],
        Kind::Ult => vec![("swapped", args([b, a, c])), ("signed", kind(Kind::Slt))],
        Kind::Slt => vec![("swapped", args([b, a, c])), ("unsigned", kind(Kind::Ult))],
        Kind::Eq => vec![("less", kind(Kind::Ult))],
        Kind::RedOr => vec![("all", kind(Kind::RedAnd))],
        Kind::RedAnd => vec![("any", kind(Kind::RedOr))],
        Kind::Shl => vec![("right", kind(Kind::Shr))],
        Kind::Shr => vec![("left", kind(Kind::Shl)), ("signed", kind(Kind::Sar))],
        Kind::Sar => vec![("logical", kind(Kind::Shr))],
        Kind::Slice if op.aux > 0 => vec![("a bit lower", FlatOp { aux: op.aux - 1, ..*op })],
        Kind::Sext => vec![("unsigned", FlatOp { kind: Kind::Slice, aux: 0, ..*op })],
        _ => vec![],
    }
}

/// A name to find the operation by: its own, or that of the first value it feeds.
fn name(net: &Netlist, op: usize) -> String {
    let slot = net.first_op + op as u32;
    let own = |s: u32| net.names.iter().find(|(_, n)| **n == s).map(|(n, _)| n.clone());
    let reader = || {
        let later = net.ops.iter().enumerate().skip(op + 1).filter(|(_, o)| o.args.contains(&slot));
        later.map(|(k, _)| net.first_op + k as u32).find_map(own).map(|n| format!("into {n}"))
    };
    own(slot).or_else(reader).unwrap_or_else(|| format!("operation {op}"))
}

/// A mutant that some rows did not notice.
struct Survivor {
    /// Which operation was changed into what.
    name: String,
    op: usize,
    what: &'static str,
    net: Netlist,
}

/// Number of mutants of one unit, and those that live.
fn mutate(net: &Netlist, latency: usize, set: &VectorSet) -> (usize, Vec<Survivor>) {
    one_in(1, net, latency, set)
}

/// The same of one mutant in so many.
fn one_in(step: usize, net: &Netlist, latency: usize, set: &VectorSet) -> (usize, Vec<Survivor>) {
    let all: Vec<(usize, &'static str, FlatOp)> = net
        .ops
        .iter()
        .enumerate()
        .flat_map(|(i, op)| neighbours(op).into_iter().map(move |(w, o)| (i, w, o)))
        .step_by(step)
        .collect();
    let lives = |(i, what, op): &(usize, &'static str, FlatOp)| {
        let mut other = net.clone();
        other.ops[*i] = *op;
        let name = || format!("{i} {} {:?} -> {what}", name(net, *i), net.ops[*i].kind);
        let report = check_netlist(&other, latency, set).unwrap();
        (report.mismatched == 0).then(|| Survivor { name: name(), op: *i, what, net: other })
    };
    (all.len(), all.par_iter().filter_map(lives).collect())
}

/// Mutants of a unit of arithmetic.
struct Judged {
    unit: &'static str,
    mutants: usize,
    /// Those that the rows did not notice, by name, and whether any input would.
    survivors: Vec<(String, Verdict)>,
}

impl Judged {
    fn same(&self) -> usize {
        self.survivors.iter().filter(|s| s.1 == Verdict::Same).count()
    }

    fn open(&self) -> usize {
        self.survivors.iter().filter(|s| s.1 == Verdict::Open).count()
    }
}

/// Mutants of the arithmetic on the table of corners of a level and random rows; what survives is compared with the original for every input.
fn judged(level: Level, rows: usize, seconds: u32, step: usize) -> Vec<Judged> {
    let d = Design::default();
    let campaign = Campaign { level, shard: Shard::WHOLE };
    let one = |unit: &&'static str| {
        let m = find(&d, unit).unwrap();
        let set = campaign_set(&d, &m, &Binding::new(), Plan { rows, seed: 1 }, campaign);
        let net = elaborate(&m, &Binding::new()).unwrap();
        let (mutants, survivors) = one_in(step, &net, m.latency().unwrap() as usize, &set);
        let verdict = |s: &Survivor| (s.name.clone(), compare(&net, &s.net, seconds));
        let survivors: Vec<_> = survivors.par_iter().map(verdict).collect();
        let j = Judged { unit, mutants, survivors };
        println!(
            "{unit:<14} {} rows: {} of {mutants} killed, {} the same for every input, {} not noticed, {} open",
            set.stimulus.len(),
            mutants - j.survivors.len(),
            j.same(),
            j.survivors.len() - j.same() - j.open(),
            j.open()
        );
        j.survivors.iter().for_each(|(name, v)| println!("    {v:?}: {name}"));
        j
    };
    FLOAT_UNITS.iter().map(one).collect()
}

#[test]
fn crossed_corners_kill_the_mutants_of_arithmetic() {
    let all = judged(Level::One, 2000, 60, share(4));
    let total = |f: &dyn Fn(&Judged) -> usize| all.iter().map(f).sum::<usize>();
    let others = total(&|j| j.mutants - j.same());
    let killed = total(&|j| j.mutants - j.survivors.len());
    println!("{killed} of {others} mutants that are not the original killed");
    assert!(others > 1000 / share(4), "only {others} mutants");
    assert!(killed * 100 >= others * 99, "{killed} of {others} killed");
    if share(4) > 1 {
        return;
    }
    // All of them: the page has these numbers.
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/arithmetic.md")).unwrap();
    for j in &all {
        let (others, killed) = (j.mutants - j.same(), j.mutants - j.survivors.len());
        let row = format!("| `{}` | {} | {} | {killed} of {others} |", j.unit, j.mutants, j.same());
        assert!(page.contains(&row), "docs/arithmetic.md has no {row}");
    }
}

/// The large tables leave no mutant of the arithmetic alive that is not the original.
#[test]
#[ignore = "minutes; part of the full budget"]
fn large_tables_kill_all_mutants_of_arithmetic() {
    let all = judged(Level::Two, 100_000, 600, 1);
    let alive: Vec<_> = all.iter().flat_map(|j| j.survivors.iter().map(move |s| (j.unit, s))).collect();
    let alive: Vec<_> = alive.into_iter().filter(|(_, s)| s.1 != Verdict::Same).collect();
    assert!(alive.is_empty(), "{alive:?}");
}
