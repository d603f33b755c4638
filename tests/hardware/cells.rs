//! Four cells an iteration: units, traversal and emitted text of both watertight datapaths against their golden models.
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use crate::budget::share;
use crate::checked::check_all;
use crate::files::write;
use crate::simulators::skip;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{design_at, ray_set, units};
use reliefrtl::config::{Config, Profile};
use reliefrtl::golden::{Pyramid, RayInput, encode_ray, prepare};
use reliefrtl::interp::Traffic;
use reliefrtl::ir::Binding;
use reliefrtl::project::{Scene, check_tree, project};
use reliefrtl::trace::{Pipeline, diagnose, hit};
use reliefrtl::vectors::set_files;
use std::path::Path;

/// A datapath's widths, three of each datapath.
const WIDTHS: [&str; 6] = [
    "format.exp=7 format.man=16",
    "format.exp=6 format.man=10 traverse.tile_bits=2",
    "format.exp=8 format.man=23",
    "datapath.kind=fixed",
    "datapath.kind=fixed datapath.fraction_bits=20 datapath.reciprocal_bits=18",
    "datapath.kind=fixed datapath.fraction_bits=12 datapath.reciprocal_bits=10",
];

/// Units that no other design has.
const OWN: [&str; 5] = ["block_middle", "block_descent", "plane_order", "depth_limit", "cell_choice"];

/// Modes that bring each unit and each port.
const MODES: [&str; 6] = [
    "mode.trim=none",
    "mode.trim=always mode.lod=true",
    "mode.level_up=tevs mode.levels_down=2 mode.lod=true",
    "mode.level_up=tevs mode.trim=always mode.levels_down=1 mode.levels_down_after=1",
    "mode.start_level=false mode.levels_down_after=3",
    "mode.trim=always mode.levels_down=2 mode.levels_down_after=3 mode.start_level=false",
];

/// The design of these keys, with four cells.
fn config(sets: &[&str], profile: Profile) -> Config {
    let mut c = Config::default();
    let sets = sets.iter().flat_map(|set| set.split(' '));
    ["fetch.cells=4", "traverse.levels=5"].into_iter().chain(sets).for_each(|set| c.apply_set(set).unwrap());
    c.latency = profile.latency_for(&c.design());
    c.validate().unwrap();
    c
}

/// A map of random heights, spiky in places, and `count` rays: along axes, through corners, far, steep, refused, half of them with a finest level.
fn hard(c: &Config, count: usize, seed: u64) -> (Pyramid, Vec<RayInput>) {
    let d = c.design();
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (n, h) = (d.traverse.levels, d.traverse.height_bits);
    let top = (1u32 << h) - 1;
    let texels: Vec<u32> =
        (0..1usize << (2 * n)).map(|_| rng.random_range(0..=top) >> rng.random_range(0..5)).collect();
    let (side, most) = (f64::from(1u32 << n), f64::from(1u32 << d.traverse.tile_bits));
    let ray = |k: usize| {
        let mut grid = || (rng.random::<f64>() * side).floor() / side;
        let (a, b) = (grid(), grid());
        let mut far = || (rng.random::<f64>() - 0.5) * 2.0 * most * 0.5f64.powi((k % 5) as i32);
        let (x, y) = (far(), far());
        let (p, q) = (rng.random::<f64>(), rng.random::<f64>());
        let words = match k % 7 {
            0 => [a, b, x, y],
            1 => [a, p, 0.0, x],
            2 => [a, b, 0.25, -0.25],
            3 => [p, b, x / 50.0, 0.0],
            4 => [p, q, 0.0, if k.is_multiple_of(2) { 0.0 } else { 1e9 }],
            5 => [a, q, x / 1e4, y / 1e6],
            _ => [p, q, x, y / 9.0],
        };
        let lod = if k.is_multiple_of(2) || !d.mode.lod { 0 } else { (k as u32 / 14) % (n + 1) };
        RayInput { lod, ..encode_ray(&d, words) }
    };
    let rays = (0..count).map(ray).collect();
    (Pyramid::build(n, h, &texels).unwrap(), rays)
}

#[test]
fn units_equal_their_models() {
    let mut checked = 0;
    for (k, widths) in WIDTHS.into_iter().enumerate() {
        let profile = Profile::ALL[k % 3];
        let d = config(&[widths, MODES[k]], profile).design();
        let names: Vec<String> = units(&d).iter().map(|m| m.name.clone()).collect();
        for name in OWN {
            assert!(names.iter().any(|n| n == name), "{name}");
        }
        assert!(!names.iter().any(|n| n == "multi_level_down" || n == "node_crossing"));
        checked += check_all(&d, 300);
    }
    println!("0 of {checked} mismatched");
    assert!(checked > 100_000, "only {checked} rows were checked");
}

/// With gaps, stalls and resets, in every profile, also where rays are given up.
#[test]
fn the_pipeline_equals_the_model_at_three_widths_of_each_datapath() {
    let mut checked = 0;
    for (k, widths) in WIDTHS.into_iter().enumerate() {
        for m in [k, (k + 2) % 6, (k + 3) % 6] {
            let mode = MODES[m];
            let mut c = config(&[widths, mode], Profile::ALL[(k + m) % 3]);
            c.traverse.step_limit = [65535, 4][(k + m) / 2 % 2];
            let (d, traffic) = (c.design(), Traffic { gaps: 60, stalls: 90, resets: 2, seed: m as u64 });
            let (pyramid, rays) = hard(&c, 140, 3 + k as u64);
            let g = prepare(&d).unwrap();
            let run = Pipeline::new(&d, &Binding::new()).unwrap().run(&pyramid, &rays, 16, traffic).unwrap();
            for (n, (h, r)) in run.results.iter().zip(&rays).enumerate() {
                assert_eq!(hit(&d, h), g.trace(&pyramid, r), "ray {n}, {r:x?}, of {} {:?}", d.label(), d.mode);
                checked += 1;
            }
        }
    }
    println!("0 of {checked} mismatched");
    assert_eq!(checked, 18 * 140);
}

