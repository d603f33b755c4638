//! Samples of rays of the published datapath.
use super::watertight::{any_ray, edge};
use super::{AxisSample, RaySample};
use crate::bits::mask;
use crate::golden::float as gf;
use crate::golden::{Datapath, Published, Travel};
use rand::Rng;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;

/// A ray that can be traced, somewhere on its way.
pub fn sample(g: &Published, idx: u32, rng: &mut ChaCha8Rng) -> RaySample {
    let (f, size) = (g.design().format, g.design().traverse);
    let (mut ray, route) = loop {
        let r = any_ray(g.design(), rng);
        if let Some(route) = g.route(&r) {
            break ([r.u, r.v, r.du, r.dv], route);
        }
    };
    let most = (1u64 << size.height_bits) - 1;
    let height = rng.random_range(0..=most);
    let t_v = g.height_time(height as u32);
    let level = rng.random_range(0..=size.levels);
    // Somewhere on the way; where the node's height is met, or just beside; or where a crossing left the ray.
    let t = match rng.random_range(0..6) {
        0 => t_v,
        1 => (t_v + rng.random_range(0..=2)).saturating_sub(1),
        2 | 3 => {
            let axis = *[route.u, route.v].choose(rng).expect("two");
            let way = g.exit(&axis, level, g.texel(g.position(&axis, gf::from_f64(f, rng.random()))));
            if gf::lt(f, 0, way.t) && gf::lt(f, way.t, gf::from_int(f, 1)) { way.t } else { 0 }
        }
        _ => gf::from_f64(f, rng.random::<f64>().powi(rng.random_range(1..4))),
    };
    let m = if gf::lt(f, t, t_v) { t_v } else { t };
    let travels = [route.u, route.v];
    let mut axes = travels.map(|a| axis_sample(g, a, level, [t, m], idx, rng));
    // Both planes at once, a plane at the ray's end, a hit on a plane.
    match rng.random_range(0..12) {
        0 => axes[1].t_plane = axes[0].t_plane,
        1 => axes[rng.random_range(0..2)].t_plane = gf::from_int(f, 1) + rng.random_range(0..2),
        2 => {
            let s = &mut axes[rng.random_range(0..2)];
            s.position = s.edge;
        }
        _ => {}
    }
    let [t_x, t_y] = axes.map(|s| s.t_plane);
    let t_exit = if gf::lt(f, t_y, t_x) { t_y } else { t_x };
    for (s, travel) in axes.iter_mut().zip(&travels) {
        s.cross = g.position(travel, t_exit);
    }
    if rng.random_range(0..4) == 0 {
        let k = rng.random_range(0..4);
        ray[k] = edge(g.design(), k < 2, rng);
    }
    RaySample { ray, level: u64::from(level), axes, height, t, m, t_exit }
}

fn axis_sample(
    g: &Published,
    travel: Travel,
    level: u32,
    [t, m]: [u64; 2],
    idx: u32,
    rng: &mut ChaCha8Rng,
) -> AxisSample {
    // A ray on a border of texels may stand in either.
    let at = g.texel(g.position(&travel, t)) + *[0, 0, 0, 0, -1, 1].choose(rng).expect("not empty");
    let exit = g.exit(&travel, level, at);
    let position = g.position(&travel, m);
    let size = 1i64 << level;
    let hit = match rng.random_range(0..3) {
        0 => g.texel(position),
        // In this node or up to two nodes further.
        _ => at.div_euclid(size) * size + rng.random_range(-2 * size..3 * size),
    };
    let end = g.texel(g.position(&travel, gf::from_int(g.design().format, 1)));
    let index = |v: i64| v as u64 & mask(idx);
    let [entry, end, at, plane, hit] = [travel.x, end, at, exit.plane, hit].map(index);
    AxisSample {
        p: travel.p,
        d: travel.d,
        neg: u64::from(travel.neg),
        entry,
        end,
        at,
        plane,
        edge: exit.edge,
        t_plane: exit.t,
        hit,
        position,
        ..AxisSample::default()
    }
}
