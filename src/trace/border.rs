//! Rays that leave what was prepared beyond a map's border (`docs/traverse.md`).
use super::trace_golden;
use crate::config::{Border, Design};
use crate::error::Result;
use crate::golden::{Pyramid, RayHit, decode_time, encode_ray};
use crate::scene::ViewRay;
use rayon::prelude::*;

/// Whether a ray (in tiles of the design) that ended with `hit` saw what `border` promises. A map that was continued by its border
/// texels repeats at the end of that; a ray that goes on there has no hit. Always true of the other borders.
pub fn saw_border(d: &Design, border: Border, ray: &[f64; 4], hit: &RayHit) -> bool {
    if border != Border::Clamp {
        return true;
    }
    let t = &d.traverse;
    let part = decode_time(d, hit.t) / f64::from((1u32 << t.height_bits) - 1);
    let unit = 2f64.powi(-(t.levels as i32));
    // The hit is known up to whole tiles, the ray's end nearly: together they tell in which tile the ray ended.
    let tile = |p: f64, d: f64, texel: u32| (p + d * part - (f64::from(texel) + 0.5) * unit).round();
    let first = |p: f64| (0.0..1.0).contains(&p);
    first(ray[0])
        && first(ray[1])
        && !hit.limit
        && tile(ray[0], ray[2], hit.i) == 0.0
        && tile(ray[1], ray[3], hit.j) == 0.0
}

/// Those of a camera's rays (in tiles of the design) that see what `border` promises.
///
/// # Errors
/// An illegal design.
pub fn rays_inside(d: &Design, border: Border, pyramid: &Pyramid, rays: Vec<ViewRay>) -> Result<Vec<ViewRay>> {
    if border != Border::Clamp {
        return Ok(rays);
    }
    let numbers = |r: &ViewRay| [r.u, r.v, r.du, r.dv];
    let words: Vec<_> = rays.par_iter().map(|r| encode_ray(d, numbers(r))).collect();
    let hits = trace_golden(d, pyramid, &words)?;
    Ok(rays.into_iter().zip(&hits).filter(|(r, h)| saw_border(d, border, &numbers(r), h)).map(|x| x.0).collect())
}
