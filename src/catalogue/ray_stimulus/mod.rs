//! Rows as a traced ray brings them to the units of the traversal. Free combinations of words hardly ever are: most are no ray at all,
//! or a texel that the ray never sees, and a unit that clamps or refuses them hides what it computes.
pub(super) mod fixed;
pub(super) mod published;
pub(super) mod sample;
pub(super) mod watertight;
pub(super) mod windows;

use sample::AxisSample;
pub use sample::RaySample;

use super::datapath::sampler;
use super::unit::Stimulus;
use crate::config::Design;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Writes into `rows` what rays bring; ports that no ray decides keep their word. False, and nothing is changed, if no datapath exists at
/// `d`: a format too small for the map.
pub fn sample_rows(
    stimulus: Stimulus,
    ports: &[&str],
    d: &Design,
    idx_w: u32,
    seed: u64,
    rows: &mut [Vec<u64>],
) -> bool {
    let Some(sample) = sampler(d) else { return false };
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(1);
    for row in rows {
        let sample = sample(idx_w, &mut rng);
        for (slot, port) in row.iter_mut().zip(ports) {
            *slot = stimulus(&sample, port).unwrap_or(*slot);
        }
    }
    true
}

/// Of a setup: the ray.
pub fn whole_ray(s: &RaySample, port: &str) -> Option<u64> {
    ["u", "v", "du", "dv"].iter().position(|n| *n == port).map(|k| s.ray[k])
}

/// Of a setup that sees one axis: the ray along u.
pub fn first_axis(s: &RaySample, port: &str) -> Option<u64> {
    ["p", "d"].iter().position(|n| *n == port).map(|k| s.ray[2 * k])
}

/// Texels of the ray's ends.
pub fn both_ends(s: &RaySample, port: &str) -> Option<u64> {
    let [u, v] = &s.axes;
    Some(match port {
        "x" => u.entry,
        "y" => v.entry,
        "x_end" => u.end,
        "y_end" => v.end,
        _ => return None,
    })
}

/// A ray's constants along an axis, with its parameters.
pub fn one_axis(s: &RaySample, port: &str) -> Option<u64> {
    let a = &s.axes[0];
    Some(match port {
        "p" => a.p,
        "p_back" => a.p_back,
        "p_ahead" => a.p_ahead,
        "d" => a.d,
        "dn" => a.dn,
        "a" => a.a,
        "s" => a.s,
        "r" => a.r,
        "z" => a.z,
        "neg" => a.neg,
        "never" => a.never,
        "plane" => a.plane,
        "t" => s.t,
        "m" => s.m,
        _ => return None,
    })
}

/// A ray's constants along an axis for a search by windows, the planes that it has passed, and a window's height.
pub fn window_axis(s: &RaySample, port: &str) -> Option<u64> {
    let a = &s.axes[usize::from(port.ends_with("_y"))];
    Some(match port {
        "q" => a.step,
        "c" => a.begin,
        "k" => a.k,
        "travel" => a.travel,
        "offset" => a.offset,
        "height" => s.height,
        "end_x" | "end_y" => a.end_of_window,
        _ => return one_axis(s, port),
    })
}

/// As [`one_axis`], with the texel in which the ray is.
pub fn one_axis_in_node(s: &RaySample, port: &str) -> Option<u64> {
    if port == "x" { Some(s.axes[0].at) } else { one_axis(s, port) }
}

/// As [`one_axis`], where the surface is met.
pub fn one_axis_at_surface(s: &RaySample, port: &str) -> Option<u64> {
    if port == "t" { Some(s.m) } else { one_axis(s, port) }
}

/// A node along an axis, and the ray's direction.
pub fn one_node(s: &RaySample, port: &str) -> Option<u64> {
    if port == "level" { Some(s.level) } else { one_axis_in_node(s, port) }
}

/// What the loop knows of a node and of the ray's way through it; coordinates are texels.
pub fn both_axes(s: &RaySample, port: &str) -> Option<u64> {
    let a = &s.axes[usize::from(port.starts_with('y') || port == "t_y")];
    Some(match port.trim_start_matches("x_").trim_start_matches("y_") {
        "height" => s.height,
        "level" => s.level,
        "t" => s.t,
        "m" => s.m,
        "t_x" | "t_y" => a.t_plane,
        "low" => a.low,
        "high" => a.high,
        "at" => a.at,
        "hit" => a.hit,
        "neg" => a.neg,
        "bound" => a.reach,
        "last" => a.last,
        _ => return None,
    })
}

/// Parameters of a ray and of the planes of a block: some of them equal.
pub fn block_planes(s: &RaySample, port: &str) -> Option<u64> {
    let [u, v] = &s.axes;
    Some(match port {
        "t" => s.t,
        "far_x" => u.t_plane,
        "far_y" => v.t_plane,
        "mid_x" => s.m,
        "mid_y" if s.level.is_multiple_of(2) => u.t_plane,
        _ => return None,
    })
}

/// As [`both_axes`]; coordinates are positions.
pub fn both_positions(s: &RaySample, port: &str) -> Option<u64> {
    let a = &s.axes[usize::from(port.starts_with('y'))];
    Some(match port.trim_start_matches("x_").trim_start_matches("y_") {
        "hit" => a.position,
        "cross" => a.cross,
        "edge" => a.edge,
        "t_exit" => s.t_exit,
        _ => return both_axes(s, port),
    })
}

/// Windows and gaps of every size that a ray has; that they belong together does not matter to the units.
pub fn refined_hit(s: &RaySample, port: &str) -> Option<u64> {
    let [u, v] = &s.axes;
    Some(match port {
        "r_x" => u.r,
        "r_y" => v.r,
        "t" | "t_begin" => s.t,
        "t_end" => s.m,
        "gap_begin" => u.p,
        "gap_end" => v.d,
        _ => return None,
    })
}
