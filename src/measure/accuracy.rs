//! Hits against the exact texel walk: wrong texels with their witnesses, and the largest error of the parameter.
use super::uv::{given_ray, place, uv_error};
use crate::config::Design;
use crate::error::{Error, Result};
use crate::golden::{RayHit, RayInput, decode_time};
use crate::oracle::{ExactMap, ExactRay};
use rayon::prelude::*;

/// A ray whose texel is not the exact one.
#[derive(Clone, Copy, Debug)]
pub struct WrongTexel {
    /// Index of the ray.
    pub ray: usize,
    /// What the datapath returned.
    pub got: (u32, u32),
    /// What the exact walk returns.
    pub exact: (u32, u32),
    /// The smallest change of compared parameters that leads the exact walk to another texel, over M: how close the decision was.
    pub margin: f64,
}

/// The comparison.
#[derive(Clone, Debug, Default)]
pub struct Accuracy {
    /// Rays compared.
    pub rays: usize,
    /// Rays that the datapath gave up (not compared further).
    pub limits: usize,
    /// Wrong texels, in the order of the rays.
    pub wrong: Vec<WrongTexel>,
    /// Rays with the right texel and the wrong wall flag.
    pub wrong_wall: usize,
    /// Largest |t - exact t| over M among right texels, and the ray that has it.
    pub worst_t: (f64, usize),
    /// The [`uv_error`] and its ray, of all rays that ended.
    pub uv: Vec<(f64, usize)>,
}

/// The exact values of a ray's words.
///
/// # Errors
/// Words that are not numbers.
pub fn exact_ray(d: &Design, r: &RayInput) -> Result<ExactRay> {
    ExactRay::of_words(d.words(), [r.u, r.v], [r.du, r.dv])
        .ok_or_else(|| Error::input("an exact ray is made of finite numbers"))
}

/// Compares `hits` with the exact walk of the same encoded rays over `texels`.
///
/// # Errors
/// If the operands are too wide for the exact arithmetic.
pub fn accuracy(d: &Design, texels: &[u32], rays: &[RayInput], hits: &[RayHit]) -> Result<Accuracy> {
    let t = &d.traverse;
    let map = ExactMap { levels: t.levels, height_bits: t.height_bits, texels };
    let full = f64::from((1u32 << t.height_bits) - 1);
    let exact: Vec<_> = rays
        .par_iter()
        .zip(hits)
        .map(|(r, h)| {
            if h.limit {
                return Ok(None);
            }
            place(&map, &exact_ray(d, r)?).map(Some)
        })
        .collect::<Result<_>>()?;
    let mut a = Accuracy { rays: rays.len(), ..Accuracy::default() };
    for (ray, (h, e)) in hits.iter().zip(&exact).enumerate() {
        let Some((e, place)) = e else {
            a.limits += 1;
            continue;
        };
        a.uv.push((uv_error(d, t.levels, h, *place), ray));
        if (h.i, h.j) != (e.i, e.j) {
            a.wrong.push(WrongTexel { ray, got: (h.i, h.j), exact: (e.i, e.j), margin: e.margin });
            continue;
        }
        a.wrong_wall += usize::from(h.wall != e.wall);
        let error = (decode_time(d, h.t) - e.t_f64).abs() / full;
        if error > a.worst_t.0 {
            a.worst_t = (error, ray);
        }
    }
    Ok(a)
}

/// The [`uv_error`] of `hits` against the rays as they were given, u, v, du, dv in tiles, before their rounding to words; of all that ended.
///
/// # Errors
/// As [`accuracy`].
pub fn uv_given(d: &Design, texels: &[u32], rays: &[[f64; 4]], hits: &[RayHit]) -> Result<Vec<(f64, usize)>> {
    let t = &d.traverse;
    let map = ExactMap { levels: t.levels, height_bits: t.height_bits, texels };
    let one = |(ray, (numbers, h)): (usize, (&[f64; 4], &RayHit))| {
        let (_, exact) = place(&map, &given_ray(*numbers))?;
        Ok((uv_error(d, t.levels, h, exact), ray))
    };
    let ended = rays.iter().zip(hits).enumerate().filter(|(_, (_, h))| !h.limit).collect::<Vec<_>>();
    ended.into_par_iter().map(one).collect()
}
