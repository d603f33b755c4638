//! Samples of rays in fixed point.
use super::{AxisSample, RaySample};
use crate::bits::mask;
use crate::config::Design;
use crate::golden::fixed::{Fixed, FixedAxis, travel as travel_value};
use crate::golden::{Datapath, RayInput};
use rand::Rng;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;

/// A ray that can be traced, somewhere on its way.
pub fn sample(g: &Fixed, idx: u32, rng: &mut ChaCha8Rng) -> RaySample {
    let size = g.design().traverse;
    let ray = any_ray(g.design(), rng);
    let setup = g.setup(&ray);
    let height = rng.random_range(0..1u64 << size.height_bits);
    let (t_v, bottom) = (g.height_time(height), g.height_time(0));
    // Where the node's height is met, or just beside; or anywhere.
    // Or where a plane is met, or just beside: only there a last bit moves a floor.
    let t = match rng.random_range(0..6) {
        0 => t_v,
        5 => (border(g, &setup.u, rng) + rng.random_range(0..3)).saturating_sub(1).min(bottom),
        1 => (t_v + rng.random_range(0..3)).saturating_sub(1).min(bottom),
        2 => rng.random_range(0..=bottom) >> rng.random_range(0..size.height_bits),
        _ => rng.random_range(0..=bottom),
    };
    let m = t.max(t_v);
    let level = rng.random_range(0..=size.levels);
    let mut axes = [setup.u, setup.v].map(|a| axis_sample(g, a, level, m, idx, rng));
    // Both planes at once, and planes that are met exactly at the node's height or at the entry.
    match rng.random_range(0..12) {
        0 => axes[1].t_plane = axes[0].t_plane,
        1 => axes[rng.random_range(0..2)].t_plane = m,
        2 => axes[rng.random_range(0..2)].t_plane = t,
        _ => {}
    }
    let ray = [ray.u, ray.v, ray.du, ray.dv];
    RaySample { ray, level: u64::from(level), axes, height, t, m, ..RaySample::default() }
}

fn axis_sample(g: &Fixed, a: FixedAxis, level: u32, m: u64, idx: u32, rng: &mut ChaCha8Rng) -> AxisSample {
    let t = &g.design().traverse;
    // A ray on a border of texels may stand in either; one further off is clamped.
    let at = g.estimate(&a, m) + *[0, 0, 0, 0, -1, 1].choose(rng).expect("not empty");
    let size = 1i64 << level;
    let first = at & -size;
    let (low, high) = if a.neg { (first, at) } else { (at, first + size - 1) };
    let plane = if a.neg { first } else { first + size };
    let hit = match rng.random_range(0..3) {
        0 => g.estimate(&a, m),
        1 => rng.random_range(low - 2..=high + 2),
        // In this node or up to two nodes further.
        _ => first + rng.random_range(-2 * size..3 * size),
    };
    let away = ((plane << (g.design().datapath.fraction_bits - t.levels)) - a.p as i64).unsigned_abs();
    let t_plane = g.plane_time(away, a.r, a.z);
    let index = |v: i64| v as u64 & mask(idx);
    // Where the ray is or further on; or the other texel, which may be anywhere near.
    let reach = if rng.random() { g.chord_end(&a, m) } else { hit };
    let [entry, end, at, low, high, plane] = [a.x, a.xa, at, low, high, plane].map(index);
    let [hit, reach, last] = [hit, reach, a.le].map(index);
    AxisSample {
        p: a.p,
        a: a.a,
        s: a.s,
        r: a.r,
        z: u64::from(a.z),
        neg: u64::from(a.neg),
        entry,
        end,
        last,
        at,
        low,
        high,
        plane,
        t_plane,
        hit,
        reach,
        ..AxisSample::default()
    }
}

/// The parameter of a plane that is on the way of a ray, or of the entry.
fn border(g: &Fixed, a: &FixedAxis, rng: &mut ChaCha8Rng) -> u64 {
    let size = g.design().datapath.fraction_bits - g.design().traverse.levels;
    let plane = rng.random_range(a.x.min(a.xa)..=a.x.max(a.xa)) + i64::from(!a.neg);
    g.plane_time(((plane << size) - a.p as i64).unsigned_abs(), a.r, a.z)
}

/// A ray that can be traced: entry points anywhere or on a border of texels, travels of every length, both axes on their own.
fn any_ray(d: &Design, rng: &mut ChaCha8Rng) -> RayInput {
    let (f, n, tile) = (d.datapath.fraction_bits, d.traverse.levels, d.traverse.tile_bits);
    let mut entry = || {
        let p = rng.random_range(0..1u64 << f);
        if rng.random_range(0..4) == 0 { p >> (f - n) << (f - n) } else { p }
    };
    let (u, v) = (entry(), entry());
    let bits = f + tile + 1;
    let mut travel = || {
        let far = (1i64 << (bits - 1)) - 1;
        let x = match rng.random_range(0..16) {
            0 => 0,
            1 => far,
            2 => 1 << rng.random_range(0..bits - 1),
            _ => rng.random_range(0..=far) >> rng.random_range(0..bits - 1),
        };
        if rng.random() { x } else { -x }
    };
    let [du, dv] = [travel(), travel()].map(|x| x as u64 & mask(bits));
    debug_assert!(travel_value(d, du) != -1 << (bits - 1));
    RayInput { u, v, du, dv, lod: 0 }
}
