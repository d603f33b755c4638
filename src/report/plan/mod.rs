//! What is measured: maps, views, designs, modes; every combination is a measurement.
mod design;
mod headline;
mod map;
mod select;
mod synthesized;

pub use design::DesignSpec;
pub use headline::Headline;
pub use map::{Map, MapSpec};
pub use select::{Extent, ModeSet, Selection};
pub use synthesized::{Synthesized, UnitFigures};

use crate::config::{Config, MapConfig, MapKind, View};
use crate::error::Result;
use crate::measure::PUBLISHED;
use crate::scene::{Camera, RaySet, RaySource};
use serde::Serialize;

/// A combination that has no datapath.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NotLegal {
    /// Design and mode.
    pub design: String,
    /// log2 of the map's side.
    pub levels: u32,
    /// Why.
    pub reason: String,
}

/// A measurement that is to be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Job {
    /// Index of its map.
    pub map: usize,
    /// Index of its rays.
    pub view: usize,
    /// Index of its design.
    pub design: usize,
}

/// Rays that designs are measured on.
#[derive(Clone, Debug)]
pub struct Rays {
    /// A view, or the user's rays.
    pub set: RaySet,
    /// Degrees above the plane, of the measurements that show what the angle does.
    pub elevation: Option<f64>,
    /// Every n-th pixel is traced.
    pub stride: u32,
}

/// All that is to be measured.
pub struct Plan {
    /// The configuration it started from; `traverse.levels` is the size at which designs are compared.
    pub config: Config,
    /// What was chosen.
    pub selection: Selection,
    /// Maps.
    pub maps: Vec<Map>,
    /// Designs with their modes, in the order of the page.
    pub designs: Vec<DesignSpec>,
    /// The designs that the page always names.
    pub headlines: Vec<Headline>,
    /// The rays: of each view, then of each elevation.
    pub rays: Vec<Rays>,
    /// Refused designs, once a map size.
    pub not_legal: Vec<NotLegal>,
    /// What is known of areas and clocks of traverse units.
    pub synthesized: Vec<Synthesized>,
    /// What is known of those of all units.
    pub units: Vec<UnitFigures>,
    /// The measurements.
    pub jobs: Vec<Job>,
}

/// Map sizes between, and elevations, at which few designs show what size and angle do.
const SIZES: [u32; 3] = [6, 9, 10];
const ELEVATIONS: [f64; 10] = [1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 22.0, 40.0, 60.0, 90.0];
/// Rays of an elevation, about.
const RAYS: usize = 10_000;

impl Plan {
    /// The plan of a configuration.
    ///
    /// # Errors
    /// A map that can't be read.
    pub fn new(c: &Config, selection: &Selection) -> Result<Self> {
        let mut c = c.clone();
        // What is refused is refused before maps are made.
        let units: Vec<Vec<UnitFigures>> =
            selection.synth.iter().map(|file| synthesized::load(file)).collect::<Result<_>>()?;
        if selection.scenes.is_some() {
            c.map.published_border()?;
        }
        if let Some(file) = &selection.map {
            (c.map.kind, c.map.file) = (MapKind::File, Some(file.clone()));
        }
        c.traverse.levels = selection.levels.first().copied().unwrap_or(c.traverse.levels);
        let maps = maps(&c, selection)?;
        let designs = selection.designs(&c);
        let headlines = headline::headlines(&c, &designs);
        let (jobs, not_legal, rays) = (Vec::new(), Vec::new(), Vec::new());
        let (selection, units) = (selection.clone(), units.concat());
        let synthesized = units.iter().filter_map(|e| Synthesized::of(e, &selection.traversals)).collect();
        let mut plan =
            Self { config: c, selection, maps, designs, headlines, rays, not_legal, synthesized, units, jobs };
        plan.fill()?;
        Ok(plan)
    }

    fn fill(&mut self) -> Result<()> {
        self.rays = [self.views()?, self.elevations()?].concat();
        for (map, at) in self.maps.iter().enumerate() {
            for (design, spec) in self.designs.iter().enumerate() {
                let levels = at.spec.levels;
                // On wide maps most rays of a datapath without the promise that they end run to the limit: modes would tell nothing, and cost most of
                // the time.
                let stuck = !spec.kind.facts().rays_end && levels != self.config.traverse.levels;
                let left_out = at.sweep || stuck && self.selection.extent != Extent::Full;
                if left_out && !self.followed(spec) {
                    continue;
                }
                if let Err(e) = spec.design(&self.config, levels) {
                    let name = format!("{}, {}", spec.label(), spec.way());
                    let refused = NotLegal { design: name, levels, reason: e.to_string().replace("\n  - ", " ") };
                    if !self.not_legal.contains(&refused) {
                        self.not_legal.push(refused);
                    }
                    continue;
                }
                let angles = map == 0 && self.followed(spec);
                let wanted = (0..self.rays.len()).filter(|k| angles || self.rays[*k].elevation.is_none());
                self.jobs.extend(wanted.map(|view| Job { map, view, design }));
            }
        }
        Ok(())
    }

