//! Every unit in the interpreter against the golden model, at its defaults and at other parameter values.
use crate::checked::{Checked, check_all};
use reliefrtl::catalogue::{check_interp, units, vector_set};
use reliefrtl::config::{Design, ExtraUnit, ExtraUnits, LatencyConfig, LevelUp, ModeConfig, Trim};
use reliefrtl::format::FloatFormat;
use reliefrtl::ir::Binding;
use reliefrtl::vectors::Plan;

#[test]
fn units_equal_their_models() {
    let checked = check_all(&Design::default(), 4000);
    println!("0 of {checked} mismatched (seed 7)");
    assert!(checked > 200_000, "only {checked} rows were checked");
}

#[test]
fn units_equal_their_models_in_every_mode() {
    let mut checked = Checked::default();
    for level_up in LevelUp::ALL {
        for levels_down in 1..=4 {
            let mut d = Design {
                mode: ModeConfig { start_level: levels_down % 2 == 0, levels_down, level_up, ..ModeConfig::default() },
                ..Design::default()
            };
            d.latency.add = levels_down;
            d.latency.div = 6 * levels_down;
            checked.units(&d, 300);
        }
    }
}

/// The units that a trim and a level of detail add or change, by every rule that they depend on.
#[test]
fn units_of_trim_and_detail_equal_their_models() {
    let mut checked = Checked::default();
    for trim in Trim::ALL {
        for lod in [false, true] {
            for level_up in LevelUp::ALL {
                let mode = ModeConfig { start_level: !lod, level_up, trim, lod, ..ModeConfig::default() };
                let d = Design { mode, ..Design::default() };
                checked.units(&d, 400);
            }
        }
    }
}

/// The units of the bilinear refinement, at clocks from none to many.
#[test]
fn units_of_the_refinement_equal_their_models() {
    let mut d = Design { mode: ModeConfig { bilinear: true, ..ModeConfig::default() }, ..Design::default() };
    let of = |d: &Design| units(d).iter().map(|m| m.name.clone()).collect::<Vec<_>>();
    let added = of(&d).len() - of(&Design::default()).len();
    assert_eq!(added, 6, "{:?}", of(&d));
    let checked = check_all(&d, 2000);
    assert!(checked > 100_000, "{checked}");
    for l in [0, 1, 3, 7] {
        (d.latency.add, d.latency.mul, d.latency.div, d.latency.compare) = (l, l, 2 * l, l);
        (d.latency.from_int, d.latency.to_int) = (l, l);
        check_all(&d, 200);
    }
}

#[test]
fn latency_changes_no_result() {
    for l in [0, 1, 2, 3, 5, 8, 20] {
        let mut d = Design::default();
        d.latency.add = l;
        d.latency.mul = l;
        d.latency.div = l;
        d.latency.compare = l;
        d.latency.from_int = l;
        d.latency.to_int = l;
        check_all(&d, 200);
    }
}

/// What comes only where it is asked for.
#[test]
fn units_besides_the_traversal_equal_their_models() {
    let mut d = Design { extra: ExtraUnits::ALL, ..Design::default() };
    let extra: Vec<String> = units(&d).into_iter().map(|m| m.name.clone()).collect();
    let plain: Vec<String> = units(&Design::default()).into_iter().map(|m| m.name.clone()).collect();
    let more: Vec<&str> = extra.iter().filter(|n| !plain.contains(n)).map(String::as_str).collect();
    assert!(ExtraUnit::WORDS.iter().all(|n| more.contains(n)), "{more:?}");
    for l in [0, 1, 2, 4, 7, 11, 16] {
        let div = 2 * l;
        d.latency = LatencyConfig { sqrt: div, add3: l, compare: l, div, ..d.latency };
        check_all(&d, 300);
    }
}

#[test]
fn small_floats_exhaustively() {
    // A divider of no more stages than the format has digits.
    let mut usual = Design::default();
    usual.latency.div = 2;
    let d = Design { format: FloatFormat::new(4, 3), ..usual };
    for name in ["fp_add", "fp_mul", "fp_div", "fp_lt"] {
        let m = reliefrtl::catalogue::find(&usual, name).unwrap();
        let b = Binding::from([("EXP_W".into(), 4), ("MAN_W".into(), 3)]);
        let set = vector_set(&d, &m, &b, Plan { rows: 1, seed: 1 });
        let report = check_interp(&m, &set).unwrap_or_else(|e| panic!("{}: {e} (at {b:?})", m.name));
        assert_eq!(report.checked, 1 << 16, "{name}: all pairs");
        report.verdict(&set, &m).unwrap();
    }
}
