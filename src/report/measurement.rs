//! One measurement: a map, a view and a design, measured on the view's rays.
use super::plan::{DesignSpec, Job, Map, MapSpec, Plan};
use crate::config::Design;
use crate::error::{Error, Result};
use crate::golden::{RayInput, decode_time, encode_ray};
use crate::measure::spread::Spread;
use crate::measure::{exact_ray, given_ray, place, steps, uv_error};
use crate::oracle::{ExactHit, ExactMap, ExactRay};
use crate::scene::{Camera, ViewRay, border, evenly};
use crate::trace::trace_golden;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// What is measured; its canonical JSON names the measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeasurementSpec {
    /// Version of the crate.
    pub version: String,
    /// Map.
    pub map: MapSpec,
    /// View, or the name of the user's rays.
    pub view: String,
    /// The camera, where it is a file's.
    pub camera: Option<Camera>,
    /// Twelve digits of blake3 over a table's rays.
    pub table: Option<String>,
    /// Rays that were picked, where a number was given.
    pub most: Option<usize>,
    /// Degrees above the plane where they are not the view's.
    pub elevation: Option<f64>,
    /// Pixels of the picture.
    pub picture: [u32; 2],
    /// Every n-th pixel is traced.
    pub stride: u32,
    /// Design and mode.
    pub design: DesignSpec,
}

impl MeasurementSpec {
    /// Where the rays come from, in a word: the view, or its elevation.
    pub fn from(&self) -> String {
        self.elevation.map_or_else(|| self.view.clone(), |e| format!("{e}°"))
    }
}

/// A ray that shows something.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    /// Index in the view's rays.
    pub ray: usize,
    /// Column and row of its pixel.
    pub pixel: [u32; 2],
    /// Entry point and travel in tiles of the map, before rounding.
    pub numbers: [f64; 4],
    /// The words that were traced, in hex.
    pub words: [String; 4],
    /// The texel that came out.
    pub got: [u32; 2],
    /// The exact texel; `None` where the exact walk was not possible.
    pub exact: Option<[u32; 2]>,
    /// The smallest difference of compared parameters in the exact walk, over the height range.
    pub margin: f64,
}

/// A measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// What it is.
    pub spec: MeasurementSpec,
    /// Digest of the hits of some of the rays: a stored measurement whose model has changed since is not used.
    pub probe: String,
    /// Rays.
    pub rays: u64,
    /// Rays whose numbers are too far apart for the exact walk, left out of all errors.
    pub unjudged: u64,
    /// Rays given up.
    pub limits: u64,
    /// Rays with another texel than the exact one.
    pub wrong: u64,
    /// Rays with the right texel and the wrong wall flag.
    pub wrong_walls: u64,
    /// Mean iterations of the rays that ended.
    pub steps_mean: f64,
    /// Largest number of iterations.
    pub steps_max: u32,
    /// Mean crossings of the rays that ended.
    pub crossings_mean: f64,
    /// Largest error of the ray parameter over the height range, right texels.
    pub t_max: f64,
    /// Position error, right texels.
    pub uv_right: Spread,
    /// Position error, all rays that ended.
    pub uv_all: Spread,
    /// Rays that end in another texel than the ray before its rounding to words.
    pub unrounded_wrong: u64,
    /// Position error against the ray before rounding.
    pub uv_unrounded: Spread,
    /// Rays by what the datapath says (top, wall, given up) and what the oracle says (top, wall), right and wrong texel.
    pub matrix: [[[u64; 2]; 2]; 3],
    /// The ray of the largest position error.
    pub worst_uv: Option<Witness>,
    /// The ray of the most iterations.
    pub worst_steps: Option<Witness>,
    /// The ray of the largest parameter error.
    pub worst_t: Option<Witness>,
    /// The first wrong texel.
    pub first_wrong: Option<Witness>,
    /// The first ray that was given up.
    pub first_limit: Option<Witness>,
}

/// Rays that a stored measurement is probed with.
const PROBES: usize = 48;

/// A view's rays and where they hit before any rounding; all designs of a map share it.
pub struct Reference {
    /// The rays.
    pub rays: Vec<ViewRay>,
    /// Hit and place in texels.
    exact: Vec<Option<(ExactHit, [f64; 2])>>,
}

fn exact_map(map: &Map) -> ExactMap<'_> {
    ExactMap { levels: map.spec.levels, height_bits: map.spec.height_bits, texels: &map.texels }
}

/// The exact hit, and its place in texels; `None` if the walk is too wide.
pub(super) fn walk(map: &Map, ray: &ExactRay) -> Option<(ExactHit, [f64; 2])> {
    place(&exact_map(map), ray).ok()
}

impl Reference {
    /// The rays of a measurement's view on its map.
    ///
    /// # Errors
    /// As [`Map::rays`].
    pub fn new(plan: &Plan, map: &Map, job: &Job) -> Result<Self> {
        let of = &plan.rays[job.view];
        let mut rays = map.set(&plan.config, &of.set, of.stride)?;
        if of.set.camera(1, 1).is_some() && of.elevation.is_none() {
            rays = evenly(&rays, plan.selection.most);
        }
        if rays.is_empty() && of.set.standard().is_none() {
            return Err(Error::NothingRan(format!("no ray of {} meets the map {}", of.set.given, map.spec.name)));
        }
        let exact = |r: &ViewRay| walk(map, &given_ray([r.u, r.v, r.du, r.dv]));
        let exact = rays.par_iter().map(exact).collect();
        Ok(Self { rays, exact })
    }
}

