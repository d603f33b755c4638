//! Sources of heights whose lookups miss: every ray comes back once, with the hit and the iterations of the golden model, whatever missed.
mod drive;
mod lookups;
mod parking;

use crate::budget::share;
use drive::{Ports, drive};
use lookups::{Lookups, Miss};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use reliefrtl::bench::{Paths, Simulator, bench_files, run_bench_on};
use reliefrtl::catalogue::ray_set;
use reliefrtl::config::{Config, DatapathKind, Design, LevelUp, Profile, Trim};
use reliefrtl::golden::{Pyramid, RayInput, encode_ray, prepare};
use reliefrtl::interp::elaborate;
use reliefrtl::ir::Binding;
use reliefrtl::trace::{Pipeline, hit_row, inputs, outputs};
use reliefrtl::units::traversal::{HeightSource, OnChip, Traverse, traverse_from};

/// A datapath, and how many cells a read gives.
type Way = (DatapathKind, u32);

/// One node a read with each datapath, the windows of all sizes, and four cells with those that have them.
const WAYS: [Way; 6] = [
    (DatapathKind::Watertight, 1),
    (DatapathKind::Published, 1),
    (DatapathKind::Fixed, 1),
    (DatapathKind::Windows, 1),
    (DatapathKind::Watertight, 4),
    (DatapathKind::Fixed, 4),
];

/// Every way in a small map; the level-up rule and the registers differ from case to case.
fn design((kind, cells): Way, case: usize) -> Design {
    let mut d = Design::default();
    d.datapath.kind = kind;
    d.fetch.cells = cells;
    d.latency = [Profile::Published, Profile::Balanced, Profile::Fast][case % 3].latency(kind);
    d.latency.handshake = (case % 4) as u32;
    d.traverse.levels = 4;
    let rules: &[LevelUp] = if cells == 4 { &[LevelUp::Selective, LevelUp::Tevs] } else { &LevelUp::ALL };
    d.mode.level_up = rules[case % rules.len()];
    d.mode.trim = Trim::None;
    d
}

fn scene(d: &Design, count: usize, seed: u64) -> (Pyramid, Vec<RayInput>) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let n = d.traverse.levels;
    let texels: Vec<u32> =
        (0..1usize << (2 * n)).map(|_| rng.random_range(0..=255u32) >> rng.random_range(0..4)).collect();
    let rays = (0..count).map(|_| {
        let [u, v] = [(); 2].map(|()| rng.random_range(0.0..0.99));
        let [du, dv] = [(); 2].map(|()| (rng.random::<f64>() - 0.5) * 2.0);
        encode_ray(d, [u, v, du, dv])
    });
    let rays = rays.collect();
    (Pyramid::build(n, 8, &texels).unwrap(), rays)
}

fn pipeline(d: &Design, t: &Traverse) -> Pipeline {
    let net = elaborate(&t.module, &Binding::new()).unwrap();
    let (inputs, outputs) = (inputs(&t.module), outputs(&t.module));
    Pipeline { net, slots: t.slots, design: *d, inputs, outputs, depth: t.setup + t.slots + t.finish }
}

/// Clocks of `rays` through `traverse` with that source; every result is the golden model's.
fn run(
    d: &Design,
    source: &dyn HeightSource,
    (map, rays): &(Pyramid, Vec<RayInput>),
    ports: Ports,
) -> Result<u64, String> {
    let p = pipeline(d, &traverse_from(d, source));
    let (image, items) = p.words(map, rays);
    let (results, clocks) = drive(&p, &image, &items, ports)?;
    let golden = prepare(d).unwrap();
    for (k, (got, r)) in results.iter().zip(rays).enumerate() {
        let want = hit_row(d, &golden.trace(map, r));
        if *got != want {
            return Err(format!("ray {k}: {got:?} instead of {want:?}"));
        }
    }
    Ok(clocks)
}

const SMOOTH: Ports = Ports { gaps: 0, stalls: 0, reset_at: None, patience: 20_000, seed: 1 };

/// Every way to read, what a ray does after a miss, and how many lookups miss; fill times, slots, registers, rules and ports change from case to case.
#[test]
fn every_ray_comes_back_once_whatever_misses() {
    let ways = [
        Miss::Recirculate,
        Miss::Park { places: 1, swap: true },
        Miss::Park { places: 3, swap: true },
        Miss::Park { places: 8, swap: true },
    ];
    let mut cases = Vec::new();
    for way in WAYS {
        for miss in ways {
            for misses in [0, 1, 4, 7, 8] {
                cases.push((way, miss, misses));
            }
        }
    }
    let slots = cases.par_iter().enumerate().step_by(share(2)).map(|(case, &(way, miss, misses))| {
        let d = design(way, case);
        let fill = [0, 3, 40, 100][case / 3 % 4];
        let source = Lookups { seed: 77 + case as u16, misses, fill, clocks: (case % 2) as u32, miss, astray: false };
        let reset_at = (case % 2 == 0).then_some(150 + case as u64);
        let ports = Ports {
            gaps: [0, 2, 6][case % 3],
            stalls: [5, 0, 2][case / 2 % 3],
            reset_at,
            patience: 100_000,
            seed: case as u64,
        };
        let scene = scene(&d, 120, case as u64);
        let clocks = run(&d, &source, &scene, ports);
        assert!(clocks.is_ok(), "{way:?} {source:?} {ports:?} {:?}: {}", d.latency, clocks.unwrap_err());
        traverse_from(&d, &source).slots
    });
    let slots: std::collections::BTreeSet<u32> = slots.collect();
    assert!(slots.len() >= 6, "few lengths of the loop: {slots:?}");
}

