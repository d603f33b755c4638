//! The traverse unit in the interpreter equals the golden model ray by ray.
use super::{FORMATS, SETS, design, hard};
use reliefrtl::catalogue::design_at;
use reliefrtl::config::{Design, Profile};
use reliefrtl::golden::prepare;
use reliefrtl::interp::Traffic;
use reliefrtl::ir::Binding;
use reliefrtl::trace::{Pipeline, diagnose, hit};

/// Rays through `base` at the parameter values `over`; how many.
fn equal(base: &Design, over: &Binding, count: usize, traffic: Traffic) -> usize {
    let d = design_at(base, over);
    let (pyramid, rays) = hard(&d, count, 3);
    let g = prepare(&d).unwrap();
    let run = Pipeline::new(base, over).unwrap().run(&pyramid, &rays, 16, traffic).unwrap();
    for (k, (h, r)) in run.results.iter().zip(&rays).enumerate() {
        assert_eq!(hit(&d, h), g.trace(&pyramid, r), "ray {k}, {r:x?}, at {over:?} of {}", d.window_set());
    }
    rays.len()
}

#[test]
fn three_widths_and_five_sets_equal_golden() {
    let mut checked = 0;
    for (k, (f, w)) in FORMATS.into_iter().enumerate() {
        for (s, set) in SETS.into_iter().enumerate() {
            let mut d = design(f, w, set);
            d.traverse.levels = 5;
            d.latency = Profile::ALL[(k + s) % 3].latency(d.datapath.kind);
            // Rays that are given up keep what they had.
            d.traverse.step_limit = [65535, 4][s % 2];
            checked += equal(&d, &Binding::new(), 200, Traffic { gaps: 60, stalls: 90, resets: 2, seed: s as u64 });
        }
    }
    println!("0 of {checked} mismatched");
    assert_eq!(checked, 3000);
}

/// One elaborated text at other parameter values: its set stays. Where the derived widths turn, there is no bit below a texel, none of the
/// estimate's, fewer than 18 of the parameter.
#[test]
fn other_parameters_equal_golden() {
    let sizes = [
        (24, 24, 2, 8, 4),
        (8, 8, 8, 8, 4),
        (8, 32, 2, 2, 8),
        (28, 31, 5, 16, 4),
        (9, 9, 9, 9, 8),
        (14, 10, 5, 2, 7),
        (16, 16, 3, 12, 8),
        (10, 20, 8, 4, 8),
        (13, 32, 6, 5, 3),
    ];
    for (f, w, levels, height, tile) in sizes {
        let values = [("FRACTION_W", f), ("RECIP_W", w), ("LEVELS", levels), ("HEIGHT_W", height), ("TILE_W", tile)];
        let over: Binding = values.iter().map(|(k, v)| (k.to_string(), i64::from(*v))).collect();
        let mut base = design(24, 24, "1 4@2 8@4");
        // A narrow reciprocal has few rows.
        base.latency.div = 8;
        equal(&base, &over, 100, Traffic::default());
    }
}

#[test]
fn other_latencies_and_full_load() {
    for l in [0, 1, 3, 5] {
        let mut d = design(20, 18, "1 4@2 16@4");
        d.traverse.levels = 5;
        (d.latency.add, d.latency.mul, d.latency.div, d.latency.compare) = (l, l, 2 * l, l / 2);
        (d.latency.node, d.latency.memory, d.latency.decision) = (l.min(3), 1 + l.min(3), 1 + l.min(2));
        d.latency.handshake = l.min(3);
        let (pyramid, rays) = hard(&d, 250, 8);
        let g = prepare(&d).unwrap();
        let p = Pipeline::new(&d, &Binding::new()).unwrap();
        let run = p.run(&pyramid, &rays, 1, Traffic::default()).unwrap();
        assert!(run.results.iter().zip(&rays).all(|(h, r)| hit(&d, h) == g.trace(&pyramid, r)));
        println!("{} slots: {} of {} busy", p.slots, run.busy, run.loaded);
    }
}

#[test]
fn the_default_loop_has_twelve_slots() {
    let latency = Profile::Balanced.latency(design(24, 24, SETS[0]).datapath.kind);
    let p = Pipeline::new(&Design { latency, ..design(24, 24, SETS[0]) }, &Binding::new()).unwrap();
    assert_eq!(p.slots, 12);
    for port in ["out_crossings", "out_ups", "load_en"] {
        assert!(!p.outputs.contains(&port) && !p.net.names.contains_key(port), "{port}");
    }
    assert!(p.outputs.contains(&"out_steps"));
}

/// Net by net, not only at the end.
#[test]
fn every_iteration_equals_the_golden_models() {
    for ((f, w), set) in FORMATS.into_iter().zip(SETS) {
        let mut d = design(f, w, set);
        d.traverse.levels = 5;
        let (pyramid, rays) = hard(&d, 24, 5);
        for r in &rays {
            assert_eq!(diagnose(&d, &pyramid, r).unwrap(), None, "{r:x?}");
        }
    }
}
