//! Wrong texels and position errors on the published scenes, in floating and in fixed point.
use super::{Scene, encode};
use crate::config::{Config, DatapathKind, MapKind, View, datapaths};
use crate::error::Result;
use crate::golden::RayInput;
use crate::measure::{Accuracy, PUBLISHED, Published, accuracy, hex_words};
use crate::trace::trace_golden;
use serde::Serialize;
use std::path::Path;

/// The larger size: the same maps, resampled.
const WIDE: u32 = 11;

/// A ray and where it is.
#[derive(Clone, Debug, Serialize)]
pub struct Found {
    /// The scene.
    pub scene: &'static str,
    /// The view.
    pub view: View,
    /// Index of the ray.
    pub ray: usize,
    /// The words u, v, du, dv in hex.
    pub words: [String; 4],
    /// What it was looked for: an error in texels, or a margin over the height range.
    pub value: f64,
}

/// What one datapath makes of all scenes at one size.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Rate {
    /// The datapath and its numbers.
    pub datapath: String,
    /// Texels a side.
    pub texels: u32,
    /// Rays traced.
    pub rays: usize,
    /// Rays in a wrong texel.
    pub wrong: usize,
    /// The same, in per cent.
    pub wrong_percent: f64,
    /// Rays given up.
    pub given_up: usize,
    /// The position error that 99 of 100 hits do not exceed, in texels: one that some ray has.
    pub uv_p99: f64,
    /// The largest position error.
    pub uv_largest: Option<Found>,
    /// The wrong texel whose exact decision had the largest margin.
    pub worst_wrong: Option<Found>,
    #[serde(skip)]
    errors: Vec<f64>,
}

/// The rates on the maps in `dir`, of the configured datapath if it is the published one, which stands apart, else of the others; `tell` hears what is
/// under way.
///
/// # Errors
/// A scene that can't be read; a configuration that is not legal at a size.
pub fn published_rates(c: &Config, dir: &Path, tell: &dyn Fn(String)) -> Result<Vec<Rate>> {
    c.map.published_border()?;
    // Beside each other stand those that find the same hits in every mode; one that does not stands alone, where it is asked for.
    let own = c.datapath.kind;
    let beside = |k: &DatapathKind| if own.facts().modes_agree { k.facts().modes_agree } else { *k == own };
    let kinds: Vec<DatapathKind> = datapaths().filter(beside).collect();
    let mut rates = Vec::new();
    let mut sizes = vec![c.traverse.levels, WIDE];
    sizes.dedup();
    for levels in sizes {
        for kind in &kinds {
            let mut c = c.clone();
            (c.traverse.levels, c.map.kind) = (levels, MapKind::File);
            c.choose_datapath(*kind);
            c.map.file = Some(dir.join("-"));
            c.validate()?;
            let mut rate = Rate { datapath: c.design().label(), texels: 1 << levels, ..Rate::default() };
            for p in &PUBLISHED {
                tell(format!("{} on {}, {} texels", rate.datapath, p.scene, rate.texels));
                rate.scene(&mut c, p, dir)?;
            }
            rates.push(rate.summed());
        }
    }
    Ok(rates)
}

impl Rate {
    fn scene(&mut self, c: &mut Config, p: &Published, dir: &Path) -> Result<()> {
        (c.map.scale, c.map.repeat) = (p.scale, p.repeat);
        // The maps have 256 texels a side; another size is asked for here, so it need not be asked for again.
        let scene = Scene::new(c, Some(&dir.join(format!("{}.png", p.scene))), c.traverse.levels == WIDE)?;
        for view in View::ALL {
            let rays: Vec<RayInput> = scene.view(c, view, c.view.stride)?.iter().map(|r| encode(c, r)).collect();
            let hits = trace_golden(&c.design(), &scene.pyramid, &rays)?;
            let a = accuracy(&c.design(), &scene.texels, &rays, &hits)?;
            self.add((p.scene, view), &rays, &a);
        }
        Ok(())
    }

    fn add(&mut self, (scene, view): (&'static str, View), rays: &[RayInput], a: &Accuracy) {
        let found = |ray: usize, value| Found { scene, view, ray, words: hex_words(&rays[ray]), value };
        let larger = |old: &Option<Found>, value: f64| old.as_ref().is_none_or(|f| value > f.value);
        self.rays += a.rays;
        self.given_up += a.limits;
        self.wrong += a.wrong.len();
        for w in &a.wrong {
            if larger(&self.worst_wrong, w.margin) {
                self.worst_wrong = Some(found(w.ray, w.margin));
            }
        }
        for &(error, ray) in &a.uv {
            self.errors.push(error);
            if larger(&self.uv_largest, error) {
                self.uv_largest = Some(found(ray, error));
            }
        }
    }

    fn summed(mut self) -> Self {
        self.errors.sort_by(f64::total_cmp);
        self.uv_p99 = self.errors.get((self.errors.len() * 99).div_ceil(100).max(1) - 1).copied().unwrap_or(0.0);
        self.wrong_percent = 100.0 * self.wrong as f64 / self.rays.max(1) as f64;
        self
    }
}
