//! Every unit in the interpreter against the golden model.
use super::{FORMATS, design};
use crate::checked::{Checked, check_all};
use reliefrtl::catalogue::{check_interp, units, vector_set};
use reliefrtl::config::{LevelUp, ModeConfig, Trim};
use reliefrtl::ir::Binding;
use reliefrtl::vectors::Plan;

#[test]
fn units_equal_their_models() {
    for (f, w) in FORMATS {
        let checked = check_all(&design(f, w), 4000);
        println!("Q.{f}/{w}: 0 of {checked} mismatched (seed 7)");
        assert!(checked > 150_000, "only {checked} rows were checked");
    }
}

#[test]
fn units_equal_their_models_in_every_mode_and_at_every_latency() {
    let mut checked = Checked::default();
    for (k, level_up) in LevelUp::ALL.into_iter().enumerate() {
        for levels_down in 1..=4 {
            let mut d = design(24, 24);
            d.mode = ModeConfig { start_level: levels_down % 2 == 0, levels_down, level_up, ..ModeConfig::default() };
            let l = [0, 1, 2, 3, 5, 8, 16][(5 * levels_down as usize + k) % 7];
            (d.latency.add, d.latency.mul, d.latency.div, d.latency.compare) = (l, l, 2 * l, l);
            checked.units(&d, 200);
        }
    }
}

/// Chord trim and level of detail bring units and ports of their own.
#[test]
fn units_of_trim_and_detail_equal_their_models() {
    for (k, (trim, lod)) in [(Trim::Descent, false), (Trim::Always, true), (Trim::None, true)].into_iter().enumerate() {
        for (f, w) in FORMATS {
            let mut d = design(f, w);
            (d.mode.trim, d.mode.lod, d.mode.start_level) = (trim, lod, k != 2);
            (d.latency.add, d.latency.mul) = ([2, 0, 5][k], [1, 3, 0][k]);
            let names: Vec<String> = units(&d).iter().map(|m| m.name.clone()).collect();
            for name in ["chord_end", "chord_trim", "trim_return"] {
                assert_eq!(names.iter().any(|n| n == name), trim != Trim::None, "{name}");
            }
            for name in ["finest_level", "node_hit"] {
                assert_eq!(names.iter().any(|n| n == name), lod, "{name}");
            }
            let checked = check_all(&d, 4000);
            println!("Q.{f}/{w}, trim {trim:?}, detail {lod}: 0 of {checked} mismatched (seed 7)");
            assert!(checked > 150_000, "only {checked} rows were checked");
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
