//! The traverse unit in the interpreter equals the golden model ray by ray, in every mode; all modes hit alike.
use super::{FORMATS, design, hard};
use reliefrtl::catalogue::design_at;
use reliefrtl::config::{Design, LevelUp, ModeConfig, Trim};
use reliefrtl::golden::{Pyramid, RayHit, RayInput, prepare};
use reliefrtl::interp::Traffic;
use reliefrtl::ir::Binding;
use reliefrtl::trace::{Pipeline, diagnose, hit};

#[test]
fn every_mode_equals_golden_and_hits_alike() {
    let mut d = design(24, 24);
    d.traverse.levels = 5;
    let (pyramid, rays) = hard(&d, 280, 3);
    let mut first: Option<Vec<RayHit>> = None;
    let mut runs = 0;
    for level_up in LevelUp::ALL {
        for levels_down in 1..=4 {
            for start_level in [false, true] {
                d.mode = ModeConfig { start_level, levels_down, level_up, ..ModeConfig::default() };
                let g = prepare(&d).unwrap();
                let p = Pipeline::new(&d, &Binding::new()).unwrap();
                let run = p.run(&pyramid, &rays, 16, Traffic { gaps: 60, stalls: 90, resets: 2, seed: runs }).unwrap();
                let hits: Vec<RayHit> = run.results.iter().map(|r| hit(&d, r)).collect();
                for (k, (h, r)) in hits.iter().zip(&rays).enumerate() {
                    assert_eq!(*h, g.trace(&pyramid, r), "ray {k} in {:?}", d.mode);
                }
                let place = |h: &RayHit| (h.i, h.j, h.fu, h.fv, h.t, h.wall, h.limit);
                let base = first.get_or_insert(hits.clone());
                assert!(base.iter().map(place).eq(hits.iter().map(place)), "{:?} hits elsewhere", d.mode);
                runs += 1;
            }
        }
    }
    assert_eq!(runs, 40);
}

/// Rays with finest levels of their own, some above the root.
fn detailed(d: &Design, count: usize, seed: u64) -> (Pyramid, Vec<RayInput>) {
    let (pyramid, mut rays) = hard(d, count, seed);
    rays.iter_mut().enumerate().for_each(|(k, r)| r.lod = if k % 2 == 0 { 0 } else { (k / 14 % 8) as u32 });
    (pyramid, rays)
}

/// Each trim in each mode, with a finest level for each ray: the pipeline equals the model, and all hit alike.
#[test]
fn every_trim_equals_golden_and_hits_alike() {
    let mut d = design(24, 24);
    d.traverse.levels = 5;
    let (pyramid, rays) = detailed(&d, 280, 3);
    let mut first: Option<Vec<RayHit>> = None;
    let mut runs = 0;
    for trim in Trim::ALL {
        for level_up in LevelUp::ALL {
            for levels_down in 1..=4 {
                for start_level in [false, true] {
                    d.mode =
                        ModeConfig { start_level, levels_down, level_up, trim, lod: true, ..ModeConfig::default() };
                    let g = prepare(&d).unwrap();
                    let p = Pipeline::new(&d, &Binding::new()).unwrap();
                    let run =
                        p.run(&pyramid, &rays, 16, Traffic { gaps: 60, stalls: 90, resets: 2, seed: runs }).unwrap();
                    let hits: Vec<RayHit> = run.results.iter().map(|r| hit(&d, r)).collect();
                    for (k, (h, r)) in hits.iter().zip(&rays).enumerate() {
                        assert_eq!(*h, g.trace(&pyramid, r), "ray {k} in {:?}", d.mode);
                    }
                    let place = |h: &RayHit| (h.i, h.j, h.fu, h.fv, h.t, h.wall, h.limit);
                    let base = first.get_or_insert(hits.clone());
                    assert!(base.iter().map(place).eq(hits.iter().map(place)), "{:?} hits elsewhere", d.mode);
                    runs += 1;
                }
            }
        }
    }
    assert_eq!(runs, 120);
}

