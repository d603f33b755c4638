//! The emitted Verilog in Icarus and Verilator, at its defaults and at other parameter values; traffic; canaries.
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use crate::budget::share;
use crate::files::write;
use crate::simulators::skip;
use rand::{Rng, SeedableRng};
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{bindings, design_at, find, ray_set, vector_set};
use reliefrtl::config::Config;
use reliefrtl::engine::EngineName;
use reliefrtl::golden::{Pyramid, RayInput};
use reliefrtl::ir::Binding;
use reliefrtl::project::{Canary, Scene, check_tree, project};
use reliefrtl::vectors::{Plan, set_files};
use std::path::PathBuf;
use tempfile::TempDir;

/// The default design over a map of 64 x 64, whose words Icarus loads in a second; or over one of 16 x 16, with the rays of the views alone.
fn tree(planned: bool) -> (Config, TempDir) {
    let mut c = Config::default();
    c.traverse.levels = if planned { 6 } else { 4 };
    c.vectors.planned = planned;
    c.vectors.arithmetic = 300;
    c.vectors.rays = 30;
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), &project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files);
    (c, dir)
}

fn all_units(sim: Simulator) {
    // The planned rays take Icarus long; of the few others it is not said how busy they keep the loop.
    let planned = sim == Simulator::Verilator;
    let (c, dir) = tree(planned);
    let done = check_tree(&c, dir.path(), sim.into(), &[], None, None, &|_| ()).unwrap();
    assert_eq!(done.len(), 27);
    assert!(done.iter().all(|x| x.rows > 0));
    let interp = check_tree(&c, dir.path(), EngineName::Interp, &["traverse".into()], None, None, &|_| ()).unwrap();
    // Of very short rays the bench does not have the next one on its port in every clock (seen: 90 % busy); the interpreter does.
    for (note, least) in [(&done[26].note, 0.85), (&interp[0].note, 0.98)].into_iter().filter(|_| planned) {
        let load = note.split(';').next().unwrap();
        let words: Vec<f64> = load.split_whitespace().filter_map(|w| w.parse().ok()).collect();
        assert!(words.len() == 2 && words[1] > 1000.0 && words[0] / words[1] >= least, "{}: {load}", sim.name());
    }
    println!("{}: 0 of {} mismatched", sim.name(), done.iter().map(|x| x.rows).sum::<usize>());
}

#[test]
fn every_unit_in_icarus() {
    if !skip() {
        all_units(Simulator::Icarus);
    }
}

#[test]
fn every_unit_in_verilator() {
    if !skip() {
        all_units(Simulator::Verilator);
    }
}

/// The same emitted text with other parameter values given to the simulator.
fn reparameterized(sim: Simulator, units: &[&str]) {
    let (c, dir) = tree(false);
    let d = c.design();
    let mut runs = 0;
    for name in units {
        let m = find(&d, name).unwrap();
        // In the usual run Icarus gets some of them, each unit its first.
        let step = if sim == Simulator::Icarus { share(2) } else { 1 };
        for b in bindings(&d, &m).into_iter().step_by(step) {
            let set = vector_set(&d, &m, &b, Plan { rows: 400, seed: 3 });
            let place = tempfile::tempdir().unwrap();
            write(place.path(), &set_files(&set));
            let vectors = [format!("vectors={}", place.path().display())];
            let o = run_bench(sim, dir.path(), name, &set.params, &vectors)
                .unwrap_or_else(|e| panic!("{name} at {b:?}: {e}"));
            assert_eq!(o.checked, set.stimulus.len());
            runs += 1;
        }
    }
    assert!(runs >= units.len());
}

#[test]
fn other_parameters_in_icarus() {
    if !skip() {
        let all = reliefrtl::catalogue::units(&Config::default().design());
        let names: Vec<&str> = all.iter().map(|m| m.name.as_str()).collect();
        reparameterized(Simulator::Icarus, &names);
    }
}

#[test]
fn other_parameters_in_verilator() {
    if !skip() {
        reparameterized(Simulator::Verilator, &["fp_add", "fp_mul", "fp_div", "fp_lt"]);
    }
}

