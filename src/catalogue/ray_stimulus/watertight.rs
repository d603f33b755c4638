//! Samples of rays of the watertight datapath; entry points, travels and refused words of the published one, too.
use super::{AxisSample, RaySample};
use crate::bits::mask;
use crate::config::Design;
use crate::golden::float as gf;
use crate::golden::{Axis, Datapath, RayInput, Watertight};
use rand::Rng;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;

/// A ray that can be traced, somewhere on its way.
pub fn sample(g: &Watertight, idx: u32, rng: &mut ChaCha8Rng) -> RaySample {
    let (f, size) = (g.design().format, g.design().traverse);
    let (mut ray, setup) = loop {
        let r = any_ray(g.design(), rng);
        let s = g.setup(&r);
        if s.valid {
            break ([r.u, r.v, r.du, r.dv], s);
        }
    };
    let most = (1u64 << size.height_bits) - 1;
    let height = rng.random_range(0..=most);
    let t_v = gf::from_int(f, (most - height) as i64);
    // Somewhere on the way; where the node's height is met, or just beside; or next to a border of texels, because only there a
    // last bit moves a floor.
    let t = match rng.random_range(0..6) {
        0 => t_v,
        1 => beside(t_v, rng),
        2 => beside(border(g, &setup.u, setup.u.p, rng), rng),
        3 => beside(border(g, &setup.u, setup.u.pb, rng), rng),
        _ => gf::from_f64(f, most as f64 * rng.random::<f64>().powi(rng.random_range(1..4))),
    };
    let m = if gf::lt(f, t, t_v) { t_v } else { t };
    let level = rng.random_range(0..=size.levels);
    let mut axes = [setup.u, setup.v].map(|a| axis_sample(g, a, level, [t, m], idx, rng));
    // Both planes at once, and planes that are met exactly at the node's height or at the entry.
    match rng.random_range(0..12) {
        0 => axes[1].t_plane = axes[0].t_plane,
        1 => axes[rng.random_range(0..2)].t_plane = m,
        2 => axes[rng.random_range(0..2)].t_plane = t,
        _ => {}
    }
    if rng.random_range(0..4) == 0 {
        let k = rng.random_range(0..4);
        ray[k] = edge(g.design(), k < 2, rng);
    }
    RaySample { ray, level: u64::from(level), axes, height, t, m, ..RaySample::default() }
}

/// A parameter at which the ray, entering at `p`, meets a border of texels; 0 if it does not move.
fn border(g: &Watertight, a: &Axis, p: u64, rng: &mut ChaCha8Rng) -> u64 {
    let f = g.design().format;
    let (first, last) = (a.x.min(a.xa), a.x.max(a.xa));
    let away = gf::add(f, gf::from_int(f, rng.random_range(first..=last + 1)), gf::neg(f, p));
    let t = gf::div(f, away, a.dt);
    let on_the_way = gf::lt(f, 0, t) && gf::lt(f, t, gf::from_int(f, 1 << g.design().traverse.height_bits));
    if on_the_way { t } else { 0 }
}

/// A number or one of its two neighbours.
fn beside(t: u64, rng: &mut ChaCha8Rng) -> u64 {
    (t + rng.random_range(0..=2)).saturating_sub(1)
}

fn axis_sample(g: &Watertight, a: Axis, level: u32, [t, m]: [u64; 2], idx: u32, rng: &mut ChaCha8Rng) -> AxisSample {
    let f = g.design().format;
    let reach = |p: u64, t: u64| gf::to_int(f, gf::add(f, p, gf::mul(f, a.dt, t)), idx);
    // A ray on a border of texels may stand in either; one further off is clamped.
    let at = reach(a.p, t) + *[0, 0, 0, 0, -1, 1].choose(rng).expect("not empty");
    let size = 1i64 << level;
    let first = at & -size;
    let (low, high) = if a.neg { (first, at) } else { (at, first + size - 1) };
    let plane = if a.neg { first } else { first + size };
    let hit = match rng.random_range(0..3) {
        0 => reach(a.pb, m),
        1 => rng.random_range(low - 2..=high + 2),
        // In this node or up to two nodes further.
        _ => first + rng.random_range(-2 * size..3 * size),
    };
    let away = gf::add(f, gf::from_int(f, plane), gf::neg(f, a.p));
    let t_plane = if a.never { f.infinity() } else { gf::mul(f, away, a.r) };
    let index = |v: i64| v as u64 & mask(idx);
    // Where the ray is or further on; or the other texel, which may be anywhere near. No random bits of its own: those of others would change.
    let ahead = if t % 2 == 0 { reach(a.pf, t) } else { hit };
    let [entry, end, at, low, high] = [a.x, a.xa, at, low, high].map(index);
    AxisSample {
        p: a.p,
        p_back: a.pb,
        p_ahead: a.pf,
        d: a.dt,
        dn: a.dn,
        r: a.r,
        neg: u64::from(a.neg),
        never: u64::from(a.never),
        entry,
        end,
        last: index(a.le),
        at,
        low,
        high,
        plane: index(plane),
        t_plane,
        hit: index(hit),
        reach: index(ahead),
        ..AxisSample::default()
    }
}

/// Entry points anywhere or on a border of texels, travels of every length, both axes on their own.
pub(super) fn any_ray(d: &Design, rng: &mut ChaCha8Rng) -> RayInput {
    let (n, tile) = (d.traverse.levels as i32, d.traverse.tile_bits as i32);
    let side = 2f64.powi(n);
    let mut entry = || match rng.random_range(0..4) {
        0 => (rng.random::<f64>() * side).floor() / side,
        _ => rng.random::<f64>(),
    };
    let (u, v) = (entry(), entry());
    let mut travel = || {
        let sign = if rng.random::<bool>() { 1.0 } else { -1.0 };
        let length = 2f64.powi(rng.random_range(-n - 4..=tile)) * rng.random_range(0.5..1.0);
        sign * match rng.random_range(0..16) {
            0 => 0.0,
            1 => 2f64.powi(-rng.random_range(0..d.format.bias())),
            _ => length,
        }
    };
    let (du, dv) = (travel(), travel());
    RayInput::from_f64(d.format, u, v, du, dv)
}

/// What stands at an end of what setup accepts.
pub(super) fn edge(d: &Design, entry: bool, rng: &mut ChaCha8Rng) -> u64 {
    let f = d.format;
    let end = gf::from_f64(f, if entry { 1.0 } else { 2f64.powi(d.traverse.tile_bits as i32) });
    let v = [0, 1, f.man_mask(), 1 << f.man, end - 1, end, end + 1, f.infinity() - 1, f.infinity(), f.nan()];
    let sign = if rng.random_range(0..3) == 0 { f.sign_bit() } else { 0 };
    *v.choose(rng).expect("not empty") | sign
}
