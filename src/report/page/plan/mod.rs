//! What is measured: maps, views, designs, modes; every combination is a cell.
mod design;
mod headline;
mod select;
mod site;
mod synthesized;

pub use design::{BEST, DesignSpec, mode_label};
pub use headline::Headline;
pub use select::{Extent, ModeSet, Selection};
pub use site::{MapSpec, Site};
pub use synthesized::{Synthesized, UnitFigures};

use crate::config::{Config, DatapathKind, MapConfig, MapKind, View};
use crate::error::Result;
use crate::report::PUBLISHED;
use crate::scene::Camera;
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
    pub site: usize,
    /// View.
    pub view: View,
    /// Instead of the view's, degrees above the plane: of the measurements that show what the angle does.
    pub elevation: Option<f64>,
    /// Every n-th pixel is traced.
    pub stride: u32,
    /// Index of its design.
    pub design: usize,
}

impl Job {
    /// The camera for pictures of this many pixels.
    pub fn camera(&self, width: u32, height: u32) -> Camera {
        let standard = Camera::standard(self.view, width, height);
        Camera { elevation: self.elevation.unwrap_or(standard.elevation), ..standard }
    }
}

/// All that is to be measured.
pub struct Plan {
    /// The configuration it started from; `traverse.levels` is the size at which designs are compared.
    pub config: Config,
    /// What was chosen.
    pub selection: Selection,
    /// Maps.
    pub sites: Vec<Site>,
    /// Designs with their modes, in the order of the page.
    pub designs: Vec<DesignSpec>,
    /// The designs that the page always names.
    pub headlines: Vec<Headline>,
    /// Every n-th pixel of a view, by [`View::ALL`]: about as many rays of each.
    pub strides: [u32; 3],
    /// Refused designs, once a map size.
    pub not_legal: Vec<NotLegal>,
    /// What is known of areas and clocks of traverse units.
    pub synthesized: Vec<Synthesized>,
    /// What is known of those of all units.
    pub units: Vec<UnitFigures>,
    /// The measurements.
    pub cells: Vec<Job>,
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
        let (mut c, tiny) = (c.clone(), selection.extent == Extent::Tiny);
        if selection.scenes.is_some() {
            c.map.published_border()?;
        }
        if let Some(file) = &selection.map {
            (c.map.kind, c.map.file) = (MapKind::File, Some(file.clone()));
        }
        c.traverse.levels = selection.levels.first().copied().unwrap_or(c.traverse.levels);
        let sites = sites(&c, selection)?;
        let designs = selection.designs(&c);
        let headlines = headline::headlines(&c, &designs);
        let strides = if tiny { [64, 48, 16] } else { [8, 7, 2] };
        let (cells, not_legal) = (Vec::new(), Vec::new());
        let units: Vec<Vec<UnitFigures>> =
            selection.synth.iter().map(|file| synthesized::load(file)).collect::<Result<_>>()?;
        let (selection, units) = (selection.clone(), units.concat());
        let synthesized = units.iter().filter_map(Synthesized::of).collect();
        let mut plan =
            Self { config: c, selection, sites, designs, headlines, strides, not_legal, synthesized, units, cells };
        plan.fill()?;
        Ok(plan)
    }

    fn fill(&mut self) -> Result<()> {
        let (elevations, views) = (self.elevations()?, self.selection.views());
        for (site, at) in self.sites.iter().enumerate() {
            for (design, spec) in self.designs.iter().enumerate() {
                let levels = at.spec.levels;
                // On wide maps most rays of the published datapath run to the limit: modes would tell nothing, and cost most of the time.
                let stuck = spec.kind == DatapathKind::Published && levels != self.config.traverse.levels;
                let left_out = at.sweep || stuck && self.selection.extent != Extent::Full;
                if left_out && !self.followed(spec) {
                    continue;
                }
                if let Err(e) = spec.design(&self.config, levels) {
                    let name = format!("{}, {}", spec.label(), mode_label(&spec.mode));
                    let refused = NotLegal { design: name, levels, reason: e.to_string().replace("\n  - ", " ") };
                    if !self.not_legal.contains(&refused) {
                        self.not_legal.push(refused);
                    }
                    continue;
                }
                let job = |view, elevation, stride| Job { site, view, elevation, stride, design };
                let strides = self.strides;
                self.cells.extend(views.iter().map(|v| job(*v, None, strides[*v as usize])));
                if site == 0 && self.followed(spec) {
                    self.cells.extend(elevations.iter().map(|(e, stride)| job(View::Oblique, Some(*e), *stride)));
                }
            }
        }
        Ok(())
    }

    /// Elevations of the measurements by angle, with every n-th pixel that gives about as many rays of each.
    fn elevations(&self) -> Result<Vec<(f64, u32)>> {
        let tiny = self.selection.extent == Extent::Tiny;
        if !self.selection.views.is_empty() {
            return Ok(Vec::new());
        }
        let size = &self.config.view;
        let stride = |e: &f64| {
            let job = Job { site: 0, view: View::Oblique, elevation: Some(*e), stride: 16, design: 0 };
            let rays = self.sites[0].rays(&self.config, &job.camera(size.width, size.height), job.stride)?.len();
            let all = rays as f64 * f64::from(job.stride * job.stride);
            let wanted = if tiny { RAYS / 100 } else { RAYS };
            Ok((*e, ((all / wanted as f64).sqrt() as u32).clamp(1, 64)))
        };
        ELEVATIONS.iter().step_by(if tiny { 5 } else { 1 }).map(stride).collect()
    }

    /// Every n-th pixel of a view.
    pub fn stride(&self, view: View) -> u32 {
        self.strides[view as usize]
    }

    /// True for the designs whose error is followed along angle and map size.
    pub fn followed(&self, d: &DesignSpec) -> bool {
        let narrow = d.kind == DatapathKind::Watertight && (d.exp, d.man) == (Some(7), Some(10));
        narrow || self.headlines.iter().any(|h| h.design == *d)
    }
}

/// The maps: own ones or the user's, the first also in other sizes, and the published ones.
fn sites(c: &Config, s: &Selection) -> Result<Vec<Site>> {
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
    let mut sites: Vec<Site> = Vec::new();
    for (kind, levels, sweep) in wanted {
        if sites.iter().any(|x| (x.spec.kind, x.spec.levels) == (kind, levels)) {
            continue;
        }
        let file = c.map.file.clone().filter(|_| kind == MapKind::File);
        let map = MapConfig { kind, file, ..c.map.clone() };
        sites.push(Site::new(c, &map, levels, sweep)?);
    }
    for p in PUBLISHED.iter().filter(|_| s.scenes.is_some()) {
        let file = s.scenes.as_ref().map(|dir| dir.join(format!("{}.png", p.scene)));
        let map = MapConfig { kind: MapKind::File, file, scale: p.scale, repeat: p.repeat, ..c.map.clone() };
        sites.push(Site::new(c, &map, n, false)?);
    }
    Ok(sites)
}