    /// The chosen views, every n-th pixel of each: about as many rays of one as of another.
    fn views(&self) -> Result<Vec<Rays>> {
        let strides = if self.selection.extent == Extent::Tiny { [64, 48, 16] } else { [8, 7, 2] };
        let one = |set: RaySet| {
            let stride = match set.standard() {
                Some(view) => strides[view as usize],
                None => self.stride(&set)?,
            };
            Ok(Rays { set, elevation: None, stride })
        };
        self.selection.views().into_iter().map(one).collect()
    }

    /// Elevations of the measurements by angle.
    fn elevations(&self) -> Result<Vec<Rays>> {
        if !self.selection.views.is_empty() {
            return Ok(Vec::new());
        }
        let one = |e: &f64| {
            let size = &self.config.view;
            let camera = Camera { elevation: *e, ..Camera::standard(View::Oblique, size.width, size.height) };
            let name = View::Oblique.word().to_owned();
            let set = RaySet { given: name.clone(), name, source: RaySource::Camera(camera) };
            Ok(Rays { stride: self.stride(&set)?, set, elevation: Some(*e) })
        };
        let tiny = self.selection.extent == Extent::Tiny;
        ELEVATIONS.iter().step_by(if tiny { 5 } else { 1 }).map(one).collect()
    }

    /// Every n-th pixel of a camera, such that about [`RAYS`] rays meet the first map; 1 of a table.
    fn stride(&self, set: &RaySet) -> Result<u32> {
        let size = &self.config.view;
        let Some(camera) = set.camera(size.width, size.height) else { return Ok(1) };
        // Small pictures are looked at whole.
        let step = (camera.width.min(camera.height) / 16).clamp(1, 16);
        let rays = self.maps[0].set(&self.config, set, step)?.len();
        let all = rays as f64 * f64::from(step * step);
        let wanted = if self.selection.extent == Extent::Tiny { RAYS / 100 } else { RAYS };
        Ok(((all / wanted as f64).sqrt() as u32).clamp(1, 64))
    }

    /// True for the designs whose error is followed along angle and map size.
    pub fn followed(&self, d: &DesignSpec) -> bool {
        let narrow = d.kind.facts().modes_agree && (d.exp, d.man) == (Some(7), Some(10));
        narrow || self.headlines.iter().any(|h| h.design == *d)
    }
}

/// The maps: own ones or the user's, the first also in other sizes, and the published ones.
fn maps(c: &Config, s: &Selection) -> Result<Vec<Map>> {
    let n = c.traverse.levels;
    let usual = [MapKind::Rocks, MapKind::Spikes, MapKind::Dunes, MapKind::Bricks];
    let kinds: Vec<MapKind> = match (c.map.kind, s.extent) {
        _ if !s.maps.is_empty() => s.maps.clone(),
        (MapKind::File, _) => vec![MapKind::File],
        (_, Extent::Tiny) => vec![MapKind::Spikes],
        (first, _) => [first].into_iter().chain(usual.into_iter().filter(|k| *k != first)).collect(),
    };
    // A file has the size that it has, unless resampling was asked for.
    let sizes = kinds[0] != MapKind::File || c.map.resample;
    let wide = if s.extent == Extent::Tiny || !sizes { n } else { n.max(11) };
    let levels: Vec<u32> = if s.levels.is_empty() { vec![n, wide] } else { s.levels.clone() };
    let mut wanted: Vec<(MapKind, u32, bool)> = kinds.iter().map(|k| (*k, n, false)).collect();
    for &l in &levels {
        // Chosen sizes are of all maps.
        let of = if s.levels.is_empty() { &kinds[..1] } else { &kinds[..] };
        wanted.extend(of.iter().map(|k| (*k, l, false)));
    }
    if s.levels.is_empty() && s.extent != Extent::Tiny && sizes {
        wanted.extend(SIZES.map(|l| (kinds[0], l, true)));
    }
    let mut maps: Vec<Map> = Vec::new();
    for (kind, levels, sweep) in wanted {
        if maps.iter().any(|x| (x.spec.kind, x.spec.levels) == (kind, levels)) {
            continue;
        }
        let file = c.map.file.clone().filter(|_| kind == MapKind::File);
        let map = MapConfig { kind, file, ..c.map.clone() };
        maps.push(Map::new(c, &map, levels, sweep)?);
    }
    for p in PUBLISHED.iter().filter(|_| s.scenes.is_some()) {
        let file = s.scenes.as_ref().map(|dir| dir.join(format!("{}.png", p.scene)));
        let map = MapConfig { kind: MapKind::File, file, scale: p.scale, repeat: p.repeat, ..c.map.clone() };
        maps.push(Map::new(c, &map, n, false)?);
    }
    Ok(maps)
}
