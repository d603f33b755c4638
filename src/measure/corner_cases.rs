//! A design on a hard case: wrong texels, rays given up, and whether every mode finds the same.
use super::accuracy::{Accuracy, accuracy, exact_ray};
use crate::config::{Design, Trim};
use crate::error::Result;
use crate::golden::{Datapath, Pyramid, RayHit, RayInput, decode_time, encode_ray, prepare};
use crate::oracle::ExactMap;
use crate::scene::hard::{Case, HardScene};
use rayon::prelude::*;

/// A ray that ends differently in another mode.
#[derive(Clone, Copy, Debug)]
pub struct Differs {
    /// Index of the ray.
    pub ray: usize,
    /// That mode's design, and what it found.
    pub design: Design,
    /// As `design` found it.
    pub got: RayHit,
    /// As the configured mode found it.
    pub expected: RayHit,
}

/// What a design made of a case.
#[derive(Clone, Debug)]
pub struct HardFigures {
    /// The design, with the case's map size.
    pub design: Design,
    /// The rays' words.
    pub rays: Vec<RayInput>,
    /// What the configured mode returns.
    pub hits: Vec<RayHit>,
    /// Against the exact walk; `limits` are the rays given up.
    pub accuracy: Accuracy,
    /// Wrong texels among the tied rays.
    pub ties: usize,
    /// Rays whose exact walk meets a tie, or passes one by, that could lead to another texel: margin 0.
    pub tied: usize,
    /// Modes compared.
    pub modes: usize,
    /// Rays that end differently in some mode, with the first such mode.
    pub differ: Vec<Differs>,
    /// With a step limit of the longest ray's iterations, and of one less: rays that do not end as they must.
    pub limit_wrong: Option<usize>,
}

impl HardFigures {
    /// Runs `case` on `design` and its modes.
    ///
    /// # Errors
    /// A design that has no golden model at the case's map size.
    pub fn new(design: &Design, case: &Case, rays: usize, seed: u64) -> Result<Self> {
        Self::of_scene(&case.scene(design, rays, seed), case.limit)
    }

    /// As [`HardFigures::new`], of a scene that was made before; `limit` asks for the check of the step limit.
    ///
    /// # Errors
    /// As [`HardFigures::new`].
    pub fn of_scene(scene: &HardScene, limit: bool) -> Result<Self> {
        let design = scene.design;
        let tracer = prepare(&design)?;
        let pyramid = Pyramid::build(design.traverse.levels, design.traverse.height_bits, &scene.texels)?;
        let rays: Vec<RayInput> = scene.rays.iter().map(|ray| encode_ray(&design, *ray)).collect();
        let hits = all(&*tracer, &pyramid, &rays);
        let accuracy = accuracy(&design, &scene.texels, &rays, &hits)?;
        let t = &design.traverse;
        let map = ExactMap { levels: t.levels, height_bits: t.height_bits, texels: &scene.texels };
        let margin = |ray: &RayInput| Ok(map.trace(&exact_ray(&design, ray)?)?.margin);
        let margins: Vec<f64> = rays.par_iter().map(margin).collect::<Result<_>>()?;
        let tied = margins.iter().filter(|margin| **margin == 0.0).count();
        let ties = accuracy.wrong.iter().filter(|w| w.margin == 0.0).count();
        let modes: Vec<Box<dyn Datapath>> = modes(&design).iter().map(prepare).collect::<Result<_>>()?;
        let first = |ray: usize| {
            modes.iter().find_map(|tracer| {
                let (got, expected) = (tracer.trace(&pyramid, &rays[ray]), hits[ray]);
                let design = *tracer.design();
                (answer(&got) != answer(&expected)).then_some(Differs { ray, design, got, expected })
            })
        };
        let differ = (0..rays.len()).into_par_iter().filter_map(first).collect();
        let limit_wrong = if limit { Some(at_the_limit(&design, &pyramid, &rays, &hits)?) } else { None };
        Ok(Self { design, rays, hits, accuracy, ties, tied, modes: modes.len(), differ, limit_wrong })
    }

    /// Whether the design does what its datapath promises: no ray given up or refused, every mode the same. Not every datapath
    /// promises that.
    pub fn keeps_promises(&self) -> bool {
        let broken = self.accuracy.limits + self.differ.len() + self.limit_wrong.unwrap_or(0);
        !self.design.datapath.kind.facts().modes_agree || broken == 0
    }

    /// The largest margin among the wrong texels: how far from another decision the exact walk was when the design went wrong.
    pub fn largest_margin(&self) -> f64 {
        self.accuracy.wrong.iter().map(|w| w.margin).fold(0.0, f64::max)
    }
}

/// The designs that a design is compared with: 40 modes without chord trim; and 40 with its own, if it has one. A search by windows: other sets, and the
/// pyramid.
pub fn modes(base: &Design) -> Vec<Design> {
    let both = [Trim::None, base.mode.trim];
    base.ways(if base.mode.trim == Trim::None { &both[..1] } else { &both })
}

/// The parts of the travels after which rays end, 0 to 1.
pub fn ends(d: &Design, hits: &[RayHit]) -> Vec<f64> {
    let full = f64::from((1u32 << d.traverse.height_bits) - 1);
    let end = |hit: &RayHit| if hit.limit { 1.0 } else { (decode_time(d, hit.t) / full).clamp(0.0, 1.0) };
    hits.iter().map(end).collect()
}

/// What must not depend on the mode: everything but the counters.
pub fn answer(hit: &RayHit) -> RayHit {
    RayHit { steps: 0, crossings: 0, ups: 0, ..*hit }
}

fn all(tracer: &dyn Datapath, pyramid: &Pyramid, rays: &[RayInput]) -> Vec<RayHit> {
    rays.par_iter().map(|ray| tracer.trace(pyramid, ray)).collect()
}

/// Rays that end otherwise than they must with a limit of the largest number of iterations, or of one less.
fn at_the_limit(design: &Design, pyramid: &Pyramid, rays: &[RayInput], hits: &[RayHit]) -> Result<usize> {
    let most = hits.iter().map(|hit| hit.steps).max().unwrap_or(0);
    let mut wrong = 0;
    for limit in [most, most - 1] {
        if limit == 0 {
            continue;
        }
        let mut design = *design;
        design.traverse.step_limit = limit;
        let limited = all(&*prepare(&design)?, pyramid, rays);
        let right = |(got, hit): &(&RayHit, &RayHit)| {
            if hit.steps > limit { got.limit && !got.wall && got.steps == limit } else { got == hit }
        };
        wrong += limited.iter().zip(hits).filter(|pair| !right(pair)).count();
    }
    Ok(wrong)
}
