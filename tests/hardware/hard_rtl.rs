//! The hardware on the hard cases: in every mode it equals the golden model, and all modes hit alike.
use crate::budget;
use crate::files::write;
use crate::simulators::skip;
use rayon::prelude::*;
use reliefrtl::bench::{Simulator, bench_files, run_bench};
use reliefrtl::catalogue::ray_set;
use reliefrtl::config::{Config, Design, LevelUp, ModeConfig, Profile, TraverseConfig};
use reliefrtl::golden::{Pyramid, RayHit, RayInput, encode_ray, prepare};
use reliefrtl::interp::Traffic;
use reliefrtl::ir::Binding;
use reliefrtl::measure::corner_cases::answer;
use reliefrtl::measure::soak::{endure, modes};
use reliefrtl::project::hardware;
use reliefrtl::scene::hard::Case;
use reliefrtl::trace::{Pipeline, hit};
use reliefrtl::vectors::set_files;
use std::collections::HashMap;

const SEED: u64 = 1;

/// With few registers: what a ray takes in the interpreter and in Icarus grows with the slots of the loop, and the hits don't depend on them.
fn config(sets: &[&str]) -> Config {
    let mut c = Config::default();
    sets.iter().for_each(|set| c.apply_set(set).unwrap());
    c.latency = Profile::Published.latency(c.datapath.kind);
    c.validate().unwrap();
    c
}

/// A case that fits the configuration: its design, map and rays.
struct Given {
    name: &'static str,
    design: Design,
    pyramid: Pyramid,
    rays: Vec<RayInput>,
}

fn cases(c: &Config, rays: usize, largest: u32) -> Vec<Given> {
    let of = |case: &'static Case| {
        let scene = case.scene(&c.design(), rays, SEED);
        let t = scene.design.traverse;
        let fits = Config { traverse: t, ..c.clone() }.validate().is_ok() && t.levels <= largest;
        fits.then(|| Given {
            name: case.name,
            design: scene.design,
            pyramid: Pyramid::build(t.levels, t.height_bits, &scene.texels).unwrap(),
            rays: scene.rays.iter().map(|r| encode_ray(&scene.design, *r)).collect(),
        })
    };
    Case::all().filter_map(of).collect()
}

/// Traces cases in one mode; returns the hits, case by case.
fn in_mode(given: &[&Given], mode: ModeConfig) -> Vec<Vec<RayHit>> {
    let mut pipelines: HashMap<TraverseConfig, Pipeline> = HashMap::new();
    let trace = |g: &&Given| {
        let d = Design { mode, ..g.design };
        let golden = prepare(&d).unwrap();
        let p = pipelines.entry(d.traverse).or_insert_with(|| Pipeline::new(&d, &Binding::new()).unwrap());
        let run = p.run(&g.pyramid, &g.rays, 16, Traffic::default()).unwrap();
        let hits: Vec<RayHit> = run.results.iter().map(|r| hit(&d, r)).collect();
        assert_eq!(hits.len(), g.rays.len());
        for (k, (got, ray)) in hits.iter().zip(&g.rays).enumerate() {
            assert_eq!(*got, golden.trace(&g.pyramid, ray), "{}, ray {k} {ray:x?} in {mode:?}", g.name);
        }
        hits
    };
    given.iter().map(trace).collect()
}

/// Iterations of the plain walk up to which a ray is traced in every mode and by simulators; of longer ones the first of each case, in a mode a
/// trim.
const SHORT: u32 = 300;
/// Iterations beyond which the golden model alone traces a ray.
const LONG: u32 = 3000;

fn leave_short(g: &mut Given, also: usize) {
    let mode = ModeConfig { start_level: false, levels_down: 1, level_up: LevelUp::None, ..g.design.mode };
    let plain = prepare(&Design { mode, ..g.design }).unwrap();
    let mut k = 0;
    g.rays.retain(|r| {
        k += 1;
        plain.trace(&g.pyramid, r).steps <= if k <= also { LONG } else { SHORT }
    });
}

/// Each mode meets one case of `share`, and each case one mode of so many.
fn every_mode(c: &Config, share: usize) {
    let mut given = cases(c, 5, 9);
    assert!(given.len() >= 38, "{} cases", given.len());
    let all: Vec<ModeConfig> = modes(&c.design()).into_iter().map(|d| d.mode).collect();
    assert_eq!(all.len(), 120);
    given.iter_mut().for_each(|g| leave_short(g, 1));
    given.retain(|g| !g.rays.is_empty());
    let long: Vec<ModeConfig> = all.iter().copied().skip(12).step_by(40).collect();
    assert_eq!(long.len(), 3);
    same_hits(&given, &long, 1);
    given.iter_mut().for_each(|g| leave_short(g, 0));
    given.retain(|g| !g.rays.is_empty());
    assert!(given.len() >= 36, "{} cases", given.len());
    same_hits(&given, &all, share);
}

