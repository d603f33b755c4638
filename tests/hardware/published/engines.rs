//! The emitted Verilog of the published datapath in Icarus and Verilator, and `trace` by all four engines.
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use super::scenes::{hard, modes};
use crate::budget::share;
use crate::files::write;
use crate::simulators::skip;
use reliefrtl::bench::{Simulator, bench_files, run_bench};
use reliefrtl::catalogue::{bindings, design_at, find, ray_set, vector_set};
use reliefrtl::config::{Config, DatapathKind, ModeConfig, Profile};
use reliefrtl::engine::EngineName;
use reliefrtl::ir::Binding;
use reliefrtl::project::{Scene, check_tree, hardware, project};
use reliefrtl::vectors::{Plan, set_files};
use tempfile::TempDir;

fn config(sets: &[&str]) -> Config {
    let mut c = Config::default();
    c.datapath.kind = DatapathKind::Published;
    c.latency = Profile::Published.latency(c.datapath.kind);
    c.traverse.step_limit = 300;
    (c.vectors.arithmetic, c.vectors.rays, c.view.stride) = (250, 30, 16);
    c.vectors.planned = false;
    c.traverse.levels = 4;
    sets.iter().for_each(|s| c.apply_set(s).unwrap());
    c.validate().unwrap();
    c
}

fn tree(c: &Config) -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), &project(c, &Scene::new(c, None, false).unwrap()).unwrap().files);
    dir
}

/// Three formats, with and without what modes add.
const CONFIGS: [&[&str]; 3] = [
    &[],
    &["format.exp=8", "format.man=23", "mode.level_up=coherent", "mode.levels_down=3", "datapath.nudge_bits=12"],
    &["format.exp=5", "format.man=10", "traverse.tile_bits=2", "mode.start_level=false"],
];

fn all_units(sim: Simulator, configs: &[&[&str]]) {
    for sets in configs.iter().step_by(share(3)) {
        let mut c = config(sets);
        // The planned rays take Icarus a minute.
        c.vectors.planned = sets.is_empty() && sim == Simulator::Verilator;
        let dir = tree(&c);
        let done = check_tree(&c, dir.path(), sim.into(), &[], None, None, &|_| ()).unwrap();
        assert!(done.len() >= 23 && done.iter().all(|x| x.rows > 0));
        let interp = check_tree(&c, dir.path(), EngineName::Interp, &["traverse".into()], None, None, &|_| ()).unwrap();
        let busy = |note: &str| note.split(';').next().unwrap().to_string();
        let words: Vec<f64> =
            busy(&done.last().unwrap().note).split_whitespace().filter_map(|w| w.parse().ok()).collect();
        assert!(words.len() == 2 && words[0] / words[1] >= 0.98, "{words:?}");
        let rows: usize = done.iter().map(|x| x.rows).sum();
        println!("{} {sets:?}: 0 of {rows} mismatched, slots busy {words:?}; interp: {}", sim.name(), interp[0].note);
    }
}

#[test]
fn every_unit_in_icarus() {
    if !skip() {
        all_units(Simulator::Icarus, &CONFIGS);
    }
}

#[test]
fn every_unit_in_verilator() {
    if !skip() {
        all_units(Simulator::Verilator, &CONFIGS[..1]);
    }
}

#[test]
fn other_parameters_in_icarus() {
    if skip() {
        return;
    }
    let c = config(&[]);
    let (d, dir) = (c.design(), tree(&c));
    let own = ["exit_plane", "boundary_time", "surface_time", "nearer_plane", "ray_point", "crossing_test"];
    let mut runs = 0;
    for name in own.into_iter().chain(["descent_level", "level_choice", "ray_scale", "texel_fraction"]) {
        let m = find(&d, name).unwrap();
        for b in bindings(&d, &m) {
            let set = vector_set(&d, &m, &b, Plan { rows: 300, seed: 3 });
            let place = tempfile::tempdir().unwrap();
            write(place.path(), &set_files(&set));
            let vectors = [format!("vectors={}", place.path().display())];
            let o = run_bench(Simulator::Icarus, dir.path(), name, &set.params, &vectors)
                .unwrap_or_else(|e| panic!("{name} at {b:?}: {e}"));
            assert_eq!(o.checked, set.stimulus.len());
            runs += 1;
        }
    }
    assert!(runs > 20, "{runs} runs");
}

