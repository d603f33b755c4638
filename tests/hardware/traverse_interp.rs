//! The emitted traverse unit in the interpreter, in every mode, equals the golden model ray by ray; all modes hit alike.
use crate::budget::share;
use rand::{Rng, SeedableRng};
use rayon::prelude::*;
use reliefrtl::catalogue::design_at;
use reliefrtl::config::{Design, Divider, LatencyConfig, LevelUp, ModeConfig, Profile, Trim};
use reliefrtl::golden::{Datapath, Pyramid, RayHit, RayInput, Watertight};
use reliefrtl::interp::Traffic;
use reliefrtl::ir::Binding;
use reliefrtl::trace::{Pipeline, hit};

fn hard(d: &Design, seed: u64) -> (Pyramid, Vec<RayInput>) {
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    let n = d.traverse.levels;
    let texels: Vec<u32> =
        (0..1usize << (2 * n)).map(|_| rng.random_range(0..=255u32) >> rng.random_range(0..5)).collect();
    let ray = |k: usize, rng: &mut rand_chacha::ChaCha8Rng| {
        let grid = |rng: &mut rand_chacha::ChaCha8Rng| f64::from(rng.random_range(0..1u32 << n)) / f64::from(1u32 << n);
        let far = |rng: &mut rand_chacha::ChaCha8Rng| (rng.random::<f64>() - 0.5) * 8.0;
        match k % 5 {
            0 => [grid(rng), grid(rng), far(rng), far(rng)],
            1 => [grid(rng), rng.random_range(0.0..0.99), 0.0, far(rng)],
            2 => [grid(rng), grid(rng), 0.25, -0.25],
            3 => [rng.random_range(0.0..0.99), grid(rng), far(rng) / 50.0, 0.0],
            _ => [rng.random_range(0.0..0.99), rng.random_range(0.0..0.99), far(rng), far(rng) / 9.0],
        }
    };
    let rays =
        (0..250).map(|k| ray(k, &mut rng)).map(|[u, v, a, b]| RayInput::from_f64(d.format, u, v, a, b)).collect();
    (Pyramid::build(n, 8, &texels).unwrap(), rays)
}

/// What a ray takes in the interpreter grows with the slots of the loop, and what a mode does doesn't depend on them.
fn few_registers() -> Design {
    let d = Design::default();
    Design { latency: Profile::Published.latency(d.datapath.kind), ..d }
}

