//! Operations per second of every engine on the same operands at 8/23, in one run, beside Berkeley SoftFloat, whose results they must equal.
//!
//! `cargo bench --bench arithmetic -- [ROWS]`: nearest even, subnormal numbers, infinities and NaN, as SoftFloat has them. Icarus, the slowest,
//! takes the first 20000 rows. Before that, all five roundings of the golden model are compared with SoftFloat's.
#[path = "../tests/golden/arithmetic/softfloat/peer.rs"]
mod peer;

use peer::{OPERATIONS, Operation, ROUNDINGS, differing, format, set_rounding};
use rayon::prelude::*;
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{campaign_set, check_netlist};
use reliefrtl::config::Config;
use reliefrtl::error::Error;
use reliefrtl::format::Subnormals;
use reliefrtl::interp::elaborate;
use reliefrtl::ir::Binding;
use reliefrtl::project::{alone, alone_text};
use reliefrtl::vectors::{Campaign, Counts, Level, Plan, Shard, VectorSet, set_files};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Rows for the slowest engine.
const ICARUS: usize = 20_000;

fn main() {
    // Cargo adds a flag of its own.
    let rows = std::env::args().skip(1).find(|a| !a.starts_with('-'));
    let rows = rows.map_or(1_000_000, |n| n.parse().expect("a number of rows"));
    println!(
        "{:<8} {:<22} {:>9} {:>8} {:>8} {:>12} {:>12}",
        "unit", "engine", "rows", "build s", "run s", "rows/s", "of SoftFloat"
    );
    OPERATIONS.iter().for_each(|o| measure(o, rows));
}

fn measure(o: &Operation, rows: usize) {
    let unit = o.unit;
    let mut c = Config::default();
    (c.format.exp, c.format.man, c.format.subnormals) = (8, 23, Subnormals::Gradual);
    let m = alone(&c, unit).expect("a unit of arithmetic");
    let campaign = Campaign { level: Level::One, shard: Shard::WHOLE };
    let set = campaign_set(&c.design(), &m, &Binding::new(), Plan { rows, seed: 1 }, campaign);
    let pairs: Vec<(u64, u64)> = set.stimulus.iter().map(|r| (r[0], r.get(1).copied().unwrap_or(0))).collect();
    for (number, rounding) in ROUNDINGS.iter().enumerate() {
        let (wrong, first) = differing(o, number, &pairs);
        assert_eq!(wrong, 0, "{unit}, {rounding:?}: {wrong} of {} differ from SoftFloat: {first:x?}", pairs.len());
    }
    println!(
        "{unit:<8} golden: 0 of {} rows differ from SoftFloat in each of {} roundings",
        pairs.len(),
        ROUNDINGS.len()
    );

    set_rounding(0);
    let start = Instant::now();
    pairs.iter().for_each(|(a, b)| _ = black_box((o.soft)(*a, *b)));
    let base = pairs.len() as f64 / start.elapsed().as_secs_f64();
    let line = |engine: &str, n: usize, build: Duration, run: Duration| {
        let (build, run) = (build.as_secs_f64(), run.as_secs_f64());
        let rate = n as f64 / run;
        println!("{unit:<8} {engine:<22} {n:>9} {build:>8.2} {run:>8.3} {rate:>12.0} {:>12.5}", rate / base);
    };
    let none = Duration::ZERO;
    line("SoftFloat, 1 thread", pairs.len(), none, Duration::from_secs_f64(pairs.len() as f64 / base));
    let start = Instant::now();
    pairs.iter().for_each(|(a, b)| _ = black_box((o.golden)(format(ROUNDINGS[0]), *a, *b)));
    line("golden, 1 thread", pairs.len(), none, start.elapsed());

    let start = Instant::now();
    let net = elaborate(&m, &set.params).expect("legal parameters");
    let (build, latency) = (start.elapsed(), m.latency().unwrap_or(0) as usize);
    let replay = |part: &VectorSet| {
        let report = check_netlist(&net, latency, part).expect("as many results as rows");
        assert_eq!(report.mismatched, 0, "{unit} in the interpreter");
    };
    let start = Instant::now();
    replay(&set);
    line("interpreter, 1 thread", set.stimulus.len(), build, start.elapsed());
    let threads = rayon::current_num_threads();
    let share = set.stimulus.len().div_ceil(threads);
    let parts: Vec<VectorSet> = (0..threads).map(|k| part(&set, k * share, share)).collect();
    let start = Instant::now();
    parts.par_iter().for_each(replay);
    line(&format!("interpreter, {threads} threads"), set.stimulus.len(), build, start.elapsed());

    for (simulator, rows) in [(Simulator::Verilator, set.stimulus.len()), (Simulator::Icarus, ICARUS)] {
        let some = part(&set, 0, rows);
        let tree = tempfile::tempdir().expect("a directory");
        let vectors = set_files(&some).into_iter().map(|(name, text)| (format!("golden/{unit}/{name}"), text));
        for (path, text) in
            alone_text(&c, std::slice::from_ref(&m)).expect("legal parameters").into_iter().chain(vectors)
        {
            let place = tree.path().join(path);
            std::fs::create_dir_all(place.parent().expect("a folder")).expect("a folder");
            std::fs::write(place, text).expect("a file");
        }
        match run_bench(simulator, tree.path(), unit, &Binding::new(), &[]) {
            Ok(r) => line(simulator.name(), r.checked, r.build, r.run),
            Err(Error::ToolMissing(text)) => println!("{unit:<8} left out: {text}"),
            Err(e) => panic!("{e}"),
        }
    }
}

/// Some rows of a set.
fn part(set: &VectorSet, first: usize, rows: usize) -> VectorSet {
    let end = (first + rows).min(set.stimulus.len());
    let cut = |x: &[Vec<u64>]| x[first.min(end)..end].to_vec();
    let counts = Counts { random: end - first.min(end), ..Default::default() };
    VectorSet { stimulus: cut(&set.stimulus), expected: cut(&set.expected), counts, ..set.clone() }
}
