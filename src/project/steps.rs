//! Iterations of a scene's views in every mode of the published table.
use super::{Scene, encode};
use crate::config::modes::{published_rows, trimmed};
use crate::config::{Config, Design, ModeConfig, View};
use crate::error::Result;
use crate::golden::RayInput;
use crate::measure::steps;
use crate::scene::{RaySet, ViewRay};
use crate::trace::trace_golden;
use serde::Serialize;

/// The published rows, then those with fewer iterations, as far as the datapath has them; of four cells at once, which have modes of their own, the one of
/// the configuration.
pub fn step_rows(c: &Config) -> Vec<(String, ModeConfig)> {
    let has_mode = c.datapath.kind.facts().has_mode;
    if c.fetch.blocks() {
        return vec![(c.design().way(), c.mode)];
    }
    let row = |mode: ModeConfig| (Design { mode, ..c.design() }.way(), mode);
    published_rows().chain(trimmed()).filter(has_mode).map(row).collect()
}

/// Iterations of one view in one mode.
#[derive(Clone, Debug, Serialize)]
pub struct ModeSteps {
    /// The map.
    pub scene: String,
    /// The row of the table.
    pub row: String,
    /// The view.
    pub view: String,
    /// Mean iterations of the rays that end.
    pub iterations_per_ray: f64,
    /// The same under the name that it had first.
    pub mean: f64,
    /// The published mean, where there is one.
    pub published: Option<f64>,
    /// Largest number of iterations.
    pub max: u32,
    /// The ray that has it.
    pub max_ray: usize,
    /// Rays that end.
    pub rays: usize,
    /// Rays given up.
    pub given_up: usize,
}

/// A mean beside the published one.
#[derive(Clone, Debug)]
pub struct Beside {
    /// View and row.
    pub what: String,
    /// Ours / published - 1.
    pub off: f64,
    /// How far off it may be: what the published cameras are known to, and a grazing view hangs most on them.
    pub bound: f64,
}

/// A scene's table.
#[derive(Clone, Debug, Default)]
pub struct SceneSteps {
    /// A list a row, with each view in turn.
    pub rows: Vec<Vec<ModeSteps>>,
    /// The means that have a published one.
    pub beside: Vec<Beside>,
}

impl SceneSteps {
    /// Each row's means, summed over the views.
    pub fn sums(&self) -> impl Iterator<Item = f64> {
        self.rows.iter().map(|row| row.iter().fold(0.0, |sum, s| sum + s.mean))
    }
}

/// Counts the iterations of the rays of each view, in tiles of the design; `means` are published ones by row and view, of rows that are published.
///
/// # Errors
/// An illegal design.
pub fn scene_steps(
    c: &Config,
    scene: &Scene,
    views: &[(&RaySet, &[ViewRay])],
    means: Option<&[[Option<f64>; 3]; 7]>,
) -> Result<SceneSteps> {
    let mut out = SceneSteps::default();
    for (r, (name, mode)) in step_rows(c).into_iter().enumerate() {
        let mut d = c.design();
        d.mode = mode;
        let mut row = Vec::new();
        for (v, (set, rays)) in views.iter().enumerate() {
            let rays: Vec<RayInput> = rays.iter().map(|x| encode(c, x)).collect();
            let s = steps(&trace_golden(&d, &scene.pyramid, &rays)?);
            let published = means.filter(|_| published_rows().nth(r) == Some(mode));
            let published = published.and_then(|m| *m.get(r)?.get(v)?);
            out.beside.extend(published.map(|p| Beside {
                what: format!("{}, {}", set.name, name),
                off: s.mean / p - 1.0,
                bound: if set.standard() == Some(View::Grazing) { 0.1 } else { 0.03 },
            }));
            row.push(ModeSteps {
                scene: scene.name.clone(),
                row: name.clone(),
                view: set.name.clone(),
                iterations_per_ray: s.mean,
                mean: s.mean,
                published,
                max: s.max,
                max_ray: s.witness,
                rays: s.rays,
                given_up: s.limits,
            });
        }
        out.rows.push(row);
    }
    Ok(out)
}
