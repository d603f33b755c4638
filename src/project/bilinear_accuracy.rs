//! Refined hits of a view against the exact root (`mode.bilinear`).
use super::{Scene, encode};
use crate::config::Config;
use crate::error::Result;
use crate::measure::{Spread, bilinear};
use crate::scene::ViewRay;
use serde::Serialize;
use std::path::Path;

/// Rays of a view, evenly over the picture: the exact root costs far more than the exact walk.
pub const REFINED_RAYS: usize = 400;

/// What was measured of one view of one map.
#[derive(Clone, Debug, Serialize)]
pub struct RefinedView {
    /// The map.
    pub map: String,
    /// The view.
    pub view: String,
    /// Rays that were refined.
    pub rays: u64,
    /// Of these, those with a refined hit.
    pub hit: u64,
    /// Those that stay above the surface.
    pub above: u64,
    /// Those that enter below it.
    pub below: u64,
    /// Hits whose window has no root.
    pub hit_without_root: u64,
    /// Of the others, those whose window has one.
    pub root_not_seen: u64,
    /// Error of the parameter, in height codes.
    pub t: Three,
    /// Error of the position, in texels.
    pub uv: Three,
    /// The block hit's own, in texels.
    pub uv_of_block_hit: Three,
    /// The ray of the largest position error.
    pub max_ray: usize,
    /// The command that shows it again.
    pub command: String,
}

/// Three numbers of a distribution.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Three {
    /// Half of the rays have at most this.
    pub p50: f64,
    /// 99 of 100 have at most this.
    pub p99: f64,
    /// The largest.
    pub max: f64,
}

impl Three {
    fn of(s: &Spread) -> Self {
        Self { p50: s.p50, p99: s.p99, max: s.max }
    }
}

/// Measures some of a view's rays; `file` is the map that a command names.
///
/// # Errors
/// As [`bilinear`].
pub fn refined_view(
    c: &Config,
    scene: &Scene,
    file: Option<&Path>,
    view: &str,
    seen: &[ViewRay],
) -> Result<RefinedView> {
    let n = seen.len().min(REFINED_RAYS);
    let rays: Vec<ViewRay> = (0..n).map(|k| seen[k * seen.len() / n]).collect();
    let words: Vec<_> = rays.iter().map(|r| encode(c, r)).collect();
    let b = bilinear(&c.design(), &scene.pyramid, &scene.texels, &words)?;
    let [hit, above, below] = b.patches;
    Ok(RefinedView {
        map: scene.name.clone(),
        view: view.into(),
        rays: b.rays,
        hit,
        above,
        below,
        hit_without_root: b.rootless,
        root_not_seen: b.missed,
        t: Three::of(&b.t),
        uv: Three::of(&b.uv),
        uv_of_block_hit: Three::of(&b.uv_block),
        max_ray: b.uv.max_ray,
        command: b.command(c, file, &rays),
    })
}
