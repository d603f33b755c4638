//! The divider by table: its words, the bound of its estimate for every divisor, and the unit at every fraction width that it has,
//! in the interpreter and both simulators.
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use crate::budget::share;
use crate::files::write;
use crate::simulators::skip;
use rayon::prelude::*;
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{Context, Modelled, campaign_set, check_interp, find, vector_set};
use reliefrtl::config::{Config, Design};
use reliefrtl::interp::{Lanes, elaborate};
use reliefrtl::ir::{Binding, Module};
use reliefrtl::project::{alone, alone_files};
use reliefrtl::synth::{Placing, Target, measure};
use reliefrtl::units::recip_table::recip_table_module;
use reliefrtl::vectors::{Campaign, Level, Plan, Shard, VectorSet, set_files};
use reliefrtl::verilog::{Style, print_module};
use std::sync::Arc;

fn config(clocks: u32) -> Config {
    let mut c = Config::default();
    c.vectors.arithmetic = 1;
    for set in ["latency.divider=table".to_owned(), format!("latency.div={clocks}")] {
        c.apply_set(&set).unwrap();
    }
    c
}

fn divider(clocks: u32) -> (Design, Arc<Module>) {
    let d = config(clocks).design();
    (d, find(&d, "fp_div").unwrap())
}

fn at(exp: i64, man: i64) -> Binding {
    Binding::from([("EXP_W".into(), exp), ("MAN_W".into(), man)])
}

/// The table as the interpreter reads it: start and slope of each line.
fn lines() -> Vec<(i128, i128)> {
    let net = elaborate(&recip_table_module(), &Binding::new()).unwrap();
    let mut lanes = Lanes::new(&net, 256);
    (0..256).for_each(|i| lanes.set(net.input("index"), i, i as u64));
    lanes.fill(net.input("ce"), 1);
    lanes.eval();
    lanes.clock();
    lanes.eval();
    let words = (0..256).map(|i| i128::from(lanes.get(net.output("word"), i)));
    words.map(|w| (w >> 12, w & 0xfff)).collect()
}

#[test]
fn words_are_those_of_the_text_and_of_the_model() {
    let text = print_module(&recip_table_module(), &Style::default());
    let printed = text.lines().filter_map(|l| l.split("33'h").nth(1)?.strip_suffix(';'));
    let printed: Vec<i128> = printed.map(|w| i128::from_str_radix(w, 16).unwrap()).collect();
    let read: Vec<i128> = lines().iter().map(|(start, slope)| start << 12 | slope).collect();
    let (m, params) = (recip_table_module(), Binding::new());
    let (unit, c) = (Modelled::of(&Design::default(), &m), Context::new(Design::default(), &params));
    let of_model = |i| i128::from(unit.results(&c, &[i])[0]);
    assert_eq!(printed, read);
    assert_eq!(printed, (0..256).map(of_model).collect::<Vec<_>>());
}

/// The text in Icarus, and in Verilator: all words.
#[test]
fn words_are_those_of_the_simulators() {
    for sim in [Simulator::Icarus, Simulator::Verilator] {
        assert_eq!(replay(sim, &config(4), "recip_table", &Binding::new(), all_rows), 256);
    }
}

/// For every divisor of 16 fraction bits, and the dividend that makes most of its error: the estimate lies at most half a unit of the last
/// place beside the quotient. Shorter fractions are among these, filled up, and their last place is larger.
#[test]
fn every_estimate_is_near_enough() {
    let lines = lines();
    let mut worst = (0.0, 0);
    for frac in 0..1i128 << 16 {
        let (start, slope) = lines[frac as usize >> 8];
        let sum = start - ((slope * (frac & 0xff)) >> 6);
        assert!((0..1 << 21).contains(&sum), "the reciprocal leaves its width at {frac}");
        // In units of 2^-19, and the divisor in units of 2^-16: their product is 2^35 but for the error.
        let (recip, div) = ((1 << 18) + (sum >> 3), (1 << 16) + frac);
        // The dividend, doubled where it is less; the error grows with it.
        let most = (2 * div - 2).max((1 << 17) - 1);
        let error = (recip * div - (1i128 << 35)).abs() * most;
        // error / (2^35 * div), in halves of 2^-16.
        let (error, limit) = (error << 17, div << 35);
        assert!(error <= limit, "the estimate of a division by {div} is too far off");
        let share = error as f64 / limit as f64;
        worst = if share > worst.0 { (share, frac) } else { worst };
    }
    println!("largest error {:.4} of half a unit, at fraction {}", worst.0, worst.1);
    assert!(worst.0 > 0.5, "a bound that nothing comes near says nothing");
}

