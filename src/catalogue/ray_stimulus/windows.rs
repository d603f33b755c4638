//! Samples of rays for a search by windows: a ray in fixed point, with its constants and the planes that it has passed.
use super::{RaySample, fixed};
use crate::config::{Design, WindowSet, WindowsConfig};
use crate::golden::fixed::Fixed;
use crate::golden::{Datapath, RayInput, Windows};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// The design with a set that every map has.
pub fn with_least_set(d: &Design) -> Design {
    Design { windows: WindowsConfig { set: Some(WindowSet::usual(2)) }, ..*d }
}

/// A ray that can be traced, somewhere on its way.
pub fn sample(g: &Windows, idx: u32, rng: &mut ChaCha8Rng) -> RaySample {
    let plain = Fixed::prepare(g.design()).expect("the design is legal: it has a model");
    let mut s = fixed::sample(&plain, idx, rng);
    let [u, v, du, dv] = s.ray;
    let axes = g.setup(&RayInput { u, v, du, dv, lod: 0 }).expect("the ray can be traced");
    for (sample, axis) in s.axes.iter_mut().zip(&axes) {
        // Where the estimate is, or a few planes before: an index may lag the ray.
        let passed = g.planes_passed(axis, s.m) as u64;
        let lag = rng.random_range(0..4) * rng.random_range(0..3);
        sample.k = passed.saturating_sub(lag);
        let number = u128::from(sample.k + rng.random_range(0..80u64));
        let most = u128::from(crate::bits::mask(g.widths().plane + 7));
        sample.end_of_window = (u128::from(axis.c) + number * u128::from(axis.q)).min(most) as u64;
        sample.step = axis.q;
        sample.begin = axis.c;
        sample.travel = axis.s;
        sample.offset = axis.o;
    }
    s
}
