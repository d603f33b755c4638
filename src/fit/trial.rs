//! One design on one scene, against the truth.
use crate::config::Design;
use crate::error::Result;
use crate::golden::{Pyramid, RayHit, RayInput, encode_ray};
use crate::measure::{Cost, Spread, Steps, exact_ray, given_ray, place, steps, uv_error};
use crate::oracle::{ExactHit, ExactMap};
use crate::trace::trace_golden;
use rayon::prelude::*;

/// What may go wrong at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Budget {
    /// Share of rays whose texel is not that of the ray as given, 0 to 1.
    WrongTexel(f64),
    /// 99 % of the hits lie no farther than this from the exact one, in texels of the given map.
    UvError(f64),
}

/// A scene: map, rays, and where they hit.
pub struct Truth {
    /// log2 of the map's side.
    pub levels: u32,
    /// Bits of a height code.
    pub height_bits: u32,
    /// Height codes, row by row.
    pub texels: Vec<u32>,
    /// Rays (u, v, du, dv), in tiles.
    pub rays: Vec<[f64; 4]>,
    /// For each ray the texel and the position, in texels of the map.
    hits: Vec<(u32, u32, [f64; 2])>,
}

impl Truth {
    /// Walks the rays over the map.
    ///
    /// # Errors
    /// Rays outside of the oracle's domain.
    pub fn new(levels: u32, height_bits: u32, texels: Vec<u32>, rays: Vec<[f64; 4]>) -> Result<Self> {
        let map = ExactMap { levels, height_bits, texels: &texels };
        let walk = |r: &[f64; 4]| {
            let (hit, at) = place(&map, &given_ray(*r))?;
            Ok((hit.i, hit.j, at))
        };
        let hits = rays.par_iter().map(walk).collect::<Result<_>>()?;
        Ok(Self { levels, height_bits, texels, rays, hits })
    }

    /// The map with fewer levels (the mean of each block, rounded) and fewer bits a code (rounded).
    pub fn reduced(&self, levels: u32, height_bits: u32) -> Vec<u32> {
        let (side, block) = (1usize << levels, 1usize << (self.levels - levels));
        let (from, to) = (f64::from((1u32 << self.height_bits) - 1), f64::from((1u32 << height_bits) - 1));
        let mean = |i: usize, j: usize| {
            let row = |y: usize| (0..block).map(move |x| (y, x));
            let sum: u64 = (0..block)
                .flat_map(row)
                .map(|(y, x)| u64::from(self.texels[(j * block + y) * side * block + i * block + x]))
                .sum();
            (sum as f64 / (block * block) as f64 / from * to).round() as u32
        };
        (0..side * side).map(|k| mean(k % side, k / side)).collect()
    }
}

/// What a design does on a scene.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The design.
    pub design: Design,
    /// Its size.
    pub cost: Cost,
    /// Rays.
    pub rays: usize,
    /// Rays whose texel is not the given ray's, and the first of them.
    pub wrong: usize,
    /// The first of them.
    pub witness: Option<usize>,
    /// Rays whose texel is not that of the ray as the design reads it: what its arithmetic alone does.
    pub wrong_own: usize,
    /// The uv error against the rays as given, in texels of the given map: the 99th percentile.
    pub uv_p99: f64,
    /// A percentile above it, by three standard deviations of what a sample of that size may miss.
    pub uv_sure: f64,
    /// The largest, and its ray.
    pub uv_max: (f64, usize),
    /// Iterations.
    pub steps: Steps,
}

impl Trial {
    /// Traces the scene with a design, whose levels and height bits may be fewer than the map's.
    ///
    /// # Errors
    /// An illegal design.
    pub fn run(d: &Design, truth: &Truth) -> Result<Self> {
        let (n, h) = (d.traverse.levels, d.traverse.height_bits);
        let codes = truth.reduced(n, h);
        let pyramid = Pyramid::build(n, h, &codes)?;
        let rays: Vec<RayInput> = truth.rays.iter().map(|r| encode_ray(d, *r)).collect();
        let hits = trace_golden(d, &pyramid, &rays)?;
        let map = ExactMap { levels: n, height_bits: h, texels: &codes };
        let own: Vec<ExactHit> = rays.par_iter().map(|r| map.trace(&exact_ray(d, r)?)).collect::<Result<_>>()?;
        let wrong_own = hits.iter().zip(&own).filter(|(h, e)| h.limit || (h.i, h.j) != (e.i, e.j)).count();
        let coarse = truth.levels - n;
        let bad = |h: &RayHit, t: &(u32, u32, [f64; 2])| h.limit || (h.i, h.j) != (t.0 >> coarse, t.1 >> coarse);
        let wrong: Vec<usize> = (0..hits.len()).filter(|k| bad(&hits[*k], &truth.hits[*k])).collect();
        let ended = hits.iter().zip(&truth.hits).enumerate().filter(|(_, (h, _))| !h.limit);
        let far: Vec<(f64, usize)> = ended.map(|(k, (h, t))| (uv_error(d, truth.levels, h, t.2), k)).collect();
        let uv_sure = sure(&far);
        let uv = Spread::of(far);
        Ok(Self {
            design: *d,
            cost: Cost::of(d)?,
            rays: hits.len(),
            wrong: wrong.len(),
            witness: wrong.first().copied(),
            wrong_own,
            uv_p99: uv.p99,
            uv_sure,
            uv_max: (uv.max, uv.max_ray),
            steps: steps(&hits),
        })
    }

    /// True if the budget is kept; a ray that is given up never keeps it.
    pub fn keeps(&self, budget: Budget) -> bool {
        self.steps.limits == 0
            && match budget {
                Budget::WrongTexel(share) => self.wrong as f64 <= share * self.rays as f64,
                Budget::UvError(texels) => self.uv_p99 <= texels,
            }
    }

    /// True if the budget is kept with room for what other rays of the same scene may do: three standard deviations of the count.
    pub fn keeps_surely(&self, budget: Budget) -> bool {
        self.steps.limits == 0
            && match budget {
                Budget::WrongTexel(share) => {
                    let k = self.wrong as f64;
                    k + 3.0 * (k + 1.0).sqrt() <= share * self.rays as f64
                }
                Budget::UvError(texels) => self.uv_sure <= texels,
            }
    }

    /// The figure that the budget is about, in words.
    pub fn figure(&self, budget: Budget) -> String {
        let limits = match self.steps.limits {
            0 => String::new(),
            n => format!(", {n} given up"),
        };
        match budget {
            Budget::WrongTexel(_) => {
                let share = self.wrong as f64 / self.rays.max(1) as f64 * 100.0;
                format!("{} of {} wrong texels ({share:.3} %){limits}", self.wrong, self.rays)
            }
            Budget::UvError(_) => format!("uv error p99 {:.4} texels, max {:.4}{limits}", self.uv_p99, self.uv_max.0),
        }
    }
}

/// The error of a percentile above the 99th, by three standard deviations of what a sample of that size may miss.
fn sure(errors: &[(f64, usize)]) -> f64 {
    let mut errors: Vec<f64> = errors.iter().map(|e| e.0).collect();
    errors.sort_by(f64::total_cmp);
    let n = errors.len();
    let share = (0.99 + 3.0 * (0.99 * 0.01 / n.max(1) as f64).sqrt()).min(1.0);
    errors.get(((n as f64 * share).ceil() as usize).saturating_sub(1)).copied().unwrap_or(0.0)
}