/// Estimate, remainder's two bits and choice as `docs/arithmetic.md` has them, against integer division: every divisor of 16 fraction
/// bits by so many dividends (`RELIEFRTL_DIVIDENDS`, default 64; 65536 are all).
#[test]
fn every_divisor_rounds_right() {
    let dividends: u64 = std::env::var("RELIEFRTL_DIVIDENDS").map_or(64, |v| v.parse().expect("a number of dividends"));
    let lines = lines();
    let quotient = |a: u64, div: u64| {
        let (start, slope) = lines[(div >> 8 & 0xff) as usize];
        let recip = (start as u64 - ((slope as u64 * (div & 0xff)) >> 6)) >> 3;
        let num = if a < div { 2 * a } else { a };
        let low = (num + ((num * recip) >> 18)) >> 1;
        let back = (((2 * low + 1) * div) >> 17) & 3;
        let up = (num >> 1 ^ back >> 1 ^ (num & !back)) & 1;
        let exact = (num << 17) / div;
        assert_eq!(low + up, (exact + 1) >> 1, "{a} / {div}");
    };
    let step = (1u64 << 16).div_ceil(dividends);
    (1u64 << 16..1 << 17).into_par_iter().for_each(|div| {
        (0..dividends).for_each(|k| quotient((1 << 16) + (k * step + div * 40503) % (1 << 16), div));
        [1 << 16, (1 << 17) - 1, div, (div - 1).max(1 << 16)].into_iter().for_each(|a| quotient(a, div));
    });
    println!("65536 divisors, {dividends} dividends and 4 corners each, 0 rounded wrong");
}

/// What Yosys makes of it: one block memory, and a multiplier block for each product but one, whose factors both have 18 bits: the block of
/// that family takes 24 x 17 without a sign.
#[test]
fn the_table_is_one_block_memory() {
    if skip() {
        return;
    }
    // The fewest clocks, more, and more than there are sections; each is the same table.
    for clocks in [2, 4, 9].into_iter().step_by(share(3)) {
        let f = measure(&divider(clocks).1, &Target::Xilinx, &Placing { seeds: vec![], ..Placing::default() }).unwrap();
        assert_eq!((f.memories, f.multipliers), (1, 4), "{clocks} clocks");
    }
}

/// Every pair of all formats of at most 8 bits, at clocks from the fewest to more than there are sections.
#[test]
fn every_pair_of_small_formats() {
    let mut all = Vec::new();
    for exp in 2..=5i64 {
        all.extend((2..=7 - exp).flat_map(|man| (2..=10).map(move |clocks| (exp, man, clocks))));
    }
    let rows = |(exp, man, clocks): &(i64, i64, u32)| {
        let (d, m) = divider(*clocks);
        let set = vector_set(&d, &m, &at(*exp, *man), Plan { rows: 1, seed: 1 });
        assert_eq!(set.stimulus.len(), 1 << (2 * (1 + exp + man)), "all pairs");
        checked(&m, &set)
    };
    let total: usize = all.par_iter().map(rows).sum();
    println!("{} formats and latencies, 0 of {total} mismatched", all.len());
    assert!(total > 1_000_000, "{total}");
}

/// Random and corner operands at every fraction width.
#[test]
fn every_fraction_width() {
    let all: Vec<(i64, u32)> = (2..=16).flat_map(|man| [2, 3, 4, 5, 6, 7, 8, 11, 32].map(|l| (man, l))).collect();
    let rows = |(man, clocks): &(i64, u32)| {
        let (d, m) = divider(*clocks);
        let exp = 2 + (man * 5 + i64::from(*clocks)) % 10;
        let campaign = Campaign { level: Level::One, shard: Shard { index: 1, of: 3 } };
        let sets = [
            vector_set(&d, &m, &at(exp, *man), Plan { rows: 3000, seed: 8 }),
            campaign_set(&d, &m, &at(exp, *man), Plan { rows: 500, seed: 8 }, campaign),
        ];
        sets.iter().map(|set| checked(&m, set)).sum::<usize>()
    };
    let total: usize = all.par_iter().map(rows).sum();
    println!("MAN_W 2 to 16, 0 of {total} mismatched (seed 8)");
    assert!(total > 400_000, "{total}");
}