/// Narrow words, where a texel is a few units wide, and net by net.
#[test]
fn every_iteration_of_a_trim_equals_the_golden_models() {
    for (k, (f, w)) in [(24, 24), (12, 10), (8, 8), (28, 31)].into_iter().enumerate() {
        let mut d = design(f, w);
        d.traverse.levels = [5, 6, 8, 3][k];
        (d.mode.trim, d.mode.lod) = ([Trim::Descent, Trim::Always][k % 2], true);
        let (pyramid, rays) = detailed(&d, 42, 5);
        for r in &rays {
            assert_eq!(diagnose(&d, &pyramid, r).unwrap(), None, "Q.{f}/{w} {r:x?}");
        }
    }
}

/// One elaborated text at other parameter values: what the emitted Verilog is worth to whoever changes them.
#[test]
fn other_parameters_equal_golden() {
    let mut checked = 0;
    for (f, w) in FORMATS {
        for (levels, height, tile) in [(2, 8, 4), (3, 16, 2), (5, 8, 8), (6, 16, 4), (7, 2, 1), (12, 8, 4), (12, 16, 1)]
        {
            if height > f {
                continue;
            }
            let values =
                [("FRACTION_W", f), ("RECIP_W", w), ("LEVELS", levels), ("HEIGHT_W", height), ("TILE_W", tile)];
            let over: Binding = values.iter().map(|(k, v)| (k.to_string(), i64::from(*v))).collect();
            let mut base = design(24, 24);
            (base.mode.trim, base.mode.lod) =
                ([Trim::None, Trim::Always, Trim::Descent][levels as usize % 3], levels > 4);
            let d = design_at(&base, &over);
            let (pyramid, rays) = detailed(&d, 120, u64::from(levels));
            let g = prepare(&d).unwrap();
            let run = Pipeline::new(&base, &over).unwrap().run(&pyramid, &rays, 16, Traffic::default()).unwrap();
            for (k, (h, r)) in run.results.iter().zip(&rays).enumerate() {
                assert_eq!(hit(&d, h), g.trace(&pyramid, r), "ray {k} at {over:?}");
                checked += 1;
            }
        }
    }
    println!("0 of {checked} mismatched");
}

#[test]
fn other_latencies_and_full_load() {
    for l in [0, 1, 3, 5] {
        let mut d = design(20, 18);
        d.traverse.levels = 5;
        d.mode.trim = [Trim::Always, Trim::None, Trim::Descent][l as usize % 3];
        (d.latency.add, d.latency.mul, d.latency.div, d.latency.decision) = (l, l, 2 * l, 1 + l / 3);
        let (pyramid, rays) = hard(&d, 250, 8);
        let g = prepare(&d).unwrap();
        let p = Pipeline::new(&d, &Binding::new()).unwrap();
        let run = p.run(&pyramid, &rays, 1, Traffic::default()).unwrap();
        assert!(run.results.iter().zip(&rays).all(|(h, r)| hit(&d, h) == g.trace(&pyramid, r)));
        assert!(run.loaded > 400 && run.busy as f64 / run.loaded as f64 >= 0.98, "{} of {}", run.busy, run.loaded);
    }
}

#[test]
fn the_loop_is_shorter_than_the_floating_point_one() {
    let float = Pipeline::new(&reliefrtl::config::Design::default(), &Binding::new()).unwrap();
    let fixed = Pipeline::new(&design(24, 24), &Binding::new()).unwrap();
    println!("{} slots of {} in fixed point, {} of {}", fixed.slots, fixed.depth, float.slots, float.depth);
    assert!(fixed.slots < float.slots);
}

/// Net by net, not only at the end.
#[test]
fn every_iteration_equals_the_golden_models() {
    for (f, w) in FORMATS {
        let mut d = design(f, w);
        d.traverse.levels = 5;
        let (pyramid, rays) = hard(&d, 21, 5);
        for r in &rays {
            assert_eq!(diagnose(&d, &pyramid, r).unwrap(), None, "{r:x?}");
        }
    }
}
