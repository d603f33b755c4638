//! Four cells an iteration: the hit of every ray is that of the walk by one cell, word by word, in all modes of both datapaths; and the whole block
//! counts in fewer iterations.
//!
//! `RELIEFRTL_RAYS` sets the rays a map; `RELIEFRTL_SEED` their seed.
use super::fixed::{self, SIZES};
use super::scenes::{self, Kind, Rays, env, map};
use super::{answer, design, modes};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{Design, FetchConfig, LevelUp, ModeConfig, Trim};
use reliefrtl::format::FloatFormat;
use reliefrtl::golden::{Datapath, Decision, Pyramid, RayInput, prepare};

type Tracer = Box<dyn Datapath>;

/// The plain walk by one cell, then four cells in all modes; all with a level of detail.
fn tracers(base: &Design) -> Vec<Tracer> {
    let plain = modes(base.format)[0];
    assert_eq!((plain.levels_down, plain.level_up, plain.lod), (1, LevelUp::None, true));
    let four = Design { fetch: FetchConfig::BLOCK, mode: ModeConfig { lod: true, ..base.mode }, ..*base };
    let all = four.block_modes(base.trims());
    assert_eq!(all.len(), if base.trims().len() > 1 { 72 } else { 36 });
    let all = all.into_iter().map(|mode| prepare(&Design { mode, ..four }).unwrap());
    [prepare(&Design { mode: plain, ..*base }).unwrap()].into_iter().chain(all).collect()
}

/// What became of rays.
#[derive(Default)]
struct Tally {
    rays: u64,
    wrong: u64,
    limits: u64,
    steps: [u64; 2],
    witness: String,
}

impl Tally {
    /// Traces `count` rays of `next` over a map.
    fn add(&mut self, base: &Design, kind: usize, count: u64, seed: u64, mut next: impl FnMut(u64) -> RayInput) {
        let (n, h) = (base.traverse.levels, base.traverse.height_bits);
        let pyramid = Pyramid::build(n, h, &map(kind, n, h, seed)).unwrap();
        let tracers = tracers(base);
        for number in 0..count {
            // Every second ray ends at a finest level of its own. The root is no cell of a block.
            let lod = if number % 2 == 0 { 0 } else { (number / 2 % u64::from(n)) as u32 };
            let ray = RayInput { lod, ..next(number) };
            let plain = tracers[0].trace(&pyramid, &ray);
            self.rays += 1;
            let mut wrong = None;
            for tracer in &tracers[1..] {
                let hit = tracer.trace(&pyramid, &ray);
                self.limits += u64::from(hit.limit || plain.limit);
                if answer(&hit) != answer(&plain) {
                    wrong = wrong.or(Some((tracer, hit)));
                }
                self.steps[1] += u64::from(hit.steps);
                self.steps[0] += u64::from(plain.steps);
            }
            self.wrong += u64::from(wrong.is_some());
            if let Some((tracer, hit)) = wrong.filter(|_| self.witness.is_empty()) {
                let d = tracer.design();
                self.witness = format!(
                    "{} {:?} map {kind} seed {seed} {ray:x?} {:?}: {hit:?}, one cell {plain:?}",
                    d.label(),
                    d.traverse,
                    d.mode
                );
            }
        }
    }

    fn passed(&self, what: &str, seed: u64) {
        let Self { rays, wrong, limits, steps: [one, four], .. } = self;
        println!(
            "{what}: {wrong} of {rays} rays end otherwise than by one cell, {limits} given up; iterations {four} for {one} (seed {seed})"
        );
        assert!(*rays > 0 && *limits == 0);
        assert_eq!(*wrong, 0, "{}", self.witness);
        assert!(four * 4 < one * 3, "{four} iterations for {one}");
    }
}