fn same_hits(given: &[Given], all: &[ModeConfig], share: usize) {
    let plain = in_mode(&given.iter().collect::<Vec<_>>(), all[0]);
    let traced: usize = all[1..]
        .par_iter()
        .enumerate()
        .map(|(m, mode)| {
            // 29 divides no number of choices that a mode has, so that each choice meets each case.
            let turn: Vec<usize> = (0..given.len()).filter(|k| (k + m) % share == 0).collect();
            let hits = in_mode(&turn.iter().map(|k| &given[*k]).collect::<Vec<_>>(), *mode);
            for (k, got) in turn.iter().zip(&hits) {
                let other = got.iter().zip(&plain[*k]).position(|(a, b)| answer(a) != answer(b));
                assert_eq!(other, None, "{}: this ray depends on the mode {mode:?}", given[*k].name);
            }
            hits.iter().map(Vec::len).sum::<usize>()
        })
        .sum();
    let rays: usize = given.iter().map(|g| g.rays.len()).sum();
    assert!(rays > 150, "{rays} rays");
    assert!(traced >= (all.len() - 1) * rays * 9 / 10 / share, "{traced}");
    println!("{} cases, {rays} rays, {} modes: 0 of {traced} hits differ (seed {SEED})", given.len(), all.len());
}

#[test]
fn watertight_in_every_mode() {
    every_mode(&config(&[]), 29);
}

#[test]
fn fixed_point_in_every_mode() {
    every_mode(&config(&["datapath.kind=fixed"]), 29);
}

#[test]
#[ignore = "minutes; part of sh tools/test.sh --full"]
fn every_ray_in_every_mode() {
    every_mode(&config(&[]), 1);
    every_mode(&config(&["datapath.kind=fixed"]), 1);
}

/// The emitted text, one build, on the maps of one size.
fn in_simulator(sim: Simulator, sets: &[&str]) {
    if skip() {
        return;
    }
    let c = config(&[&["traverse.levels=6"][..], sets].concat());
    let mut given = cases(&c, 12, 6);
    given.iter_mut().for_each(|g| leave_short(g, 0));
    let given: Vec<&Given> = given.iter().filter(|g| g.design.traverse == c.traverse && !g.rays.is_empty()).collect();
    assert!(given.len() >= 25, "{} cases", given.len());
    let given: Vec<&Given> = given.into_iter().step_by(budget::share(2)).collect();
    let p = hardware(&c).unwrap();
    let mut files = p.files;
    files.extend(bench_files(&[], Some((&c.design(), &p.traverse)), "relief_"));
    let checked: usize = given
        .par_iter()
        .map(|g| {
            let dir = tempfile::tempdir().unwrap();
            let set = ray_set(&g.design, &g.pyramid, &g.rays, SEED).unwrap();
            let vectors = set_files(&set.set).into_iter().map(|(n, t)| (format!("golden/traverse/{n}"), t));
            let image = ("golden/traverse/memory.hex".to_string(), set.memory);
            write(dir.path(), files.clone().into_iter().chain(vectors).chain([image]));
            // In the memory at power-up: through the load port the map takes longer than the rays.
            let loaded = ["vectors=golden/traverse".to_string(), "preloaded".to_string()];
            let o = run_bench(sim, dir.path(), "traverse", &Binding::new(), &loaded);
            o.unwrap_or_else(|e| panic!("{}: {e}", g.name)).checked
        })
        .sum();
    assert_eq!(checked, given.iter().map(|g| g.rays.len()).sum::<usize>());
    assert!(checked > 9 * given.len(), "{checked} rays");
}

#[test]
fn watertight_in_icarus() {
    in_simulator(Simulator::Icarus, &[]);
}

#[test]
fn fixed_point_with_a_trim_in_icarus() {
    in_simulator(Simulator::Icarus, &["datapath.kind=fixed", "mode.trim=always"]);
}

/// No ray goes round for ever; `reliefrtl hard --endure 10000000` is the whole campaign.
#[test]
fn every_ray_ends() {
    for sets in [&[][..], &["datapath.kind=fixed"]] {
        let c = config(sets);
        let (mut rays, mut given_up) = (0, 0);
        for case in Case::all() {
            let scene = case.scene(&c.design(), 1200, SEED);
            let t = scene.design.traverse;
            let own = Config { traverse: t, ..c.clone() };
            if own.validate().is_err() || t.levels > 10 {
                continue;
            }
            let e = endure(&scene).unwrap();
            assert_eq!((e.rays, e.refused), (1200, 0), "{}", case.name);
            assert!(e.longest.is_some_and(|l| l.steps > 0));
            rays += e.rays;
            given_up += e.given_up;
        }
        println!("{given_up} of {rays} rays end by the step limit (seed {SEED})");
        assert!(rays > 45_000 && given_up == 0, "{given_up} of {rays}");
    }
}

/// The published datapath without its nudge: what the count would say if rays did not end.
#[test]
fn rays_that_never_end_are_counted() {
    let c = config(&["datapath.kind=published", "datapath.nudge_bits=0", "traverse.step_limit=2000"]);
    let e = endure(&Case::find("tiles").unwrap().scene(&c.design(), 400, SEED)).unwrap();
    assert!(e.given_up > 0 && e.witness.is_some(), "{e:?}");
}