/// One emitted text at other sizes and nudges.
fn traverse_at(sim: Simulator, sizes: &[(u32, u32, u32)], plusargs: &[&str]) {
    let c = config(&[]);
    let dir = tree(&c);
    for (levels, height, nudge) in sizes {
        let over: Binding = [("LEVELS", *levels), ("HEIGHT_W", *height), ("NUDGE_W", *nudge)]
            .map(|(n, v)| (n.to_string(), i64::from(v)))
            .into();
        let d = design_at(&c.design(), &over);
        let (pyramid, rays) = hard(&d, 160, 1);
        let set = ray_set(&d, &pyramid, &rays, 1).unwrap();
        let place = tempfile::tempdir().unwrap();
        let mut files = set_files(&set.set);
        files.insert("memory.hex".into(), set.memory);
        write(place.path(), &files);
        let mut args = vec![format!("vectors={}", place.path().display())];
        args.extend(plusargs.iter().map(|s| s.to_string()));
        let o = run_bench(sim, dir.path(), "traverse", &over, &args)
            .unwrap_or_else(|e| panic!("{levels} levels, {height} bits, nudge {nudge}: {e}"));
        assert_eq!(o.checked, rays.len());
    }
}

#[test]
fn traverse_at_other_sizes_in_verilator() {
    if !skip() {
        traverse_at(Simulator::Verilator, &[(2, 8, 12), (5, 16, 9), (8, 8, 6)], &[]);
        traverse_at(Simulator::Verilator, &[(11, 16, 3), (12, 8, 2)], &["preloaded"]);
    }
}

#[test]
fn traffic_in_icarus() {
    if !skip() {
        for traffic in [&["gaps"][..], &["stalls"], &["gaps", "stalls", "flood"]] {
            traverse_at(Simulator::Icarus, &[(4, 8, 7)], traffic);
        }
    }
}

#[test]
fn traverse_at_2_to_7_levels_in_icarus() {
    if !skip() {
        let sizes: Vec<(u32, u32, u32)> =
            (2..=7).step_by(share(2)).map(|l| (l, if l % 2 == 0 { 8 } else { 16 }, 14 - l)).collect();
        traverse_at(Simulator::Icarus, &sizes, &[]);
    }
}

/// Rays of each mode: one of each kind of `hard`, with the long one.
const RAYS: usize = 24;

/// Rays through the Verilog of one mode; how many.
fn in_mode(sim: Simulator, mode: ModeConfig) -> usize {
    let mut c = config(&["traverse.levels=4"]);
    c.mode = mode;
    let d = c.design();
    let mut p = hardware(&c).unwrap();
    p.files.extend(bench_files(&[], Some((&d, &p.traverse)), "relief_"));
    let (pyramid, rays) = hard(&d, RAYS, 2);
    let set = ray_set(&d, &pyramid, &rays, 1).unwrap();
    let mut files = set_files(&set.set);
    files.insert("memory.hex".into(), set.memory);
    p.files.extend(files.into_iter().map(|(n, text)| (format!("golden/traverse/{n}"), text)));
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), &p.files);
    run_bench(sim, dir.path(), "traverse", &Binding::new(), &[]).unwrap_or_else(|e| panic!("{mode:?}: {e}")).checked
}

#[test]
fn every_mode_in_icarus() {
    if !skip() {
        // 7 divides no number of choices that a mode has.
        let some: Vec<ModeConfig> = modes().into_iter().step_by(share(7)).collect();
        let checked: usize = some.iter().map(|m| in_mode(Simulator::Icarus, *m)).sum();
        println!("icarus: 0 of {checked} rays mismatched in {} modes (seed 2)", some.len());
        assert_eq!(checked, some.len() * RAYS);
    }
}

/// Every level-up rule, with every number of levels down, with and without a start level.
#[test]
fn every_rule_in_verilator() {
    if !skip() {
        let some = modes().into_iter().step_by(7);
        let checked: Vec<usize> = some.map(|m| in_mode(Simulator::Verilator, m)).collect();
        println!(
            "verilator: 0 of {} rays mismatched in {} modes (seed 2)",
            checked.iter().sum::<usize>(),
            checked.len()
        );
    }
}

#[test]
fn engines_write_the_same_bytes() {
    let dir = tempfile::tempdir().unwrap();
    let rays = "u,v,du,dv\n0.1,0.2,0.3,-0.4\n0.99999999,0.5,-1.5,0.25\n0.5,0.5,0,0\n0.3,0.3,20,0\n0.25,0.75,-2,-2\n";
    std::fs::write(dir.path().join("r.csv"), rays).unwrap();
    let engines: &[&str] = if skip() { &["golden", "interp"] } else { &["golden", "interp", "icarus", "verilator"] };
    let sets = ["--set", "datapath.kind=published", "--set", "traverse.step_limit=300", "--set", "traverse.levels=6"];
    let hits = |engine: &str| {
        let out = std::process::Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
            .args(["trace", "--rays", "r.csv", "--engine", engine, "--out", "h.csv"])
            .args(sets)
            .current_dir(dir.path())
            .output()
            .unwrap();
        assert_eq!(out.status.code(), Some(0), "{engine}: {}", String::from_utf8_lossy(&out.stderr));
        std::fs::read_to_string(dir.path().join("h.csv")).unwrap()
    };
    let all: Vec<String> = engines.iter().map(|e| hits(e)).collect();
    assert!(all.iter().all(|h| h == &all[0]));
    assert_eq!(all[0].lines().count(), 6);
}
