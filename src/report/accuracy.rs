//! Hits against the exact texel walk: wrong texels with their witnesses, and the largest error of the parameter.
use crate::config::{DatapathKind, Design};
use crate::error::{Error, Result};
use crate::golden::{RayHit, RayInput, decode_time, decode_travel};
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
    /// Distance of position and exact place in texels, and the ray, of all rays that ended.
    pub uv: Vec<(f64, usize)>,
}

/// The exact values of a ray's words.
///
/// # Errors
/// Words that are not numbers.
pub fn exact_ray(d: &Design, r: &RayInput) -> Result<ExactRay> {
    let (p, t) = ([r.u, r.v], [r.du, r.dv]);
    if d.datapath.kind == DatapathKind::Fixed {
        return Ok(ExactRay::fixed(d.datapath.fraction_bits, p, t.map(|word| decode_travel(d, word))));
    }
    ExactRay::float(d.format, p, t).ok_or_else(|| Error::input("an exact ray is made of finite numbers"))
}

/// Distance of a returned hit and an exact place, in texels, the shorter way round the tile.
pub(in crate::report) fn distance(d: &Design, h: &RayHit, place: [f64; 2]) -> f64 {
    let side = 2f64.powi(d.traverse.levels as i32);
    let unit = 2f64.powi(-(d.traverse.frac_bits as i32));
    let away = |texel: u32, part: u32, exact: f64| {
        let far = f64::from(texel) + f64::from(part) * unit - exact;
        far - (far / side).round() * side
    };
    let (u, v) = (away(h.i, h.fu, place[0]), away(h.j, h.fv, place[1]));
    (u * u + v * v).sqrt()
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
            let ray = exact_ray(d, r)?;
            let e = map.trace(&ray)?;
            let place = ray.place(&e, full).map(|tiles| tiles * 2f64.powi(t.levels as i32));
            Ok(Some((e, place)))
        })
        .collect::<Result<_>>()?;
    let mut a = Accuracy { rays: rays.len(), ..Accuracy::default() };
    for (ray, (h, e)) in hits.iter().zip(&exact).enumerate() {
        let Some((e, place)) = e else {
            a.limits += 1;
            continue;
        };
        a.uv.push((distance(d, h, *place), ray));
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
