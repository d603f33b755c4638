//! A hit as the pictures show it.
use crate::config::Design;
use crate::golden::{Patch, RayHit, decode_time};
use crate::scene::ShadePoint;

/// Where the hit lies: the refined one where there is one, else the block hit.
pub fn shade_point(d: &Design, h: &RayHit) -> ShadePoint {
    let t = &d.traverse;
    let full = f64::from((1u32 << t.height_bits) - 1);
    let unit =
        |i: u32, f: u32| (f64::from(i) + f64::from(f) / 2f64.powi(t.frac_bits as i32)) / 2f64.powi(t.levels as i32);
    let at = |i, j, fu, fv, s, wall| ShadePoint { u: unit(i, fu), v: unit(j, fv), t: decode_time(d, s) / full, wall };
    match h.bilinear.filter(|b| b.patch == Patch::Hit) {
        // The interpolated surface has no side walls.
        Some(b) => at(b.i, b.j, b.fu, b.fv, b.t, false),
        None => at(h.i, h.j, h.fu, h.fv, h.t, h.wall),
    }
}
