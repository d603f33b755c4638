//! Rows as a traced ray brings them to the units of the published datapath.
use super::{any_ray, edge};
use crate::bits::mask;
use crate::config::Design;
use crate::golden::float as gf;
use crate::golden::{Exit, Published, Travel};
use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Puts into `rows` of `unit` what rays bring; false, and nothing is changed, if the unit is no part of this datapath or no such datapath
/// exists at `d`.
pub fn meet(unit: &str, ports: &[&str], d: &Design, idx: u32, seed: u64, rows: &mut [Vec<u64>]) -> bool {
    let Some(word) = words(unit) else { return false };
    let Ok(golden) = Published::new(d) else { return false };
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(1);
    for row in rows {
        let moment = Moment::any(&golden, idx, &mut rng);
        for (slot, port) in row.iter_mut().zip(ports) {
            *slot = word(port, &moment).unwrap_or(*slot);
        }
    }
    true
}

/// A ray at some level and parameter; indices are words of IDX_W bits.
struct Moment {
    ray: [u64; 4],
    level: u32,
    axes: [Side; 2],
    height: u64,
    t: u64,
    m: u64,
    t_exit: u64,
}

/// What a moment says about one axis.
#[derive(Clone, Copy)]
struct Side {
    travel: Travel,
    exit: Exit,
    entry: u64,
    end: u64,
    at: u64,
    plane: u64,
    hit: u64,
    hit_texel: u64,
    cross: u64,
}

type Word = fn(&str, &Moment) -> Option<u64>;

fn words(unit: &str) -> Option<Word> {
    Some(match unit {
        "ray_scale" => |p, m| ["u", "v", "du", "dv"].iter().position(|n| *n == p).map(|k| m.ray[k]),
        "start_level" => |p, m| {
            let [u, v] = m.axes;
            [("x", u.entry), ("y", v.entry), ("x_end", u.end), ("y_end", v.end)].iter().find(|w| w.0 == p).map(|w| w.1)
        },
        "exit_plane" | "boundary_time" | "ray_point" | "texel_fraction" => one_axis,
        "level_up" => |p, m| match p {
            // It looks at texels, the others at positions.
            "x_hit" => Some(m.axes[0].hit_texel),
            "y_hit" => Some(m.axes[1].hit_texel),
            _ => both_axes(p, m),
        },
        "surface_time" | "nearer_plane" | "crossing_test" | "level_choice" => both_axes,
        _ => return None,
    })
}

fn one_axis(port: &str, m: &Moment) -> Option<u64> {
    let s = &m.axes[0];
    Some(match port {
        "level" => u64::from(m.level),
        "x" => s.at,
        "neg" => u64::from(s.travel.neg),
        "plane" => s.plane,
        "p" => s.travel.p,
        "d" => s.travel.d,
        "t" => m.m,
        _ => return None,
    })
}

fn both_axes(port: &str, m: &Moment) -> Option<u64> {
    let s = &m.axes[usize::from(port.starts_with('y') || port == "t_y")];
    Some(match port.trim_start_matches("x_").trim_start_matches("y_") {
        "height" => m.height,
        "level" => u64::from(m.level),
        "t" => m.t,
        "m" => m.m,
        "t_x" | "t_y" => s.exit.t,
        "t_exit" => m.t_exit,
        "at" => s.at,
        "hit" => s.hit,
        "cross" => s.cross,
        "edge" => s.exit.edge,
        "neg" => u64::from(s.travel.neg),
        _ => return None,
    })
}

impl Moment {
    fn any(g: &Published, idx: u32, rng: &mut ChaCha8Rng) -> Self {
        let (f, size) = (g.design().format, g.design().traverse);
        let (mut ray, route) = loop {
            let r = any_ray(g.design(), rng);
            if let Some(route) = g.route(&r) {
                break ([r.u, r.v, r.du, r.dv], route);
            }
        };
        let most = (1u64 << size.height_bits) - 1;
        let height = rng.random_range(0..=most);
        let t_v = g.top(height as u32);
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
        let mut axes = [route.u, route.v].map(|a| Side::at(g, a, level, [t, m], idx, rng));
        // Both planes at once, a plane at the ray's end, a hit on a plane.
        match rng.random_range(0..12) {
            0 => axes[1].exit.t = axes[0].exit.t,
            1 => axes[rng.random_range(0..2)].exit.t = gf::from_int(f, 1) + rng.random_range(0..2),
            2 => {
                let s = &mut axes[rng.random_range(0..2)];
                s.hit = s.exit.edge;
            }
            _ => {}
        }
        let [t_x, t_y] = axes.map(|s| s.exit.t);
        let t_exit = if gf::lt(f, t_y, t_x) { t_y } else { t_x };
        for s in &mut axes {
            s.cross = g.position(&s.travel, t_exit);
        }
        if rng.random_range(0..4) == 0 {
            let k = rng.random_range(0..4);
            ray[k] = edge(g.design(), k < 2, rng);
        }
        Self { ray, level, axes, height, t, m, t_exit }
    }
}

impl Side {
    fn at(g: &Published, travel: Travel, level: u32, [t, m]: [u64; 2], idx: u32, rng: &mut ChaCha8Rng) -> Self {
        // A ray on a border of texels may stand in either.
        let at = g.texel(g.position(&travel, t)) + *[0, 0, 0, 0, -1, 1].choose(rng).expect("not empty");
        let exit = g.exit(&travel, level, at);
        let hit = g.position(&travel, m);
        let size = 1i64 << level;
        let hit_texel = match rng.random_range(0..3) {
            0 => g.texel(hit),
            // In this node or up to two nodes further.
            _ => at.div_euclid(size) * size + rng.random_range(-2 * size..3 * size),
        };
        let end = g.texel(g.position(&travel, gf::from_int(g.design().format, 1)));
        let index = |v: i64| v as u64 & mask(idx);
        let [entry, end, at, plane, hit_texel] = [travel.x, end, at, exit.plane, hit_texel].map(index);
        Self { travel, exit, entry, end, at, plane, hit, hit_texel, cross: 0 }
    }
}