/// Each parked ray's place is taken by one that must wait, or nothing moves: without rule 3 all slots wait for a place, and all places for a slot.
#[test]
fn without_the_exchange_of_places_all_rays_stand_still() {
    let d = design(WAYS[0], 0);
    let scene = scene(&d, 240, 5);
    let source =
        |swap| Lookups { seed: 3, misses: 8, fill: 40, clocks: 0, miss: Miss::Park { places: 1, swap }, astray: false };
    let stuck = run(&d, &source(false), &scene, SMOOTH).unwrap_err();
    assert!(stuck.contains("are stuck"), "{stuck}");
    run(&d, &source(true), &scene, SMOOTH).unwrap();
}

/// Misses cost clocks, and parking wins some of them back; a source that never misses takes as long as memory on chip.
#[test]
fn misses_cost_clocks_and_parking_wins_some_back() {
    let d = design(WAYS[2], 0);
    let scene = scene(&d, 240, 6);
    let clocks = |source: &dyn HeightSource| run(&d, source, &scene, SMOOTH).unwrap();
    let lookups = |misses, miss| Lookups { seed: 9, misses, fill: 60, clocks: 0, miss, astray: false };
    let on_chip = clocks(&OnChip);
    assert_eq!(clocks(&lookups(0, Miss::Recirculate)), on_chip);
    assert_eq!(clocks(&lookups(0, Miss::Park { places: 4, swap: true })), on_chip);
    let rounds = clocks(&lookups(4, Miss::Recirculate));
    let parked = clocks(&lookups(4, Miss::Park { places: 16, swap: true }));
    assert!(on_chip < parked && parked < rounds, "on chip {on_chip}, parked {parked}, recirculating {rounds}");
}

/// What the next iteration reads is what was looked up for it: a lookup that goes astray gives wrong words, and with them wrong hits.
#[test]
fn a_lookup_of_another_address_is_noticed() {
    for way in WAYS {
        let d = design(way, 0);
        let scene = scene(&d, 24, 7);
        let source = |astray| Lookups { seed: 9, misses: 2, fill: 9, clocks: 0, miss: Miss::Recirculate, astray };
        run(&d, &source(false), &scene, SMOOTH).unwrap_or_else(|e| panic!("{way:?}: {e}"));
        let wrong = run(&d, &source(true), &scene, SMOOTH).expect_err("wrong words");
        assert!(wrong.contains("instead of"), "{way:?}: {wrong}");
    }
}

/// The node that a trim reads is not known at the end of the loop.
#[test]
#[should_panic(expected = "a height source that misses has no chord trim")]
fn a_source_that_misses_is_refused_with_a_trim() {
    let mut d = design(WAYS[0], 0);
    d.mode.trim = Trim::Always;
    traverse_from(&d, &Lookups { seed: 1, misses: 1, fill: 1, clocks: 0, miss: Miss::Recirculate, astray: false });
}

/// The emitted text of a parking source in Icarus, under the bench of `traverse`.
#[test]
fn a_parking_source_in_icarus() {
    if std::env::var("RELIEFRTL_NO_SIMULATORS").is_ok_and(|v| v == "1") {
        println!("skipped: RELIEFRTL_NO_SIMULATORS=1");
        return;
    }
    // One node a read, all windows, four cells: with a register in the lookup, and without.
    for (way, clocks, count) in [(WAYS[0], 1, 120), (WAYS[3], 0, 24), (WAYS[4], 0, 24)] {
        parked_in_icarus(way, clocks, count);
    }
}

fn parked_in_icarus((kind, cells): Way, clocks: u32, count: usize) {
    let mut c = Config::default();
    c.traverse.levels = 4;
    c.datapath.kind = kind;
    c.fetch.cells = cells;
    c.latency = Profile::Published.latency(kind);
    let d = c.design();
    let (map, rays) = scene(&d, count, 4);
    let source =
        Lookups { seed: 8, misses: 4, fill: 30, clocks, miss: Miss::Park { places: 2, swap: true }, astray: false };
    let t = traverse_from(&d, &source);
    let modules = reliefrtl::emit::modules(std::slice::from_ref(&t.module)).unwrap();
    let mut files = reliefrtl::emit::rtl(&c, &modules);
    files.extend(bench_files(&[], Some((&d, &t)), &c.emit));
    let set = ray_set(&d, &map, &rays, 1).unwrap();
    let vectors = reliefrtl::vectors::set_files(&set.set).into_iter();
    files.extend(vectors.map(|(n, text)| (format!("golden/traverse/{n}"), text)));
    files.extend(set.memory_files().map(|(n, text)| (format!("golden/traverse/{n}"), text.clone())));
    let dir = tempfile::tempdir().unwrap();
    for (path, text) in &files {
        let place = dir.path().join(path);
        std::fs::create_dir_all(place.parent().unwrap()).unwrap();
        std::fs::write(place, text).unwrap();
    }
    let run = run_bench_on(Simulator::Icarus, dir.path(), "traverse", &Binding::new(), &Paths::default(), &[]);
    let run = run.unwrap_or_else(|e| panic!("{e}"));
    assert!(run.code == 0 && run.checked >= rays.len(), "{run:?}");
}