/// Net by net, not only at the end.
#[test]
fn every_iteration_equals_the_golden_models() {
    for (k, widths) in WIDTHS.into_iter().enumerate() {
        let c = config(&[widths, MODES[k]], Profile::Published);
        let (pyramid, rays) = hard(&c, 21, 5);
        for r in &rays {
            assert_eq!(diagnose(&c.design(), &pyramid, r).unwrap(), None, "{widths} {r:x?}");
        }
    }
}

/// Values of parameters at which one elaborated text is tried.
fn over(values: &str) -> Binding {
    let pair = |p: &str| p.split_once('=').map(|(k, v)| (k.to_string(), v.parse().unwrap())).unwrap();
    values.split(' ').map(pair).collect()
}

#[test]
fn other_parameters_equal_golden() {
    let float =
        ["LEVELS=2 HEIGHT_W=16", "LEVELS=3 TILE_W=1", "LEVELS=7 HEIGHT_W=2", "EXP_W=8 MAN_W=20 TILE_W=2", "LEVELS=12"];
    let fixed = [
        "LEVELS=2 HEIGHT_W=16",
        "FRACTION_W=8 RECIP_W=8",
        "LEVELS=6 TILE_W=1",
        "FRACTION_W=28 RECIP_W=31 LEVELS=7",
        "LEVELS=12",
    ];
    for (k, values) in float.into_iter().chain(fixed).enumerate() {
        let base = config(&[WIDTHS[if k < 5 { 0 } else { 3 }], MODES[k % 2]], Profile::Published);
        let at = over(values);
        let d = design_at(&base.design(), &at);
        let (pyramid, rays) = hard(&Config { traverse: d.traverse, ..base.clone() }, 70, k as u64);
        // Words of the widths at hand.
        let rays: Vec<RayInput> = if k < 5 && values.starts_with("EXP") || k >= 5 && values.starts_with("FRAC") {
            let sized = |v: f64| v / 3.0;
            (0..70)
                .map(|n| encode_ray(&d, [sized(f64::from(n) / 70.0), 0.4, sized(f64::from(n % 9) - 4.0), 0.7]))
                .collect()
        } else {
            rays
        };
        let g = prepare(&d).unwrap();
        let run = Pipeline::new(&base.design(), &at).unwrap().run(&pyramid, &rays, 16, Traffic::default()).unwrap();
        for (n, (h, r)) in run.results.iter().zip(&rays).enumerate() {
            assert_eq!(hit(&d, h), g.trace(&pyramid, r), "ray {n} at {values}");
        }
    }
}

/// A tree of a small map.
fn tree(c: &mut Config, dir: &Path) {
    c.traverse.levels = 4;
    c.vectors.planned = false;
    (c.vectors.arithmetic, c.vectors.rays) = (400, 40);
    c.validate().unwrap();
    write(dir, &project(c, &Scene::new(c, None, false).unwrap()).unwrap().files);
}

/// The units that no other design has, and `traverse`; that at other sizes besides, with the map loaded through the port and there from power-up on.
#[test]
fn the_emitted_text_in_both_simulators() {
    if skip() {
        return;
    }
    let only: Vec<String> = OWN.into_iter().chain(["traverse"]).map(String::from).collect();
    for (k, (sim, widths, mode)) in [
        (Simulator::Icarus, WIDTHS[0], MODES[0]),
        (Simulator::Verilator, WIDTHS[1], MODES[1]),
        (Simulator::Icarus, WIDTHS[5], MODES[1]),
    ]
    .into_iter()
    .take(if share(2) == 1 { 3 } else { 2 })
    .enumerate()
    {
        let mut c = config(&[widths, mode], Profile::Balanced);
        let dir = tempfile::tempdir().unwrap();
        tree(&mut c, dir.path());
        let done = check_tree(&c, dir.path(), sim.into(), &only, None, None, &|_| ()).unwrap();
        assert!(done.len() == only.len() && done.iter().all(|x| x.rows > 0));
        for (values, plusargs) in [("LEVELS=2 HEIGHT_W=8", "gaps stalls flood"), ("LEVELS=6 HEIGHT_W=8", "preloaded")] {
            let at = over(values);
            let d = design_at(&c.design(), &at);
            let (pyramid, rays) = hard(&Config { traverse: d.traverse, ..c.clone() }, 100, k as u64);
            let set = ray_set(&d, &pyramid, &rays, 1).unwrap();
            let place = tempfile::tempdir().unwrap();
            let mut files = set_files(&set.set);
            files.extend(set.memory_files().map(|(name, text)| (name, text.clone())));
            write(place.path(), &files);
            let mut args = vec![format!("vectors={}", place.path().display())];
            args.extend(plusargs.split(' ').map(String::from));
            let o = run_bench(sim, dir.path(), "traverse", &at, &args).unwrap_or_else(|e| panic!("{at:?}: {e}"));
            assert_eq!(o.checked, rays.len());
        }
    }
}
