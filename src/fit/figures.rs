//! What a search found, as numbers under names: what `fit --json` prints.
use super::{Fit, Rejected, Trial};
use crate::config::{DatapathConfig, ModeConfig, TraverseConfig, WindowsConfig};
use crate::measure::Cost;
use serde::Serialize;
use std::collections::BTreeMap;

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

/// The design that was found, what it does, and what was not taken.
#[derive(Clone, Debug, Serialize)]
pub struct FitFigures<'a> {
    /// Map and ray widths.
    pub traverse: TraverseConfig,
    /// Traversal modes.
    pub mode: ModeConfig,
    /// Datapath and its widths.
    pub datapath: DatapathConfig,
    /// Windows, where the search is by windows.
    pub windows: WindowsConfig,
    /// Exponent bits.
    pub exp: u32,
    /// Fraction bits.
    pub man: u32,
    /// Size, in bits.
    pub bits: Cost,
    /// On the rays of the search.
    pub search: TrialFigures,
    /// On fresh rays.
    pub fresh: TrialFigures,
    /// On the fresh rays of each view.
    pub fresh_by_view: BTreeMap<&'a str, TrialFigures>,
    /// A sentence for each decision.
    pub reasons: &'a [String],
    /// Designs that were not taken, each with the reason.
    pub rejected: &'a [Rejected],
    /// Designs tried.
    pub tried: usize,
}

impl<'a> FitFigures<'a> {
    /// The figures of a search that was checked on fresh rays, all together and view by view.
    pub fn new(found: &'a Fit, fresh: &Trial, by_view: &'a [(String, Trial)]) -> Self {
        let d = &found.chosen.design;
        Self {
            traverse: d.traverse,
            mode: d.mode,
            datapath: d.datapath,
            windows: d.windows,
            exp: d.format.exp,
            man: d.format.man,
            bits: found.chosen.cost,
            search: (&found.chosen).into(),
            fresh: fresh.into(),
            fresh_by_view: by_view.iter().map(|(view, t)| (view.as_str(), t.into())).collect(),
            reasons: &found.reasons,
            rejected: &found.rejected,
            tried: found.tried,
        }
    }
}
