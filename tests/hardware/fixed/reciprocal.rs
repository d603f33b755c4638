//! `reciprocal` by rows and by a table of reciprocals: the same bits as the golden model for random travels and for those whose quotient lies as
//! near as can be to half-way between two results.
use super::design;
use crate::files::write;
use crate::simulators::skip;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use reliefrtl::bench::Simulator;
use reliefrtl::catalogue::{design_at, find};
use reliefrtl::config::{Config, Design, Divider};
use reliefrtl::golden::Datapath;
use reliefrtl::golden::fixed::Fixed;
use reliefrtl::interp::{Lanes, elaborate};
use reliefrtl::ir::Binding;
use reliefrtl::project::{Scene, check_tree, project};
use std::collections::BTreeMap;

/// FRACTION_W, RECIP_W, TILE_W and HEIGHT_W.
const WIDTHS: [[u32; 4]; 10] = [
    [24, 24, 4, 8],
    [24, 24, 4, 16],
    [24, 24, 8, 4],
    [20, 18, 4, 12],
    [20, 19, 4, 8],
    [12, 10, 4, 8],
    [12, 10, 1, 4],
    [28, 31, 4, 16],
    [28, 31, 4, 5],
    [16, 8, 8, 16],
];

fn by_table(clocks: u32) -> Design {
    let mut d = design(24, 24);
    (d.latency.div, d.latency.divider) = (clocks, Divider::Table);
    d
}

fn binding([f, w, t, h]: [u32; 4]) -> Binding {
    let values = [("FRACTION_W", f), ("RECIP_W", w), ("TILE_W", t), ("HEIGHT_W", h)];
    values.iter().map(|(k, v)| (k.to_string(), i64::from(*v))).collect()
}

/// Any travel of any length, beside the borders of the table's lines, and where M / A is half-way between two results, or next to it.
fn travel(rng: &mut ChaCha8Rng, [f, w, t, h]: [u32; 4]) -> u64 {
    let reach = f + t;
    let top = 1u64 << (reach - 1);
    let moved = match rng.random_range(0..8u32) {
        0..3 => top | rng.random_range(0..top),
        3 => top + (rng.random_range(0..256u64) << (reach - 9)) + rng.random_range(0..4),
        4 => 2 * top - 1 - rng.random_range(0..4),
        5 => top + (1 << rng.random_range(0..reach - 1)) - rng.random_range(0..2),
        _ => {
            // The divisor whose quotient is nearest to an odd number of W + 1 bits.
            let half = 1 | 1 << w | rng.random_range(0..1u64 << w);
            let m = u128::from((1u64 << h) - 1) << (reach - h);
            let near = ((m << (w + 1)) / u128::from(half)) as u64;
            let near = near >> u32::from(near >= 2 * top);
            near.wrapping_add(rng.random_range(0..3)).wrapping_sub(1).clamp(top, 2 * top - 1)
        }
    };
    moved >> if rng.random() { 0 } else { rng.random_range(0..=reach) }
}

/// Rows of one design at some widths; what differs fails.
fn rows(d: &Design, widths: [u32; 4], count: usize) -> usize {
    const LANES: usize = 1024;
    let over = binding(widths);
    let unit = find(d, "reciprocal").unwrap();
    assert_eq!(unit.failed_checks(&over), Vec::<String>::new());
    let net = elaborate(&unit, &over).unwrap();
    let golden = Fixed::prepare(&design_at(d, &over)).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(u64::from(widths[1] * 64 + widths[3] + d.latency.div));
    let mut lanes = Lanes::new(&net, LANES);
    lanes.fill(net.input("ce"), 1);
    let mut done = 0;
    while done < count {
        let travels: Vec<u64> = (0..LANES).map(|k| if done + k == 0 { 0 } else { travel(&mut rng, widths) }).collect();
        travels.iter().enumerate().for_each(|(k, a)| lanes.set(net.input("a"), k, *a));
        (0..d.latency.div).for_each(|_| {
            lanes.eval();
            lanes.clock();
        });
        lanes.eval();
        for (k, a) in travels.iter().enumerate() {
            let (r, z) = golden.reciprocal(*a);
            let got = (lanes.get(net.output("r"), k), lanes.get(net.output("z"), k));
            assert_eq!(got, (r, u64::from(z)), "a = {a} at {widths:?}, {} clocks", d.latency.div);
        }
        done += LANES;
    }
    done
}

#[test]
fn a_table_gives_what_rows_give() {
    let all: Vec<([u32; 4], u32)> = WIDTHS.into_iter().zip([2, 6, 9, 13, 20, 29, 3, 32, 4, 12]).collect();
    let total: usize = all.par_iter().map(|(widths, clocks)| rows(&by_table(*clocks), *widths, 150_000)).sum();
    println!("reciprocal by table: 0 of {total} mismatched");
    assert!(total > 1_000_000);
}

/// Every width of the reciprocal and every height, with few travels each; and the rows at some of them.
#[test]
fn every_width_has_the_same_text() {
    let all: Vec<[u32; 4]> =
        (8..=31).flat_map(|w| (4..=16).map(move |h| [if h > 8 { 16 } else { 28 }, w, 4, h])).collect();
    let total: usize = all.par_iter().map(|widths| rows(&by_table(7), *widths, 4096)).sum();
    let mut d = design(24, 24);
    d.latency.div = 5;
    let rows: usize = WIDTHS.par_iter().map(|widths| rows(&d, *widths, 20_000)).sum();
    println!("0 of {total} mismatched by table, 0 of {rows} by rows");
}

#[test]
fn a_table_in_both_simulators() {
    if skip() {
        return;
    }
    for (search, sim, clocks) in
        [("pyramid", Simulator::Icarus, 4), ("windows", Simulator::Icarus, 29), ("windows", Simulator::Verilator, 13)]
    {
        let mut c = Config::default();
        let sets = ["datapath.kind=fixed", "latency.divider=table", "traverse.levels=4"];
        let more = [format!("datapath.search={search}"), format!("latency.div={clocks}")];
        sets.iter().map(|s| s.to_string()).chain(more).for_each(|s| c.apply_set(&s).unwrap());
        (c.vectors.planned, c.vectors.arithmetic, c.vectors.rays) = (false, 1500, 40);
        c.validate().unwrap();
        let dir = tempfile::tempdir().unwrap();
        write(dir.path(), &project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files);
        let units = ["reciprocal", "recip_table", "ray_setup", "traverse"].map(String::from);
        let done = check_tree(&c, dir.path(), sim.into(), &units, None, None, &|_| ()).unwrap();
        let by_name: BTreeMap<_, _> = done.iter().map(|x| (x.unit.clone(), x.rows)).collect();
        println!("{} {search} at {clocks} clocks: {by_name:?}", sim.name());
        assert_eq!(done.len(), units.len());
        assert!(done.iter().all(|x| x.rows > 0));
    }
}