/// The design's words of the rays, and their digest of a few hits.
///
/// # Errors
/// A design that is not legal.
pub fn probe(design: &Design, map: &Map, rays: &[ViewRay]) -> Result<(Vec<RayInput>, String)> {
    let words: Vec<RayInput> = rays.par_iter().map(|r| encode_ray(design, [r.u, r.v, r.du, r.dv])).collect();
    let few: Vec<RayInput> = words.iter().step_by((words.len() / PROBES).max(1)).copied().collect();
    let hits = trace_golden(design, &map.pyramid, &few)?;
    let digest = blake3::hash(format!("{few:?} {hits:?}").as_bytes()).to_hex()[..16].to_owned();
    Ok((words, digest))
}

impl Measurement {
    /// Makes a measurement.
    ///
    /// # Errors
    /// A design that is not legal.
    pub fn measure(plan: &Plan, map: &Map, spec: MeasurementSpec, reference: &Reference) -> Result<Self> {
        let design = spec.design.design(&plan.config, map.spec.levels)?;
        let (words, probe) = probe(&design, map, &reference.rays)?;
        let hits = trace_golden(&design, &map.pyramid, &words)?;
        let exact: Vec<Option<(ExactHit, [f64; 2])>> =
            words.par_iter().map(|r| Ok(walk(map, &exact_ray(&design, r)?))).collect::<Result<_>>()?;
        let bottom = f64::from((1u32 << map.spec.height_bits) - 1);
        let (mut right, mut all, mut unrounded, mut times) = (Vec::new(), Vec::new(), Vec::new(), (0.0, None));
        let (mut wrong, mut wrong_walls, mut limits, mut unjudged, mut unrounded_wrong) = (0, 0, 0, 0, 0);
        let (mut matrix, mut first_wrong, mut first_limit) = ([[[0; 2]; 2]; 3], None, None);
        let mut crossings = 0u64;
        for (ray, (hit, exact)) in hits.iter().zip(&exact).enumerate() {
            crossings += if hit.limit { 0 } else { u64::from(hit.crossings) };
            let Some((truth, place)) = exact else {
                unjudged += 1;
                continue;
            };
            let bad = (hit.i, hit.j) != (truth.i, truth.j);
            let verdict = if hit.limit { 2 } else { usize::from(hit.wall) };
            matrix[verdict][usize::from(truth.wall)][usize::from(bad)] += 1;
            if hit.limit {
                limits += 1;
                first_limit = first_limit.or(Some(ray));
                continue;
            }
            let error = uv_error(&design, map.spec.levels, hit, *place);
            all.push((error, ray));
            if let Some((truth, place)) = &reference.exact[ray] {
                unrounded.push((uv_error(&design, map.spec.levels, hit, *place), ray));
                unrounded_wrong += u64::from((hit.i, hit.j) != (truth.i, truth.j));
            }
            if bad {
                wrong += 1;
                first_wrong = first_wrong.or(Some(ray));
                continue;
            }
            right.push((error, ray));
            wrong_walls += u64::from(hit.wall != truth.wall);
            let late = (decode_time(&design, hit.t) - truth.t_f64).abs() / bottom;
            if late > times.0 {
                times = (late, Some(ray));
            }
        }
        let count = steps(&hits);
        let witness = |ray: usize| {
            let (r, w) = (&reference.rays[ray], &words[ray]);
            let words = [w.u, w.v, w.du, w.dv].map(|x| format!("{x:x}"));
            let truth = exact[ray].as_ref().map(|x| &x.0);
            Witness {
                ray,
                pixel: [r.px, r.py],
                numbers: border::given(map.spec.border, [r.u, r.v, r.du, r.dv]),
                words,
                got: [hits[ray].i, hits[ray].j],
                exact: truth.map(|x| [x.i, x.j]),
                margin: truth.map_or(0.0, |x| x.margin),
            }
        };
        let (uv_right, uv_all) = (Spread::of(right), Spread::of(all));
        Ok(Self {
            probe,
            rays: hits.len() as u64,
            unjudged,
            limits,
            wrong,
            wrong_walls,
            steps_mean: count.mean,
            steps_max: count.max,
            crossings_mean: crossings as f64 / count.rays.max(1) as f64,
            t_max: times.0,
            unrounded_wrong,
            uv_unrounded: Spread::of(unrounded),
            matrix,
            worst_uv: (uv_all.rays > 0).then(|| witness(uv_all.max_ray)),
            worst_steps: (count.rays > 0).then(|| witness(count.witness)),
            worst_t: times.1.map(witness),
            first_wrong: first_wrong.map(witness),
            first_limit: first_limit.map(witness),
            uv_right,
            uv_all,
            spec,
        })
    }

    /// Rays whose hit was compared with the exact one, given up ones included.
    pub fn judged(&self) -> u64 {
        self.rays - self.unjudged
    }

    /// Rays with a wrong texel or none at all.
    pub fn failed(&self) -> u64 {
        self.wrong + self.limits
    }

    /// Cycles a ray, in a loop whose slots are all busy.
    pub fn cycles(&self) -> f64 {
        self.steps_mean + f64::from(self.spec.design.start_trips())
    }
}

/// The canonical text of a measurement or its description.
///
/// # Errors
/// Never: it is plain data.
pub fn canonical<T: Serialize>(value: &T) -> Result<String> {
    serde_json::to_string(value).map_err(|e| Error::input(e.to_string()))
}
