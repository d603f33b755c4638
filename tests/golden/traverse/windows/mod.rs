//! The search by windows: the hit of every ray is the pyramid's, word by word, and each rule of `docs/windows.md` is needed.
//!
//! `RELIEFRTL_RAYS` sets the rays a map; `RELIEFRTL_SEED` their seed.
mod canaries;
mod designs;
mod maps;
mod plain;

use super::fixed::{Kind, ray};
use super::scenes::{self, env, map};
use designs::{SETS, SIZES, any_set, any_sizes, pyramid, windows};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{Design, WindowSet};
use reliefrtl::golden::fixed::travel;
use reliefrtl::golden::{Datapath, Pyramid, RayHit, RayInput, Windows, prepare};

/// What became of rays.
#[derive(Debug, Default)]
struct Tally {
    rays: u64,
    wrong: u64,
    given_up: u64,
    /// Given up, as their walk is longer than any step limit.
    beyond: u64,
    steps: u64,
    witness: String,
}

/// What must be the same in both searches.
fn answer(hit: &RayHit) -> RayHit {
    RayHit { steps: 0, crossings: 0, ups: 0, ..*hit }
}

/// More texels than the ray passes.
fn texels(d: &Design, ray: &RayInput) -> u64 {
    let below = d.datapath.fraction_bits - d.traverse.levels;
    [ray.du, ray.dv].map(|word| (travel(d, word).unsigned_abs() >> below) * 33 / 32 + 3).iter().sum()
}

impl Tally {
    /// Traces `count` rays of all kinds in both searches.
    fn add(&mut self, d: &Design, kind: usize, count: u64, seed: u64) {
        let (n, h) = (d.traverse.levels, d.traverse.height_bits);
        let map = Pyramid::build(n, h, &map(kind, n, h, seed)).unwrap();
        let (ours, theirs) = (Windows::prepare(d).unwrap(), prepare(&pyramid(d)).unwrap());
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        for number in 0..count {
            let of = Kind::ALL[number as usize % Kind::ALL.len()];
            let ray = ray(d, of, &mut rng);
            let (hit, truth) = (ours.trace(&map, &ray), theirs.trace(&map, &ray));
            self.rays += 1;
            self.steps += u64::from(hit.steps);
            if hit.limit && texels(d, &ray) > u64::from(d.traverse.step_limit) {
                self.beyond += 1;
                continue;
            }
            self.given_up += u64::from(hit.limit || truth.limit);
            if answer(&hit) != answer(&truth) {
                self.wrong += 1;
                if self.witness.is_empty() {
                    self.witness = format!(
                        "{:?} {:?} {} map {kind} seed {seed} {of:?} {ray:x?}: {hit:?}, not {truth:?}",
                        d.datapath,
                        d.traverse,
                        d.window_set()
                    );
                }
            }
        }
    }

    fn passed(&self, what: &str, seed: u64) {
        println!(
            "{what}: {} of {} rays end otherwise than in the pyramid, {} given up, {} more that pass more texels than the step limit; {:.1} iterations a ray (seed {seed})",
            self.wrong,
            self.rays,
            self.given_up,
            self.beyond,
            self.steps as f64 / self.rays as f64
        );
        assert!(self.rays > 0 && self.wrong == 0, "{}", self.witness);
        assert!(self.given_up == 0 && self.beyond * 100 < self.rays, "{} {}", self.given_up, self.beyond);
    }
}

#[test]
fn every_set_finds_the_hit_of_the_pyramid() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 700), env("RELIEFRTL_SEED", 1));
    let mut all = Tally::default();
    for (at, sizes) in SIZES.into_iter().enumerate() {
        for (s, set) in SETS.iter().enumerate() {
            let set: WindowSet = set.parse().unwrap();
            if set.misfit(sizes.2).is_some() {
                continue;
            }
            // Maps of 512 and 1024 texels a side take longer to prepare than rays to trace: one kind of them a set.
            let kinds =
                if sizes.2 > 8 { (at + s) % scenes::MAPS..(at + s) % scenes::MAPS + 1 } else { 0..scenes::MAPS };
            kinds.for_each(|kind| all.add(&windows(sizes, set), kind, count, seed + s as u64));
        }
    }
    all.passed("windows", seed);
}

#[test]
fn any_legal_set_at_any_sizes_finds_the_hit_of_the_pyramid() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 700), env("RELIEFRTL_SEED", 1));
    let (mut all, mut rng) = (Tally::default(), ChaCha8Rng::seed_from_u64(seed));
    for number in 0..600 {
        // Most maps are small: more of them, and every border is near.
        let sizes = any_sizes(if number % 20 == 0 { 10 } else { 7 }, &mut rng);
        let set = any_set(sizes.2, &mut rng);
        all.add(&windows(sizes, set), number as usize % scenes::MAPS, count, seed ^ number);
    }
    all.passed("windows of any sizes", seed);
}

/// 4096 texels a side and the longest travel: n + T = 20, beyond one multiplier's operand.
#[test]
fn the_largest_map_and_the_longest_travel() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 3000), env("RELIEFRTL_SEED", 1));
    let mut all = Tally::default();
    for (sizes, set) in [((24, 31, 12, 16, 8), "1 4@2 12@4 24@8 64@16"), ((12, 32, 12, 12, 8), "1 4@2 12@4 40@8")] {
        all.add(&windows(sizes, set.parse().unwrap()), 0, count, seed);
    }
    all.passed("windows on 4096 x 4096", seed);
}
