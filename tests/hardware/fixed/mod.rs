//! The fixed-point datapath: units, traversal and emitted text against its golden model.
mod reciprocal;
mod simulators;
mod traverse;
mod units;

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{DatapathConfig, DatapathKind, Design, Profile};
use reliefrtl::golden::{Pyramid, RayInput, encode_ray};

/// Formats that are tried everywhere: fraction bits, reciprocal bits.
const FORMATS: [(u32, u32); 3] = [(24, 24), (20, 18), (12, 10)];

/// The default design in fixed point, with the registers of the published pipeline: what a ray takes in the interpreter grows with the slots of
/// the loop.
fn design(fraction_bits: u32, reciprocal_bits: u32) -> Design {
    let kind = DatapathKind::Fixed;
    Design {
        datapath: DatapathConfig { kind, fraction_bits, reciprocal_bits, nudge_bits: 0, ..DatapathConfig::default() },
        latency: Profile::Published.latency(kind),
        ..Design::default()
    }
}

/// A map of random heights, flat and spiky in places, and `count` rays: along axes, through corners, far, steep, and refused.
fn hard(d: &Design, count: usize, seed: u64) -> (Pyramid, Vec<RayInput>) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (n, h) = (d.traverse.levels, d.traverse.height_bits);
    let top = (1u32 << h) - 1;
    let texels: Vec<u32> =
        (0..1usize << (2 * n)).map(|_| rng.random_range(0..=top) >> rng.random_range(0..5)).collect();
    let side = f64::from(1u32 << n);
    let ray = |k: usize| {
        let mut grid = || (rng.random::<f64>() * side).floor() / side;
        let (a, b) = (grid(), grid());
        let mut far = || (rng.random::<f64>() - 0.5) * 8.0;
        let (c, e) = (far(), far());
        let (p, q) = (rng.random::<f64>(), rng.random::<f64>());
        encode_ray(
            d,
            match k % 7 {
                0 => [a, b, c, e],
                1 => [a, p, 0.0, c],
                2 => [a, b, 0.25, -0.25],
                3 => [p, b, c / 50.0, 0.0],
                4 => [p, q, 0.0, if k.is_multiple_of(2) { 0.0 } else { 1e9 }],
                5 => [a, q, c / 1e4, e / 1e6],
                _ => [p, q, c, e / 9.0],
            },
        )
    };
    let rays = (0..count).map(ray).collect();
    (Pyramid::build(n, h, &texels).unwrap(), rays)
}
