//! What a design does on a set of rays, as numbers under names.
use super::trial::Trial;
use serde::Serialize;

/// One design on one set of rays.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct TrialFigures {
    /// Rays.
    pub rays: usize,
    /// Rays whose texel is not the given ray's.
    pub wrong: usize,
    /// The first of them.
    pub wrong_ray: Option<usize>,
    /// Rays whose texel is not that of the ray as the design reads it.
    pub wrong_on_own_ray: usize,
    /// 99th percentile of the uv error, in texels of the given map.
    pub uv_p99: f64,
    /// The largest.
    pub uv_max: f64,
    /// The ray that has it.
    pub uv_max_ray: usize,
    /// Iterations a ray, mean.
    pub steps_mean: f64,
    /// The largest.
    pub steps_max: u32,
    /// The ray that has it.
    pub steps_max_ray: usize,
    /// Rays given up.
    pub given_up: usize,
}

impl From<&Trial> for TrialFigures {
    fn from(t: &Trial) -> Self {
        Self {
            rays: t.rays,
            wrong: t.wrong,
            wrong_ray: t.witness,
            wrong_on_own_ray: t.wrong_own,
            uv_p99: t.uv_p99,
            uv_max: t.uv_max.0,
            uv_max_ray: t.uv_max.1,
            steps_mean: t.steps.mean,
            steps_max: t.steps.max,
            steps_max_ray: t.steps.witness,
            given_up: t.steps.limits,
        }
    }
}
