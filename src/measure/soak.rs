//! Whether every ray ends: a hard case's rays in all modes in turn, counted, and nothing else asked.
use crate::config::Design;
use crate::error::Result;
use crate::golden::{Datapath, Pyramid, RayInput, encode_ray, prepare};
use crate::scene::hard::HardScene;
use rayon::prelude::*;

/// The ray with the most iterations of those that end.
#[derive(Clone, Copy, Debug)]
pub struct Longest {
    /// Its iterations.
    pub steps: u32,
    /// Its words.
    pub ray: RayInput,
    /// The design it was traced in: its mode, or its windows.
    pub design: Design,
}

/// What became of a case's rays.
#[derive(Clone, Copy, Debug, Default)]
pub struct Endured {
    /// Rays traced.
    pub rays: usize,
    /// Rays given up at the step limit.
    pub given_up: usize,
    /// The first of them.
    pub witness: Option<(RayInput, Design)>,
    /// Rays that the design does not take.
    pub refused: usize,
    /// The longest of the rest.
    pub longest: Option<Longest>,
}

impl Endured {
    fn of(tracer: &dyn Datapath, pyramid: &Pyramid, ray: &RayInput) -> Self {
        let hit = tracer.trace(pyramid, ray);
        let design = *tracer.design();
        let given_up = hit.limit && hit.steps > 0;
        Self {
            rays: 1,
            given_up: usize::from(given_up),
            witness: given_up.then_some((*ray, design)),
            refused: usize::from(hit.limit && hit.steps == 0),
            longest: (!hit.limit).then_some(Longest { steps: hit.steps, ray: *ray, design }),
        }
    }

    /// Both together; where the iterations are the same, the earlier ray.
    pub fn and(self, other: Self) -> Self {
        let steps = |l: &Option<Longest>| l.map_or(0, |l| l.steps);
        let longest = if steps(&self.longest) >= steps(&other.longest) { self.longest } else { other.longest };
        Self {
            rays: self.rays + other.rays,
            given_up: self.given_up + other.given_up,
            witness: self.witness.or(other.witness),
            refused: self.refused + other.refused,
            longest: longest.or(self.longest).or(other.longest),
        }
    }
}

/// Traces the rays of a scene by the golden model, the k-th in the k-th mode of [`modes`], over and over.
///
/// # Errors
/// A design that has no golden model.
pub fn endure(scene: &HardScene) -> Result<Endured> {
    let design = scene.design;
    let pyramid = Pyramid::build(design.traverse.levels, design.traverse.height_bits, &scene.texels)?;
    let tracers: Vec<Box<dyn Datapath>> = modes(&design).iter().map(prepare).collect::<Result<_>>()?;
    let one =
        |(k, ray): (usize, &[f64; 4])| Endured::of(&*tracers[k % tracers.len()], &pyramid, &encode_ray(&design, *ray));
    // In order, so that the witnesses do not depend on the threads.
    let parts: Vec<Endured> = scene
        .rays
        .par_chunks(4096)
        .enumerate()
        .map(|(c, part)| {
            part.iter().enumerate().map(|(k, r)| one((4096 * c + k, r))).fold(Endured::default(), Endured::and)
        })
        .collect();
    Ok(parts.into_iter().fold(Endured::default(), Endured::and))
}

/// Every mode that the design's datapath and format have: 40, or 120 with the chord trims. A search by windows: other sets, and the pyramid.
pub fn modes(design: &Design) -> Vec<Design> {
    design.ways(design.trims())
}
