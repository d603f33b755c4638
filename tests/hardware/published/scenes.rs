//! Designs, maps and rays for the tests of the published datapath, all from a seed.
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{DatapathKind, Design, LevelUp, ModeConfig, Profile};
use reliefrtl::golden::{Pyramid, RayInput};

/// The published datapath and pipeline over 2^levels x 2^levels texels, with a step limit that a test can wait for.
pub fn design(levels: u32) -> Design {
    let mut d = Design::default();
    d.datapath.kind = DatapathKind::Published;
    d.latency = Profile::Published.latency(d.datapath.kind);
    d.traverse.levels = levels;
    d.traverse.step_limit = 300;
    d
}

/// All 40 modes.
pub fn modes() -> Vec<ModeConfig> {
    let mut all = Vec::new();
    for start_level in [false, true] {
        for levels_down in 1..=4 {
            all.extend(LevelUp::ALL.map(|level_up| ModeConfig {
                start_level,
                levels_down,
                level_up,
                ..ModeConfig::default()
            }));
        }
    }
    all
}

/// A map of heights of every size, and rays of every kind: from and along texel borders, axis-parallel, straight down, long,
/// short, and some that are none.
pub fn hard(d: &Design, count: usize, seed: u64) -> (Pyramid, Vec<RayInput>) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (n, h) = (d.traverse.levels, d.traverse.height_bits);
    let texels: Vec<u32> =
        (0..1usize << (2 * n)).map(|_| rng.random_range(0..1u32 << h) >> rng.random_range(0..5)).collect();
    let reach = 2f64.powi(d.traverse.tile_bits as i32);
    let grid = |rng: &mut ChaCha8Rng| f64::from(rng.random_range(0..1u32 << n)) / f64::from(1u32 << n);
    let any = |rng: &mut ChaCha8Rng| rng.random_range(0.0..0.99);
    let far = |rng: &mut ChaCha8Rng| (rng.random::<f64>() - 0.5) * reach;
    let ray = |k: usize, rng: &mut ChaCha8Rng| match k % 8 {
        0 => [grid(rng), grid(rng), far(rng), far(rng)],
        1 => [grid(rng), any(rng), 0.0, far(rng)],
        2 => [grid(rng), grid(rng), 0.25, -0.25],
        3 => [any(rng), grid(rng), far(rng) / 50.0, -0.0],
        4 => [any(rng), any(rng), 0.0, 0.0],
        5 => [any(rng), any(rng), far(rng) / 4000.0, far(rng) / 700.0],
        6 if k % 32 == 6 => [any(rng), any(rng), reach, 0.1],
        _ => [any(rng), any(rng), far(rng), far(rng) / 9.0],
    };
    let rays = (0..count).map(|k| ray(k, &mut rng)).map(|[u, v, a, b]| RayInput::from_f64(d.format, u, v, a, b));
    let rays = rays.collect();
    (Pyramid::build(n, h, &texels).unwrap(), rays)
}