fn checked(m: &Arc<Module>, set: &VectorSet) -> usize {
    let report = check_interp(m, set).unwrap_or_else(|e| panic!("{:?}: {e}", set.params));
    report.verdict(set, m).unwrap_or_else(|e| panic!("{:?}: {e}", set.params));
    report.checked
}

/// One text serves all formats, in both simulators.
#[test]
fn the_same_text_at_other_formats() {
    let mut all = Vec::new();
    for (sim, clocks) in
        [(Simulator::Icarus, 2), (Simulator::Icarus, 4), (Simulator::Icarus, 9), (Simulator::Verilator, 6)]
    {
        let formats = [Binding::new(), at(5, 10), at(4, 3), at(3, 2), at(11, 13)];
        let formats = formats.into_iter().take(if sim == Simulator::Icarus { 5 } else { 3 });
        all.extend(formats.map(|b| (sim, clocks, b)));
    }
    // Of five formats one in two: of each clocks some, and each format somewhere.
    let all: Vec<_> = all.into_iter().step_by(share(2)).collect();
    let one = |(sim, clocks, b): &(Simulator, u32, Binding)| replay(*sim, &config(*clocks), "fp_div", b, crossed);
    let total: usize = all.par_iter().map(one).sum();
    println!("fp_div by table in the simulators: 0 of {total} mismatched");
    assert!(total > 200_000 / share(2), "{total}");
}

fn all_rows(d: &Design, m: &Arc<Module>, b: &Binding) -> VectorSet {
    vector_set(d, m, b, Plan { rows: 1, seed: 1 })
}

/// All pairs where they are few, else corners of level 1 and random ones.
fn crossed(d: &Design, m: &Arc<Module>, b: &Binding) -> VectorSet {
    let set = all_rows(d, m, b);
    let campaign = Campaign { level: Level::One, shard: Shard::WHOLE };
    if set.stimulus.len() > 1 { set } else { campaign_set(d, m, b, Plan { rows: 2000, seed: 5 }, campaign) }
}

/// Emits `unit` with `c`, and replays `rows` at parameter values `over` in the emitted text; returns the rows compared.
fn replay(
    sim: Simulator,
    c: &Config,
    unit: &str,
    over: &Binding,
    rows: impl Fn(&Design, &Arc<Module>, &Binding) -> VectorSet,
) -> usize {
    let m = alone(c, unit).expect("the unit stands alone");
    let set = rows(&c.design(), &m, over);
    if skip() {
        return set.stimulus.len();
    }
    let mut files = alone_files(c, std::slice::from_ref(&m), None).unwrap();
    files.extend(set_files(&set).into_iter().map(|(n, t)| (format!("here/{n}"), t)));
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), &files);
    let vectors = [format!("vectors={}", dir.path().join("here").display())];
    let done = run_bench(sim, dir.path(), unit, &set.params, &vectors)
        .unwrap_or_else(|e| panic!("{}, {unit} at {over:?}: {e}", sim.name()));
    assert_eq!(done.checked, set.stimulus.len());
    done.checked
}

#[test]
fn what_it_can_not_have_is_refused() {
    let refused = |sets: &[&str], words: &[&str]| {
        let mut c = config(4);
        sets.iter().for_each(|s| c.apply_set(s).unwrap());
        let said = [c.validate(), c.design().check_divider()].map(|r| r.unwrap_err().to_string());
        assert!(said.iter().all(|s| words.iter().all(|w| s.contains(w))), "{said:?}");
    };
    refused(&["format.man=17"], &["latency.divider = \"table\"", "format.man = 17 is too large, 2 to 16 are legal"]);
    refused(&["latency.div=1"], &["latency.div = 1 is too small, 2 to 32 are legal"]);
    refused(&["format.rounding=up"], &["the format is 7/16 up"]);
    refused(&["format.subnormals=gradual"], &["the format is 7/16 gradual"]);
    refused(
        &["datapath.kind=fixed", "datapath.reciprocal_bits=32"],
        &["datapath.reciprocal_bits = 32 is too large, 8 to 31 are legal"],
    );
    let (_, m) = divider(4);
    assert_eq!(m.failed_checks(&at(7, 16)), Vec::<String>::new());
    assert_eq!(m.failed_checks(&at(7, 17)), ["fp_div: MAN_W <= 16 does not hold (17 > 16)"]);
    assert!(print_module(&m, &Style::default()).contains("MAN_W_must_be_at_most_16 u_illegal ();"));
}
