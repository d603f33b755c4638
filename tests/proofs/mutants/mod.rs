//! Mutants of the datapath: one operation of a unit is replaced by its neighbour, and the committed vectors have to notice.
//! What survives is listed by name with `cargo test --test proofs mutants -- --nocapture`; of arithmetic, with a proof that it computes the same.
mod aig;
mod blast;
mod control;
pub mod equal;
mod simulated;

use equal::{Verdict, compare};
use rayon::prelude::*;
use reliefrtl::catalogue::{campaign_set, check_netlist, find, units, vector_set};
use reliefrtl::config::Design;
use reliefrtl::interp::{FlatOp, Kind, Netlist, elaborate};
use reliefrtl::ir::{Binding, Module};
use reliefrtl::vectors::{Campaign, Level, Plan, Shard, VectorSet, read_set};
use std::path::PathBuf;

/// How many mutants of a unit the committed vectors let live, at most. Many of these compute the same as the original (`fp_from_int` is
/// tried with every input and still has some); a number that grows means that vectors got weaker or that a unit has new logic.
const LIVE: &[(&str, usize)] = &[
    ("fp_add", 13),
    ("fp_mul", 14),
    ("fp_div", 23),
    ("fp_lt", 6),
    ("fp_from_int", 23),
    ("fp_to_int", 3),
    ("fp_from_fixed", 12),
    ("fp_to_fixed", 3),
    ("start_level", 0),
    ("height_address", 2),
    ("node_planes", 1),
    ("plane_time", 76),
    ("height_test", 41),
    ("predicted_hit", 68),
    ("node_crossing", 17),
    ("multi_level_down", 2),
    ("level_up", 6),
    ("level_decision", 0),
    ("ray_setup", 628),
    ("hit_position", 61),
];

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

/// Number of mutants of one unit, and those that live, by name.
fn mutate(net: &Netlist, latency: usize, set: &VectorSet) -> (usize, Vec<(String, Netlist)>) {
    let all: Vec<(usize, &str, FlatOp)> = net
        .ops
        .iter()
        .enumerate()
        .flat_map(|(i, op)| neighbours(op).into_iter().map(move |(w, o)| (i, w, o)))
        .collect();
    let lives = |(i, what, op): &(usize, &str, FlatOp)| {
        let mut other = net.clone();
        other.ops[*i] = *op;
        let report = check_netlist(&other, latency, set).unwrap();
        (report.mismatched == 0).then(|| (format!("{} {:?} -> {what}", name(net, *i), net.ops[*i].kind), other))
    };
    (all.len(), all.par_iter().filter_map(lives).collect())
}

/// Mutates every unit with the vectors that `set` gives; returns the number of mutants and the survivors of each unit.
fn all_units(set: impl Fn(&Module) -> VectorSet) -> (usize, Vec<(String, usize)>) {
    let (mut total, mut lives) = (0, Vec::new());
    for m in units(&Design::default()) {
        let net = elaborate(&m, &Binding::new()).unwrap();
        let (n, survivors) = mutate(&net, m.latency.unwrap() as usize, &set(&m));
        let none = if n == 0 { " (no operation to change)" } else { "" };
        println!("{:<17} {} of {n} killed{none}", m.name, n - survivors.len());
        survivors.iter().for_each(|(s, _)| println!("    lives: {s}"));
        total += n;
        lives.push((m.name.clone(), survivors.len()));
    }
    let alive: usize = lives.iter().map(|l| l.1).sum();
    println!("{} of {total} killed, {alive} live", total - alive);
    (total, lives)
}

#[test]
fn committed_vectors_kill_the_mutants() {
    let golden = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("golden");
    let (total, lives) = all_units(|m| read_set(&golden.join(&m.name)).unwrap().0);
    assert!(total > 1000, "only {total} mutants");
    let allowed = |unit: &str| LIVE.iter().find(|l| l.0 == unit).map_or(0, |l| l.1);
    let more: Vec<String> = lives
        .iter()
        .filter(|(u, n)| *n > allowed(u))
        .map(|(u, n)| format!("{u}: {n} live, {} did before", allowed(u)))
        .collect();
    assert!(more.is_empty(), "{}", more.join("\n"));
}