#[test]
fn every_mode_equals_golden_and_hits_alike() {
    let mut d = few_registers();
    d.traverse.levels = 5;
    let (pyramid, rays) = hard(&d, 3);
    let mut first: Option<Vec<RayHit>> = None;
    let mut runs = 0;
    for level_up in LevelUp::ALL {
        for levels_down in 1..=4 {
            for start_level in [false, true] {
                d.mode = ModeConfig { start_level, levels_down, level_up, ..ModeConfig::default() };
                let g = Watertight::prepare(&d).unwrap();
                let p = Pipeline::new(&d, &Binding::new()).unwrap();
                let traffic = Traffic { gaps: 60, stalls: 90, resets: 2, seed: runs };
                let run = p.run(&pyramid, &rays, 16, traffic).unwrap();
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

/// Each trim in each mode, with a finest level for each ray: the pipeline equals the model, and all hit alike.
#[test]
fn every_trim_equals_golden_and_hits_alike() {
    let mut d = few_registers();
    d.traverse.levels = 5;
    let (pyramid, mut rays) = hard(&d, 3);
    rays.iter_mut().enumerate().for_each(|(k, r)| r.lod = if k % 2 == 0 { 0 } else { (k / 10 % 8) as u32 });
    let mut first: Option<Vec<RayHit>> = None;
    let mut runs = 0;
    for trim in Trim::ALL {
        for level_up in LevelUp::ALL {
            for levels_down in 1..=4 {
                for start_level in [false, true] {
                    runs += 1;
                    // Of a usual run one half, in which each choice meets each other.
                    let odd = trim as u64 + level_up as u64 + u64::from(levels_down) + u64::from(start_level);
                    if share(2) > 1 && odd % 2 == 1 {
                        continue;
                    }
                    d.mode =
                        ModeConfig { start_level, levels_down, level_up, trim, lod: true, ..ModeConfig::default() };
                    let g = Watertight::prepare(&d).unwrap();
                    let p = Pipeline::new(&d, &Binding::new()).unwrap();
                    let traffic = Traffic { gaps: 60, stalls: 90, resets: 2, seed: runs };
                    let run = p.run(&pyramid, &rays, 16, traffic).unwrap();
                    let hits: Vec<RayHit> = run.results.iter().map(|r| hit(&d, r)).collect();
                    for (k, (h, r)) in hits.iter().zip(&rays).enumerate() {
                        assert_eq!(*h, g.trace(&pyramid, r), "ray {k} in {:?}", d.mode);
                    }
                    let place = |h: &RayHit| (h.i, h.j, h.fu, h.fv, h.t, h.wall, h.limit);
                    let base = first.get_or_insert(hits.clone());
                    assert!(base.iter().map(place).eq(hits.iter().map(place)), "{:?} hits elsewhere", d.mode);
                }
            }
        }
    }
    assert_eq!(runs, 120);
}

#[test]
fn other_latencies_and_full_load() {
    for (l, trim) in
        [(1, Trim::None), (3, Trim::None), (5, Trim::None), (0, Trim::Always), (2, Trim::Descent), (4, Trim::Always)]
    {
        let mut d = Design::default();
        d.traverse.levels = 5;
        d.mode.trim = trim;
        (d.latency.add, d.latency.mul, d.latency.div, d.latency.decision) = (l, l, 2 * l, 1 + l / 3);
        let (pyramid, rays) = hard(&d, 8);
        let g = Watertight::prepare(&d).unwrap();
        let p = Pipeline::new(&d, &Binding::new()).unwrap();
        let run = p.run(&pyramid, &rays, 1, Traffic::default()).unwrap();
        assert!(run.results.iter().zip(&rays).all(|(h, r)| hit(&d, h) == g.trace(&pyramid, r)));
        assert!(run.loaded > 500 && run.busy as f64 / run.loaded as f64 >= 0.98, "{} of {}", run.busy, run.loaded);
    }
}

/// Each register that stands between units by itself, and all at once; with rays that come and results that are taken in fits and starts, so that
/// every pipeline stops and goes on.
#[test]
fn registers_between_units_change_no_result() {
    type Set = fn(&mut LatencyConfig, u32);
    let keys: [(Set, u32); 8] = [
        (|l, n| l.decision = n, 5),
        (|l, n| l.node = n, 3),
        (|l, n| l.memory = n, 4),
        (|l, n| l.select = n, 1),
        (|l, n| l.setup = n, 1),
        (|l, n| l.hit = n, 2),
        (|l, n| l.handshake = n, 3),
        // The shortest line, and longer ones.
        (|l, n| l.delay_line = if n > 0 { n + 2 } else { 0 }, 3),
    ];
    let mut all: Vec<LatencyConfig> = Vec::new();
    for (set, most) in keys {
        for n in 0..=most {
            let mut l = LatencyConfig::default();
            set(&mut l, n.max(u32::from(most > 3)));
            all.push(l);
        }
    }
    let mut every = LatencyConfig { add: 8, mul: 4, compare: 2, from_int: 5, to_int: 5, div: 20, ..Default::default() };
    keys.iter().for_each(|(set, most)| set(&mut every, *most));
    all.push(every);
    let check = |(k, l): (usize, &LatencyConfig)| {
        let mut d = Design { latency: *l, ..Design::default() };
        d.traverse.levels = 4;
        d.mode.trim = [Trim::None, Trim::Descent, Trim::Always][k % 3];
        let (pyramid, rays) = hard(&d, 8);
        let (g, p) = (Watertight::prepare(&d).unwrap(), Pipeline::new(&d, &Binding::new()).unwrap());
        let traffic = [
            Traffic { gaps: 30, stalls: 200, resets: 3, seed: 7 },
            Traffic { gaps: 200, seed: 8, ..Traffic::default() },
            Traffic::default(),
        ];
        // In the usual run each latency meets one or two of them, and the last, which has all registers, all.
        let asked = |t: &usize| share(2) == 1 || k + 1 == all.len() || (k + t).is_multiple_of(2);
        for traffic in (0..3).filter(asked).map(|t| traffic[t]) {
            let run = p.run(&pyramid, &rays, 64, traffic).unwrap();
            assert_eq!(run.results.len(), rays.len(), "{l:?}");
            assert!(
                run.results.iter().zip(&rays).all(|(h, r)| hit(&d, h) == g.trace(&pyramid, r)),
                "{l:?}, {traffic:?}"
            );
        }
    };
    all.par_iter().enumerate().for_each(check);
}

/// The divider by table at its fewest clocks, among others and with a register at the end.
#[test]
fn dividers_by_table() {
    for div in [Design::TABLE_CLOCKS, 4, 8, 9] {
        let mut d = Design::default();
        d.traverse.levels = 5;
        (d.latency.div, d.latency.divider) = (div, Divider::Table);
        let (pyramid, rays) = hard(&d, 8);
        let g = Watertight::prepare(&d).unwrap();
        let p = Pipeline::new(&d, &Binding::new()).unwrap();
        let run = p.run(&pyramid, &rays, 64, Traffic::default()).unwrap();
        assert_eq!(run.results.len(), rays.len());
        assert!(run.results.iter().zip(&rays).all(|(h, r)| hit(&d, h) == g.trace(&pyramid, r)), "{div} clocks");
    }
}

#[test]
fn threads_and_traffic_change_no_result() {
    let mut d = Design::default();
    d.traverse.levels = 5;
    let (pyramid, rays) = hard(&d, 8);
    let p = Pipeline::new(&d, &Binding::new()).unwrap();
    let want = p.run(&pyramid, &rays, 64, Traffic::default()).unwrap().results;
    assert_eq!(want.len(), rays.len());
    for (threads, lanes) in [(1, 200), (2, 16), (3, 64), (7, 1)] {
        for traffic in [Traffic::default(), Traffic { gaps: 90, stalls: 120, resets: 1, seed: 4 }] {
            let run = |()| p.run_parallel(&pyramid, &rays, lanes, threads, traffic).unwrap();
            let [first, again] = [(), ()].map(run);
            assert_eq!(first.results, want, "{threads} threads, {traffic:?}");
            assert_eq!((first.cycles, first.loaded, first.busy), (again.cycles, again.loaded, again.busy));
        }
    }
    let nothing = p.run_parallel(&pyramid, &[], 64, 2, Traffic::default()).unwrap();
    assert!(nothing.results.is_empty());
}

/// The emitted text's own parameters, from a format whose exponents only just hold the map; with a divider that any format has.
#[test]
fn other_formats_equal_golden() {
    let mut d = Design::default();
    d.latency.div = 2;
    for (exp, man, levels) in [(5, 10, 8), (5, 16, 10), (6, 7, 4), (8, 23, 9)] {
        let over: Binding =
            [("EXP_W", exp), ("MAN_W", man), ("LEVELS", levels)].map(|(n, v)| (n.to_string(), v)).into();
        let at = design_at(&d, &over);
        let (pyramid, rays) = hard(&at, 5);
        let run = Pipeline::new(&d, &over).unwrap().run(&pyramid, &rays, 16, Traffic::default()).unwrap();
        let g = Watertight::prepare(&at).unwrap();
        for (k, (got, r)) in run.results.iter().zip(&rays).enumerate() {
            assert_eq!(hit(&d, got), g.trace(&pyramid, r), "ray {k} at {over:?}");
        }
    }
}
