//! As `met`, in fixed point: rows as a traced ray brings them to the units.
use crate::bits::mask;
use crate::config::Design;
use crate::golden::fixed::{Fixed, FixedAxis};
use crate::golden::{RayInput, decode_travel};
use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Puts into `rows` of `unit` what rays bring; ports that no ray decides keep their word. False, and nothing is changed, if the unit is
/// no part of the traversal or no datapath exists at `d`.
pub fn meet(unit: &str, ports: &[&str], d: &Design, idx: u32, seed: u64, rows: &mut [Vec<u64>]) -> bool {
    let of_rays = [
        "ray_setup",
        "reciprocal",
        "start_level",
        "hit_position",
        "plane_time",
        "predicted_hit",
        "chord_end",
        "chord_trim",
        "height_test",
        "node_crossing",
        "multi_level_down",
        "level_up",
    ];
    let Some(golden) = Fixed::new(d).ok().filter(|_| of_rays.contains(&unit)) else { return false };
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(1);
    for row in rows {
        let moment = Moment::any(&golden, idx, &mut rng);
        for (slot, port) in row.iter_mut().zip(ports) {
            *slot = moment.word(unit, port).unwrap_or(*slot);
        }
    }
    true
}

/// A ray at some level and parameter; indices are words of IDX_W bits.
struct Moment {
    ray: RayInput,
    level: u32,
    axes: [Side; 2],
    height: u64,
    t: u64,
    m: u64,
}

/// What a moment says about one axis.
struct Side {
    a: FixedAxis,
    at: u64,
    low: u64,
    high: u64,
    plane: u64,
    hit: u64,
    reach: u64,
    last: u64,
    t_plane: u64,
    entry: u64,
    end: u64,
}

impl Moment {
    fn any(g: &Fixed, idx: u32, rng: &mut ChaCha8Rng) -> Self {
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
        let mut axes = [setup.u, setup.v].map(|a| Side::at(g, a, level, m, idx, rng));
        // Both planes at once, and planes that are met exactly at the node's height or at the entry.
        match rng.random_range(0..12) {
            0 => axes[1].t_plane = axes[0].t_plane,
            1 => axes[rng.random_range(0..2)].t_plane = m,
            2 => axes[rng.random_range(0..2)].t_plane = t,
            _ => {}
        }
        Self { ray, level, axes, height, t, m }
    }

    fn word(&self, unit: &str, port: &str) -> Option<u64> {
        let s = &self.axes[usize::from(port.starts_with('y') || port == "t_y")];
        let r = &self.ray;
        Some(match (unit, port) {
            ("start_level", "x" | "y") => s.entry,
            ("start_level", "x_end" | "y_end") => s.end,
            ("hit_position", "x") => s.at,
            (_, "u") => r.u,
            (_, "v") => r.v,
            (_, "du") => r.du,
            (_, "dv") => r.dv,
            (_, "a") => s.a.a,
            (_, "p") => s.a.p,
            (_, "s") => s.a.s,
            (_, "r") => s.a.r,
            (_, "z") => u64::from(s.a.z),
            (_, "neg" | "x_neg" | "y_neg") => u64::from(s.a.neg),
            (_, "plane") => s.plane,
            (_, "height") => self.height,
            (_, "level") => u64::from(self.level),
            (_, "t") => self.t,
            (_, "m") => self.m,
            (_, "t_x" | "t_y") => s.t_plane,
            (_, "x_low" | "y_low") => s.low,
            (_, "x_high" | "y_high") => s.high,
            (_, "x_at" | "y_at") => s.at,
            (_, "x_hit" | "y_hit") => s.hit,
            (_, "x_reach" | "y_reach") => s.reach,
            (_, "x_last" | "y_last") => s.last,
            _ => return None,
        })
    }
}

impl Side {
    fn at(g: &Fixed, a: FixedAxis, level: u32, m: u64, idx: u32, rng: &mut ChaCha8Rng) -> Self {
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
        Self { a, at, low, high, plane, hit, reach, last, t_plane, entry, end }
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
    debug_assert!(decode_travel(d, du) != -1 << (bits - 1));
    RayInput { u, v, du, dv, lod: 0 }
}