#[test]
fn four_cells_find_the_hit_of_one_in_floating_point() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 45), env("RELIEFRTL_SEED", 1));
    let mut all = Tally::default();
    let usual = [2, 3, 4, 5, 6, 7, 8].map(|n| design(FloatFormat::FP24, n, if n % 2 == 0 { 8 } else { 16 }, 4));
    let formats = [(5, 10), (6, 7), (8, 23), (5, 7), (5, 23)].map(|(exp, man)| FloatFormat::new(exp, man));
    let others =
        formats.into_iter().flat_map(|format| [2, 5, 8].map(|n| design(format, n, 8, if n > 2 { 2 } else { 1 })));
    let all_legal: Vec<Design> = usual.into_iter().chain(others).filter(|d| prepare(d).is_ok()).collect();
    assert!(all_legal.len() > 15, "{}", all_legal.len());
    for d in all_legal {
        for kind in 0..scenes::MAPS {
            let mut rays = Rays::new(d.format, d.traverse.levels, d.traverse.tile_bits, seed + kind as u64);
            all.add(&d, kind, count, seed, |number| rays.next(Kind::ALL[number as usize % Kind::ALL.len()]));
        }
    }
    all.passed("float", seed);
}

#[test]
fn four_cells_find_the_hit_of_one_in_fixed_point() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 270), env("RELIEFRTL_SEED", 1));
    let mut all = Tally::default();
    for (f, w, n, h, tile) in SIZES {
        let d = fixed::design(f, w, n, h, tile);
        // A map of 4096 texels to the side is slow to build; one kind of it is enough.
        for kind in 0..if n > 8 { 1 } else { scenes::MAPS } {
            let mut rng = ChaCha8Rng::seed_from_u64(seed + kind as u64);
            let kinds = fixed::Kind::ALL;
            all.add(&d, kind, count, seed, |number| fixed::ray(&d, kinds[number as usize % kinds.len()], &mut rng));
        }
    }
    all.passed("fixed", seed);
}

/// A crossing goes beyond the block, a descent never goes back, and the parameter never falls.
#[test]
fn a_ray_only_goes_forward() {
    let seed = env("RELIEFRTL_SEED", 1);
    let mut seen = [0u64; 2];
    for trim in [Trim::None, Trim::Always] {
        let base = Design { fetch: FetchConfig::BLOCK, ..design(FloatFormat::FP24, 6, 8, 4) };
        let d = Design { mode: ModeConfig { trim, levels_down: 3, ..base.mode }, ..base };
        let g = prepare(&d).unwrap();
        let pyramid = Pyramid::build(6, 8, &map(4, 6, 8, seed)).unwrap();
        let mut rays = Rays::new(d.format, 6, 4, seed);
        for number in 0..2000 {
            let ray = rays.next(Kind::ALL[number % Kind::ALL.len()]);
            let mut all = Vec::new();
            let hit = g.trace_with(&pyramid, &ray, Some(&mut |it| all.push(*it)));
            assert_eq!(hit.steps as usize, all.len());
            for it in &all {
                let read = it.chord.map_or(it.level, |c| c.level);
                assert!(it.level < 6 && read <= it.level && it.next_level < 6);
                assert!(!reliefrtl::golden::float::lt(d.format, it.next_t, it.t), "{ray:x?} {it:?}");
                match it.decision {
                    Decision::Hit => assert_eq!((read, it.next_level), (0, 0)),
                    Decision::Descend => assert!(it.next_level < read),
                    Decision::CrossX => assert_ne!(it.next_x >> (it.level + 1), it.x >> (it.level + 1)),
                    Decision::CrossY => assert_ne!(it.next_y >> (it.level + 1), it.y >> (it.level + 1)),
                }
                seen[0] += u64::from(it.decision == Decision::Descend && it.level - it.next_level == 3);
                seen[1] += u64::from(read < it.level);
            }
        }
    }
    assert!(seen.iter().all(|n| *n > 100), "{seen:?}");
}

/// Modes that four cells do not have are refused by the model, too.
#[test]
fn other_modes_are_refused() {
    for base in [design(FloatFormat::FP24, 4, 8, 4), fixed::design(24, 24, 4, 8, 4)] {
        let four = |mode| prepare(&Design { fetch: FetchConfig::BLOCK, mode, ..base });
        assert!(four(base.mode).is_ok());
        for mode in [
            ModeConfig { level_up: LevelUp::None, ..base.mode },
            ModeConfig { trim: Trim::Descent, ..base.mode },
            ModeConfig { levels_down: 4, ..base.mode },
            ModeConfig { levels_down_after: Some(4), ..base.mode },
            ModeConfig { bilinear: true, ..base.mode },
        ] {
            assert!(four(mode).is_err(), "{mode:?}");
        }
    }
}