/// Arithmetic, with a table of corners crossed.
const ARITHMETIC: [&str; 12] = [
    "fp_add",
    "fp_add3",
    "fp_mul",
    "fp_div",
    "fp_recip",
    "fp_sqrt",
    "fp_lt",
    "fp_compare",
    "fp_from_int",
    "fp_to_int",
    "fp_from_fixed",
    "fp_to_fixed",
];

/// Mutants of a unit of arithmetic.
struct Judged {
    unit: &'static str,
    mutants: usize,
    /// Those that the rows did not notice, by name, and whether any input would.
    survivors: Vec<(String, Verdict)>,
}

impl Judged {
    fn count(&self, what: Verdict) -> usize {
        self.survivors.iter().filter(|s| s.1 == what).count()
    }
}

/// Mutants of the arithmetic on the table of corners of a level and random rows; what survives is compared with the original for every input.
fn judged(level: Level, rows: usize, seconds: u32) -> Vec<Judged> {
    let d = Design::default();
    let campaign = Campaign { level, shard: Shard::WHOLE };
    let one = |unit: &&'static str| {
        let m = find(&d, unit).unwrap();
        let set = campaign_set(&d, &m, &Binding::new(), Plan { rows, seed: 1 }, campaign);
        let net = elaborate(&m, &Binding::new()).unwrap();
        let (mutants, survivors) = mutate(&net, m.latency.unwrap() as usize, &set);
        let verdict = |(name, other): &(String, Netlist)| (name.clone(), compare(&net, other, seconds));
        let survivors: Vec<_> = survivors.par_iter().map(verdict).collect();
        let j = Judged { unit, mutants, survivors };
        println!(
            "{unit:<14} {} rows: {} of {mutants} killed, {} the same for every input, {} not noticed, {} open",
            set.stimulus.len(),
            mutants - j.survivors.len(),
            j.count(Verdict::Same),
            j.count(Verdict::Different),
            j.count(Verdict::Open)
        );
        j.survivors.iter().for_each(|(name, v)| println!("    {v:?}: {name}"));
        j
    };
    ARITHMETIC.iter().map(one).collect()
}

#[test]
fn crossed_corners_kill_the_mutants_of_arithmetic() {
    let all = judged(Level::One, 2000, 60);
    let total = |f: &dyn Fn(&Judged) -> usize| all.iter().map(f).sum::<usize>();
    let others = total(&|j| j.mutants - j.count(Verdict::Same));
    let killed = total(&|j| j.mutants - j.survivors.len());
    println!("{killed} of {others} mutants that are not the original killed");
    assert!(others > 500, "only {others} mutants");
    assert!(killed * 100 >= others * 99, "{killed} of {others} killed");
}

/// What twenty times the rows would kill: the rest computes the same, as far as anybody can tell.
#[test]
#[ignore = "a minute; for whoever changes the plans"]
fn many_more_rows_kill() {
    let d = Design::default();
    all_units(|m| vector_set(&d, m, &Binding::new(), Plan { rows: 40_000, seed: 99 }));
}

/// The large tables leave no mutant of the arithmetic alive that is not the original.
#[test]
#[ignore = "minutes; part of the full budget"]
fn large_tables_kill_all_mutants_of_arithmetic() {
    let all = judged(Level::Two, 100_000, 600);
    let alive: Vec<_> = all.iter().flat_map(|j| j.survivors.iter().map(move |s| (j.unit, s))).collect();
    let alive: Vec<_> = alive.into_iter().filter(|(_, s)| s.1 != Verdict::Same).collect();
    assert!(alive.is_empty(), "{alive:?}");
}
