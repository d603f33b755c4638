//! Mutants of the datapath: one operation of a unit is replaced by its neighbour, and the committed vectors have to notice.
//! What survives is listed by name with `cargo test --test mutants -- --nocapture`.
use rayon::prelude::*;
use reliefrtl::catalogue::{check_netlist, units};
use reliefrtl::config::Design;
use reliefrtl::interp::{FlatOp, Kind, Netlist, elaborate};
use reliefrtl::vectors::{VectorSet, read_set};
use std::path::PathBuf;

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

/// Mutants of one unit, and the names of those that live.
fn mutate(net: &Netlist, latency: usize, set: &VectorSet) -> (usize, Vec<String>) {
    let all: Vec<(usize, &str, FlatOp)> =
        net.ops.iter().enumerate().flat_map(|(i, op)| neighbours(op).into_iter().map(move |(w, o)| (i, w, o))).collect();
    let lives = |(i, what, op): &(usize, &str, FlatOp)| {
        let mut other = net.clone();
        other.ops[*i] = *op;
        let report = check_netlist(&other, latency, set).unwrap();
        (report.mismatched == 0).then(|| format!("{} {:?} -> {what}", name(net, *i), net.ops[*i].kind))
    };
    (all.len(), all.par_iter().filter_map(lives).collect())
}

#[test]
fn committed_vectors_kill_the_mutants() {
    let golden = std::env::var_os("RELIEFRTL_GOLDEN").map(PathBuf::from);
    let golden = golden.unwrap_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("golden"));
    let (mut total, mut alive) = (0, 0);
    let mut weak = Vec::new();
    for m in units(&Design::default()) {
        let net = elaborate(&m, &Default::default()).unwrap();
        let (set, _) = read_set(&golden.join(&m.name)).unwrap();
        let (n, survivors) = mutate(&net, m.latency.unwrap() as usize, &set);
        println!("{:<17} {} of {n} killed{}", m.name, n - survivors.len(), if n == 0 { " (no operation to change)" } else { "" });
        survivors.iter().for_each(|s| println!("    lives: {s}"));
        if survivors.len() * 100 > n * 15 {
            weak.push(m.name.clone());
        }
        total += n;
        alive += survivors.len();
    }
    println!("{} of {total} killed, {alive} live", total - alive);
    assert!(total > 1000, "only {total} mutants");
    assert!(weak.is_empty(), "the vectors of {} let more than 15 % of the mutants live", weak.join(", "));
}
