//! The units and the traverse unit of the published datapath in the interpreter, against the golden model.
use super::scenes::{design, hard, modes};
use crate::checked::{Checked, check_all};
use reliefrtl::config::{Design, LevelUp, ModeConfig};
use reliefrtl::format::FloatFormat;
use reliefrtl::golden::prepare;
use reliefrtl::interp::Traffic;
use reliefrtl::ir::Binding;
use reliefrtl::trace::{Pipeline, hit};
use reliefrtl::units::traversal::{loop_resources, traverse};

#[test]
fn units_equal_their_models() {
    let checked = check_all(&design(8), 3000);
    println!("0 of {checked} mismatched (seed 7)");
    assert!(checked > 200_000, "only {checked} rows were checked");
}

#[test]
fn units_equal_their_models_in_every_mode_and_at_every_latency() {
    let mut checked = Checked::default();
    for level_up in LevelUp::ALL {
        for levels_down in 1..=4 {
            let mut d = design(6);
            d.mode = ModeConfig { start_level: levels_down % 2 == 0, levels_down, level_up, ..d.mode };
            d.datapath.nudge_bits = 4 * levels_down - 4;
            (d.latency.add, d.latency.div) = (levels_down - 1, 6 * levels_down);
            checked.units(&d, 200);
        }
    }
    for l in [0, 1, 3, 8] {
        let mut d = design(8);
        let all = &mut d.latency;
        (all.add, all.mul, all.div, all.compare, all.from_int, all.to_int) = (l, l, l, l, l, l);
        checked.units(&d, 200);
    }
}

/// Traces `count` rays in golden model and interpreter under traffic; the number of rays.
fn equal(d: &Design, count: usize, traffic: Traffic) -> usize {
    let (pyramid, rays) = hard(d, count, 3);
    let g = prepare(d).unwrap();
    let p = Pipeline::new(d, &Binding::new()).unwrap();
    let run = p.run(&pyramid, &rays, 16, traffic).unwrap();
    for (k, (r, ray)) in run.results.iter().zip(&rays).enumerate() {
        assert_eq!(hit(d, r), g.trace(&pyramid, ray), "ray {k} {ray:x?} at {d:?}");
    }
    rays.len()
}

#[test]
fn every_mode_equals_golden() {
    let mut total = 0;
    for (seed, mode) in modes().into_iter().enumerate() {
        let d = Design { mode, ..design(5) };
        total += equal(&d, 240, Traffic { gaps: 60, stalls: 90, resets: 2, seed: seed as u64 });
    }
    println!("0 of {total} rays differ in 40 modes (seed 3)");
    assert_eq!(total, 40 * 240);
}

#[test]
fn every_size_and_format_equals_golden() {
    let mut total = 0;
    for format in [FloatFormat::FP24, FloatFormat::new(8, 23), FloatFormat::new(5, 10)] {
        for levels in 2..=12 {
            for nudge in [0, 3, 7] {
                let mut d = Design { format, ..design(levels) };
                d.datapath.nudge_bits = nudge;
                d.traverse.tile_bits = if levels % 2 == 0 { 1 } else { 2 };
                d.traverse.height_bits = if levels % 3 == 0 { 2 } else { 9 };
                d.traverse.step_limit = 60;
                total += equal(&d, if levels > 9 { 32 } else { 96 }, Traffic::default());
            }
        }
    }
    println!("0 of {total} rays differ in 3 formats, 11 sizes, 3 nudges (seed 3)");
}

#[test]
fn other_latencies_and_full_load() {
    for l in [0, 1, 2, 5] {
        let mut d = design(5);
        (d.latency.add, d.latency.mul, d.latency.div, d.latency.decision) = (l, l / 2, 2 * l, 1 + l / 3);
        (d.latency.compare, d.latency.from_int, d.latency.to_int) = (l, l, l);
        let (pyramid, rays) = hard(&d, 240, 8);
        let g = prepare(&d).unwrap();
        let p = Pipeline::new(&d, &Binding::new()).unwrap();
        let run = p.run(&pyramid, &rays, 1, Traffic::default()).unwrap();
        assert!(run.results.iter().zip(&rays).all(|(h, r)| hit(&d, h) == g.trace(&pyramid, r)));
        assert!(run.loaded > 500 && run.busy as f64 / run.loaded as f64 >= 0.98, "{} of {}", run.busy, run.loaded);
        println!("latency {l}: {} slots, busy {} of {}", p.slots, run.busy, run.loaded);
    }
}

#[test]
fn the_loop_is_the_published_one() {
    for mode in modes() {
        let d = Design { mode, ..design(8) };
        let t = traverse(&d);
        let c = loop_resources(&d, &t);
        assert_eq!((c.adders, c.comparators, c.multipliers, c.dividers, c.stages), (6, 7, 5, 2, 15), "{mode:?}");
    }
}
