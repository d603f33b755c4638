//! The emitted Verilog in Icarus and Verilator, at its defaults and at other parameter values.
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use super::{FORMATS, SETS, design, hard};
use crate::budget::share;
use crate::files::write;
use crate::simulators::skip;
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{design_at, ray_set};
use reliefrtl::config::Config;
use reliefrtl::ir::Binding;
use reliefrtl::project::{Scene, check_tree, project};
use reliefrtl::vectors::set_files;
use tempfile::TempDir;

/// With the planned rays of `traverse` over a map of 64 x 64, or with those of the views alone over one of 16 x 16.
fn tree((f, w): (u32, u32), set: &str, planned: bool) -> (Config, TempDir) {
    let d = design(f, w, set);
    let mut c = Config { datapath: d.datapath, windows: d.windows, ..Config::default() };
    c.vectors.planned = planned;
    c.traverse.levels = if planned { 6 } else { 4 };
    c.vectors.arithmetic = 400;
    c.vectors.rays = 40;
    c.validate().unwrap();
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), &project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files);
    (c, dir)
}

/// Of one in so many sets.
fn all_units(sim: Simulator, sets: &[usize], step: usize) {
    for &k in sets.iter().step_by(step) {
        let format = FORMATS[k % FORMATS.len()];
        let (c, dir) = tree(format, SETS[k], k == 0 && sim == Simulator::Verilator);
        let done = check_tree(&c, dir.path(), sim.into(), &[], None, None, &|_| ()).unwrap();
        assert!(done.len() >= 19 && done.iter().all(|x| x.rows > 0));
        let rows: usize = done.iter().map(|x| x.rows).sum();
        println!("{} Q.{}/{} {}: 0 of {rows} mismatched", sim.name(), format.0, format.1, SETS[k]);
    }
}

#[test]
fn every_unit_in_icarus() {
    if !skip() {
        all_units(Simulator::Icarus, &[0, 1, 2, 3, 4], share(2));
    }
}

#[test]
fn every_unit_in_verilator() {
    if !skip() {
        all_units(Simulator::Verilator, &[0, 2], share(2));
    }
}

/// `traverse` at other sizes: the emitted text stays, the simulator gets the parameters. f, w, levels, height bits.
fn traverse_at(sim: Simulator, sizes: &[(u32, u32, u32, u32)], plusargs: &[&str]) {
    let (c, dir) = tree((24, 24), "1 4@2 8@4", false);
    for (f, w, levels, height) in sizes {
        let values = [("FRACTION_W", f), ("RECIP_W", w), ("LEVELS", levels), ("HEIGHT_W", height)];
        let over: Binding = values.iter().map(|(k, v)| (k.to_string(), i64::from(**v))).collect();
        let d = design_at(&c.design(), &over);
        let (pyramid, rays) = hard(&d, 150, u64::from(*levels));
        let set = ray_set(&d, &pyramid, &rays, 1).unwrap();
        let place = tempfile::tempdir().unwrap();
        let mut files = set_files(&set.set);
        files.extend(set.memory_files().map(|(name, text)| (name, text.clone())));
        write(place.path(), &files);
        let mut args = vec![format!("vectors={}", place.path().display())];
        args.extend(plusargs.iter().map(|s| s.to_string()));
        let o = run_bench(sim, dir.path(), "traverse", &over, &args).unwrap_or_else(|e| panic!("{over:?}: {e}"));
        assert_eq!(o.checked, rays.len());
    }
}

#[test]
fn traverse_at_other_sizes_in_both_simulators() {
    if !skip() {
        traverse_at(Simulator::Icarus, &[(24, 24, 2, 8), (28, 31, 6, 16)], &["gaps", "stalls", "flood"]);
        traverse_at(Simulator::Verilator, &[(20, 24, 5, 8)], &[]);
        traverse_at(Simulator::Verilator, &[(20, 20, 5, 16)], &["preloaded"]);
    }
}
