//! Refined hits against the exact root of the interpolated surface (`docs/bilinear.md`).
use super::accuracy::exact_ray;
use super::again::trace_again;
use super::spread::Spread;
use super::uv::uv_error;
use crate::config::{Config, Design};
use crate::error::Result;
use crate::golden::{Datapath, Patch, Pyramid, RayHit, RayInput, Refined, Watertight, decode_time};
use crate::oracle::{Dyadic, ExactMap, Root};
use crate::scene::{ViewRay, border};
use rayon::prelude::*;
use std::path::Path;

/// The exact root is enclosed to 2^-30 height codes.
const ROOT_BITS: u32 = 30;

/// Refined hits of some rays, and how far they are from the exact surface. A refined hit is compared with the first root in its own window.
#[derive(Clone, Debug, Default)]
pub struct Bilinear {
    /// Rays that were refined: all that have a hit.
    pub rays: u64,
    /// Of these, by [`Patch::ALL`]: hit, above, below.
    pub patches: [u64; 3],
    /// Of the hits, those whose window has no root.
    pub rootless: u64,
    /// Of the others, those whose window has one: the ray passes the surface and is back at the window's end.
    pub missed: u64,
    /// Error of the parameter in height codes, of hits with a root, and the ray.
    pub t: Spread,
    /// The block hit's own distance from that root, in height codes.
    pub t_block: Spread,
    /// Error of the position in texels.
    pub uv: Spread,
    /// The block hit's own distance from the root's place, in texels.
    pub uv_block: Spread,
}

/// One ray's comparison.
struct Judged {
    hit: RayHit,
    refined: Refined,
    root: Option<Root>,
    /// Where the root is, in texels.
    place: [f64; 2],
}

/// Compares the refined hits of `rays` over `texels` with the exact surface. `d` is a watertight design without a level of detail.
///
/// # Errors
/// A design that is not legal, or words that are not numbers.
///
/// # Panics
/// If the pyramid has other levels or height bits than the design.
pub fn bilinear(d: &Design, pyramid: &Pyramid, texels: &[u32], rays: &[RayInput]) -> Result<Bilinear> {
    let golden = Watertight::prepare(d)?;
    let t = &d.traverse;
    let map = ExactMap { levels: t.levels, height_bits: t.height_bits, texels };
    let judge = |r: &RayInput| -> Result<Option<Judged>> {
        let hit = golden.trace(pyramid, r);
        let Some(refined) = golden.refine(pyramid, r, &hit) else { return Ok(None) };
        let exact = exact_ray(d, r)?;
        let read = |t: u64| Dyadic::read(t, d.format.exp, d.format.man).expect("a window's ends are finite");
        let ends = refined.window.map(read);
        let root = map.bilinear_root(&exact, [&ends[0], &ends[1]], ROOT_BITS)?;
        let at = root.map_or(0.0, |r| r.low);
        let (side, bottom) = (2f64.powi(t.levels as i32), f64::from((1u32 << t.height_bits) - 1));
        let place = [0, 1].map(|a: usize| (exact.p[a].to_f64() + exact.d[a].to_f64() * at / bottom) * side);
        Ok(Some(Judged { hit, refined, root, place }))
    };
    let all = rays.par_iter().map(judge).collect::<Result<Vec<_>>>()?;
    let mut b = Bilinear::default();
    let mut errors: [Vec<(f64, usize)>; 4] = Default::default();
    for (ray, x) in all.iter().enumerate().filter_map(|(k, x)| Some((k, x.as_ref()?))) {
        b.rays += 1;
        b.patches[x.refined.patch as usize] += 1;
        let Some(root) = x.root else {
            b.rootless += u64::from(x.refined.patch == Patch::Hit);
            continue;
        };
        if x.refined.patch != Patch::Hit {
            b.missed += 1;
            continue;
        }
        let r = &x.refined;
        let found = RayHit { i: r.i, j: r.j, fu: r.fu, fv: r.fv, ..x.hit };
        let late = |t: u64| (decode_time(d, t) - root.low).abs();
        let uv = |hit: &RayHit| uv_error(d, t.levels, hit, x.place);
        let values = [late(r.t), late(x.hit.t), uv(&found), uv(&x.hit)];
        errors.iter_mut().zip(values).for_each(|(list, v)| list.push((v, ray)));
    }
    [b.t, b.t_block, b.uv, b.uv_block] = errors.map(Spread::of);
    Ok(b)
}

impl Bilinear {
    /// The command that shows the ray of the largest position error again; `rays` are those that were compared, before rounding.
    pub fn command(&self, c: &Config, file: Option<&Path>, rays: &[ViewRay]) -> String {
        let Some(r) = rays.get(self.uv.max_ray).filter(|_| self.uv.rays > 0) else { return String::new() };
        trace_again(c, file, border::given(c.map.border, [r.u, r.v, r.du, r.dv]))
    }
}
