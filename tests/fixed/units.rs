//! Every unit in the interpreter against the golden model.
use super::{FORMATS, design};
use reliefrtl::catalogue::{bindings, check_interp, units, vector_set};
use reliefrtl::config::{Design, LevelUp, ModeConfig, Trim};
use reliefrtl::ir::Binding;
use reliefrtl::vectors::Plan;

fn check_all(d: &Design, rows: usize) -> usize {
    let mut checked = 0;
    for m in units(d) {
        for b in std::iter::once(Binding::new()).chain(bindings(&m)) {
            let set = vector_set(d, &m, &b, Plan { rows, seed: 7 });
            let report = check_interp(&m, &set).unwrap();
            assert!(report.checked > 0, "{}", m.name);
            report.verdict(&set, &m).unwrap_or_else(|e| panic!("{e} (at {b:?})"));
            checked += report.checked;
        }
    }
    checked
}

#[test]
fn units_equal_their_models() {
    for (f, w) in FORMATS {
        let mut checked = check_all(&design(f, w), 4000);
        let mut d = design(f, w);
        (d.mode.trim, d.mode.lod) = (Trim::Always, true);
        checked += check_all(&d, 1000);
        println!("Q.{f}/{w}: 0 of {checked} mismatched (seed 7)");
        assert!(checked > 150_000, "only {checked} rows were checked");
    }
}

#[test]
fn units_equal_their_models_in_every_mode_and_at_every_latency() {
    for (k, level_up) in LevelUp::ALL.into_iter().enumerate() {
        for levels_down in 1..=4 {
            let mut d = design(24, 24);
            let (trim, lod) = (Trim::ALL[(levels_down as usize + k) % 3], levels_down > 2);
            d.mode = ModeConfig { start_level: levels_down % 2 == 0, levels_down, level_up, trim, lod };
            let l = [0, 1, 2, 3, 5, 8, 16][(5 * levels_down as usize + k) % 7];
            (d.latency.add, d.latency.mul, d.latency.div, d.latency.compare) = (l, l, 2 * l, l);
            check_all(&d, 200);
        }
    }
}

#[test]
fn small_numbers_exhaustively() {
    let d = design(8, 8);
    for (name, params) in [("reciprocal", &[("TILE_W", 8), ("HEIGHT_W", 8)][..]), ("reciprocal", &[("HEIGHT_W", 2)])] {
        let m = reliefrtl::catalogue::find(&d, name).unwrap();
        let b: Binding = params.iter().map(|(k, v)| (k.to_string(), *v)).collect();
        let set = vector_set(&d, &m, &b, Plan { rows: 1, seed: 1 });
        let report = check_interp(&m, &set).unwrap();
        let width = 8 + b.get("TILE_W").copied().unwrap_or(4);
        assert_eq!(report.checked, 1 << width, "{name}: every travel");
        report.verdict(&set, &m).unwrap();
    }
}
