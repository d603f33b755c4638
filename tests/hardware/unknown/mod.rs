//! Unknown values (x) never reach a handshake: a memory that was not loaded or half of it, rays with unknown words among good ones, ports that
//! are not driven while they are not asked, resets of one clock at random. Every ray leaves, and the good ones are right.
mod bench;
mod interpreter;

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{Config, Profile};
use reliefrtl::golden::{Pyramid, RayInput, encode_ray};

/// Levels of the map.
const LEVELS: u32 = 3;

/// A configuration with a small map and few steps; `profile` by name.
fn config(sets: &[&str], profile: Option<Profile>) -> Config {
    let mut c = Config::default();
    ["traverse.levels=3", "traverse.step_limit=60"].iter().for_each(|set| c.apply_set(set).unwrap());
    sets.iter().filter(|s| !s.starts_with("latency")).for_each(|set| c.apply_set(set).unwrap());
    if let Some(profile) = profile {
        c.latency = profile.latency_for(&c.design());
    }
    sets.iter().filter(|s| s.starts_with("latency")).for_each(|set| c.apply_set(set).unwrap());
    c.validate().unwrap_or_else(|e| panic!("{sets:?}: {e}"));
    c
}

/// A map and rays over it, every tenth of them no ray at all where the numbers can say so.
fn scene(c: &Config, rays: usize) -> (Pyramid, Vec<RayInput>) {
    let d = c.design();
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let texels: Vec<u32> = (0..1 << (2 * LEVELS)).map(|_| rng.random_range(0..=255u32)).collect();
    let mut ray = |k: usize| {
        let far = if k % 10 == 9 { 40.0 } else { 1.5 };
        let mut travel = || (rng.random::<f64>() - 0.5) * 2.0 * far;
        let (du, dv) = (travel(), travel());
        encode_ray(&d, [rng.random(), rng.random(), du, dv])
    };
    let rays = (0..rays).map(|k| RayInput { lod: k as u32 % 4, ..ray(k) }).collect();
    (Pyramid::build(LEVELS, d.traverse.height_bits, &texels).unwrap(), rays)
}

/// What is unknown of a ray's word of `width` bits: nothing of the good ones, all words, one bit of one word, or one whole word.
fn unknown_bits(ray: usize, word: usize, words: usize, width: u32) -> u64 {
    let all = reliefrtl::bits::mask(width);
    match ray % 5 {
        2 => all,
        3 if ray / 5 % words == word => 1 << (ray as u32 * 7 % width),
        4 if ray / 5 % words == word => all,
        _ => 0,
    }
}
