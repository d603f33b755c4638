//! The emitted Verilog in Icarus and Verilator, at its defaults and at other parameter values.
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use super::{FORMATS, design, hard};
use crate::budget::share;
use crate::files::write;
use crate::simulators::skip;
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{design_at, ray_set};
use reliefrtl::config::{Config, LevelUp, ModeConfig, Trim};
use reliefrtl::ir::Binding;
use reliefrtl::project::{Scene, check_tree, project};
use reliefrtl::vectors::set_files;
use tempfile::TempDir;

/// With the planned rays of `traverse` over a map of 64 x 64, or with those of the views alone over one of 16 x 16.
fn tree(f: u32, w: u32, mode: ModeConfig, planned: bool) -> (Config, TempDir) {
    let mut c = Config { datapath: design(f, w).datapath, mode, ..Config::default() };
    c.vectors.planned = planned;
    c.traverse.levels = if planned { 6 } else { 4 };
    c.vectors.arithmetic = 600;
    c.vectors.rays = 60;
    c.validate().unwrap();
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), &project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files);
    (c, dir)
}

fn all_units(sim: Simulator, formats: &[(u32, u32)], mode: ModeConfig, count: usize) {
    for (k, &(f, w)) in formats.iter().enumerate() {
        // The planned rays take Icarus long.
        let (c, dir) = tree(f, w, mode, k == 0 && sim == Simulator::Verilator);
        let done = check_tree(&c, dir.path(), sim.into(), &[], None, None, &|_| ()).unwrap();
        assert_eq!(done.len(), count);
        assert!(done.iter().all(|x| x.rows > 0));
        let rows: usize = done.iter().map(|x| x.rows).sum();
        println!("{} Q.{f}/{w}: 0 of {rows} mismatched", sim.name());
    }
}

#[test]
fn every_unit_in_icarus() {
    if !skip() {
        let some: Vec<(u32, u32)> = FORMATS.into_iter().step_by(share(2)).collect();
        all_units(Simulator::Icarus, &some, ModeConfig::default(), 19);
    }
}

/// With the units that a trim and a level of detail bring.
#[test]
fn every_unit_of_a_trim_in_both_simulators() {
    if !skip() {
        all_units(
            Simulator::Icarus,
            &FORMATS[1..][..if share(2) == 1 { FORMATS.len() - 1 } else { 1 }],
            trimmed(Trim::Always),
            24,
        );
        all_units(Simulator::Verilator, &FORMATS[..1], trimmed(Trim::Descent), 24);
    }
}

#[test]
fn every_unit_in_verilator() {
    if !skip() {
        all_units(Simulator::Verilator, &FORMATS[..1], ModeConfig::default(), 19);
    }
}

/// `traverse` at other sizes: the emitted text stays, the simulator gets the parameters. f, w, levels, height bits.
fn traverse_at(sim: Simulator, mode: ModeConfig, sizes: &[(u32, u32, u32, u32)], plusargs: &[&str]) {
    let (c, dir) = tree(24, 24, mode, false);
    for (f, w, levels, height) in sizes {
        let values = [("FRACTION_W", f), ("RECIP_W", w), ("LEVELS", levels), ("HEIGHT_W", height)];
        let over: Binding = values.iter().map(|(k, v)| (k.to_string(), i64::from(**v))).collect();
        let d = design_at(&c.design(), &over);
        let (pyramid, mut rays) = hard(&d, 150, u64::from(*levels));
        if mode.lod {
            // At most what in_lod holds, whatever the level count of the emitted text.
            rays.iter_mut().enumerate().for_each(|(k, r)| r.lod = (k as u32 / 2) % (levels + 1));
        }
        let set = ray_set(&d, &pyramid, &rays, 1).unwrap();
        let place = tempfile::tempdir().unwrap();
        let mut files = set_files(&set.set);
        files.insert("memory.hex".into(), set.memory);
        write(place.path(), &files);
        let mut args = vec![format!("vectors={}", place.path().display())];
        args.extend(plusargs.iter().map(|s| s.to_string()));
        let o = run_bench(sim, dir.path(), "traverse", &over, &args).unwrap_or_else(|e| panic!("{over:?}: {e}"));
        assert_eq!(o.checked, rays.len());
    }
}

#[test]
fn traverse_at_2_to_12_levels_in_verilator() {
    if !skip() {
        let sizes = [(24, 24, 2, 16), (20, 18, 5, 16), (20, 18, 6, 8), (12, 10, 3, 8), (28, 31, 7, 16), (8, 8, 8, 8)];
        traverse_at(Simulator::Verilator, ModeConfig::default(), &sizes, &[]);
        traverse_at(Simulator::Verilator, ModeConfig::default(), &LARGEST, &["preloaded"]);
    }
}

const LARGEST: [(u32, u32, u32, u32); 3] = [(24, 24, 11, 8), (24, 18, 12, 16), (12, 10, 12, 8)];

#[test]
#[ignore = "tens of millions of words through the load port; part of sh tools/test.sh --full"]
fn the_largest_maps_go_through_the_load_port() {
    if !skip() {
        traverse_at(Simulator::Verilator, ModeConfig::default(), &LARGEST, &[]);
    }
}

#[test]
fn traverse_at_other_sizes_in_icarus() {
    if !skip() {
        let mode = ModeConfig::default();
        traverse_at(Simulator::Icarus, mode, &[(24, 24, 2, 8), (20, 18, 3, 16), (12, 10, 5, 8), (28, 31, 6, 16)], &[]);
        traverse_at(Simulator::Icarus, mode, &[(24, 24, 4, 8)], &["gaps", "stalls", "flood"]);
    }
}

fn trimmed(trim: Trim) -> ModeConfig {
    ModeConfig { trim, lod: true, ..ModeConfig::default() }
}

#[test]
fn trims_at_other_sizes_in_both_simulators() {
    if !skip() {
        traverse_at(Simulator::Icarus, trimmed(Trim::Always), &[(20, 18, 3, 16), (8, 8, 8, 8)], &["gaps", "stalls"]);
        let coherent = ModeConfig { level_up: LevelUp::Coherent, start_level: false, ..trimmed(Trim::Descent) };
        traverse_at(Simulator::Icarus, coherent, &[(24, 24, 5, 8)], &[]);
        traverse_at(Simulator::Verilator, trimmed(Trim::Always), &[(12, 10, 7, 8), (28, 31, 5, 16)], &[]);
    }
}