/// `traverse` at other sizes: the emitted text stays, the simulator gets LEVELS and HEIGHT_W.
fn traverse_at(sim: Simulator, sizes: &[(u32, u32)], plusargs: &[&str]) {
    let (c, dir) = tree(false);
    for (levels, height) in sizes {
        let over = Binding::from([("LEVELS".into(), i64::from(*levels)), ("HEIGHT_W".into(), i64::from(*height))]);
        let d = design_at(&c.design(), &over);
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(u64::from(*levels));
        let top = (1u32 << height) - 1;
        let texels: Vec<u32> =
            (0..1usize << (2 * levels)).map(|_| rng.random_range(0..=top) >> rng.random_range(0..4)).collect();
        let pyramid = Pyramid::build(*levels, *height, &texels).unwrap();
        let rays: Vec<RayInput> = (0..150)
            .map(|_| {
                let mut d1 = || (rng.random::<f64>() - 0.5) * if rng.random::<bool>() { 0.3 } else { 6.0 };
                let (du, dv) = (d1(), d1());
                RayInput::from_f64(d.format, rng.random_range(0.0..0.99), rng.random_range(0.0..0.99), du, dv)
            })
            .collect();
        let set = ray_set(&d, &pyramid, &rays, 1).unwrap();
        let place = tempfile::tempdir().unwrap();
        let mut files = set_files(&set.set);
        files.insert("memory.hex".into(), set.memory);
        write(place.path(), &files);
        let mut args = vec![format!("vectors={}", place.path().display())];
        args.extend(plusargs.iter().map(|s| s.to_string()));
        let o = run_bench(sim, dir.path(), "traverse", &over, &args)
            .unwrap_or_else(|e| panic!("{levels} levels, {height} bits: {e}"));
        assert_eq!(o.checked, rays.len());
    }
}

#[test]
fn traverse_at_2_to_12_levels_in_verilator() {
    if !skip() {
        let sizes: Vec<(u32, u32)> =
            (2..=9).step_by(share(3)).map(|l| (l, if l % 2 == 0 { 8 } else { 16 })).chain([(2, 16)]).collect();
        traverse_at(Simulator::Verilator, &sizes, &[]);
        let large = [(10, 8), (12, 8), (12, 16)];
        traverse_at(Simulator::Verilator, &large[share(3).min(large.len()) - 1..], &["preloaded"]);
    }
}

#[test]
#[ignore = "tens of millions of words through the load port; part of sh tools/test.sh --full"]
fn the_largest_maps_go_through_the_load_port() {
    if !skip() {
        traverse_at(Simulator::Verilator, &[(10, 8), (12, 8), (12, 16)], &[]);
    }
}

#[test]
fn traverse_at_other_sizes_in_icarus() {
    if !skip() {
        traverse_at(Simulator::Icarus, &[(2, 8), (3, 16), (5, 8), (6, 16)], &[]);
    }
}

#[test]
fn traffic_loses_and_repeats_nothing() {
    if !skip() {
        let all = [&["again"][..], &["gaps"], &["gaps", "stalls", "flood", "reset"], &["stalls"]];
        for sim in [Simulator::Icarus, Simulator::Verilator] {
            all.iter().step_by(share(2)).for_each(|traffic| traverse_at(sim, &[(4, 8)], traffic));
        }
    }
}

#[test]
fn canaries_are_noticed() {
    let (c, dir) = tree(false);
    let all = [EngineName::Interp, EngineName::Icarus, EngineName::Verilator];
    let engines = if skip() { &all[..1] } else { &all };
    for engine in engines {
        for (canary, code) in [(Canary::Flip, 1), (Canary::Drop, 6), (Canary::Extra, 7), (Canary::Empty, 5)] {
            for unit in ["fp_lt", "traverse"] {
                let e =
                    check_tree(&c, dir.path(), *engine, &[unit.to_string()], Some(canary), None, &|_| ()).unwrap_err();
                assert_eq!(e.exit_code(), code, "{engine:?} {canary:?} {unit}: {e}");
            }
        }
    }
}

#[test]
fn a_missing_simulator_is_named() {
    let dir: PathBuf = tree(false).1.keep();
    let out = std::process::Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
        .args(["check", "--set", "traverse.levels=4", "--engine", "verilator", "--unit", "fp_lt", "--dir"])
        .arg(&dir)
        .env("VERILATOR", "no-such-program")
        .output()
        .unwrap();
    assert_eq!(out.status.code(), Some(3));
    let text = String::from_utf8_lossy(&out.stderr).into_owned();
    assert!(text.contains("no-such-program is not installed"), "{text}");
    std::fs::remove_dir_all(dir).unwrap();
}
