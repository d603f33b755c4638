//! Hits of a view against the exact oracle.
use super::{Scene, encode};
use crate::config::Config;
use crate::error::Result;
use crate::golden::RayInput;
use crate::measure::{Spread, WrongTexel, accuracy, hex_words, uv_given};
use crate::scene::ViewRay;
use crate::trace::trace_golden;
use serde::Serialize;

/// What was measured of one view of one map. Errors of positions in texels, of the parameter t in height ranges.
#[derive(Clone, Debug, Serialize)]
pub struct JudgedView {
    /// The map.
    pub map: String,
    /// The view.
    pub view: String,
    /// Rays that were judged.
    pub rays: usize,
    /// Rays that end in another texel than the exact walk of the same words.
    pub wrong_texels: usize,
    /// Rays that end in the right texel and say "wall" where it is none, or the other way round.
    pub wrong_walls: usize,
    /// Rays that ended by the step limit.
    pub given_up: usize,
    /// Largest error of the parameter among right texels.
    pub worst_t: Worst,
    /// Against the exact walk of the ray's words.
    pub uv: Uv,
    /// Against the exact walk of the ray as it was given, before its rounding to words.
    pub uv_given: Uv,
}

/// A largest error, and the ray that has it.
#[derive(Clone, Debug, Serialize)]
pub struct Worst {
    /// The error.
    pub error: f64,
    /// The ray.
    pub ray: usize,
}

/// A distribution of position errors.
#[derive(Clone, Debug, Serialize)]
pub struct Uv {
    /// Rays.
    pub rays: u64,
    /// Half of the rays have at most this error.
    pub p50: f64,
    /// 99 of 100 have at most this error.
    pub p99: f64,
    /// The largest.
    pub max: f64,
    /// The ray that has it.
    pub max_ray: usize,
}

/// A ray that ends in a wrong texel.
#[derive(Clone, Debug, Serialize)]
pub struct Witness {
    /// The map.
    pub map: String,
    /// The view.
    pub view: String,
    /// The ray.
    pub ray: usize,
    /// The words u, v, du, dv in hex.
    pub words: [String; 4],
    /// The texel that the datapath returned.
    pub got: (u32, u32),
    /// That of the exact walk.
    pub exact: (u32, u32),
    /// How close the exact decision was, over the height range.
    pub margin: f64,
}

impl Uv {
    fn of(s: &Spread) -> Self {
        Self { rays: s.rays, p50: s.p50, p99: s.p99, max: s.max, max_ray: s.max_ray }
    }
}

/// Judges the rays of a view, in tiles of the design: their hits in the golden model against the exact walk.
///
/// # Errors
/// Operands too wide for the exact arithmetic.
pub fn judge_view(c: &Config, scene: &Scene, view: &str, seen: &[ViewRay]) -> Result<(JudgedView, Vec<Witness>)> {
    let rays: Vec<RayInput> = seen.iter().map(|x| encode(c, x)).collect();
    let hits = trace_golden(&c.design(), &scene.pyramid, &rays)?;
    let r = accuracy(&c.design(), &scene.texels, &rays, &hits)?;
    let (map, view) = (scene.name.clone(), view.to_owned());
    let witness = |w: &WrongTexel| Witness {
        map: map.clone(),
        view: view.clone(),
        ray: w.ray,
        words: hex_words(&rays[w.ray]),
        got: w.got,
        exact: w.exact,
        margin: w.margin,
    };
    let witnesses = r.wrong.iter().map(witness).collect();
    let numbers: Vec<[f64; 4]> = seen.iter().map(|r| [r.u, r.v, r.du, r.dv]).collect();
    let given = Spread::of(uv_given(&c.design(), &scene.texels, &numbers, &hits)?);
    let row = JudgedView {
        rays: r.rays,
        wrong_texels: r.wrong.len(),
        wrong_walls: r.wrong_wall,
        given_up: r.limits,
        worst_t: Worst { error: r.worst_t.0, ray: r.worst_t.1 },
        uv: Uv::of(&Spread::of(r.uv)),
        uv_given: Uv::of(&given),
        map,
        view,
    };
    Ok((row, witnesses))
}
