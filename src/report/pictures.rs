//! Pictures: a view rendered by the datapath's hits, by the exact ones, and where they differ; the worst pixel enlarged.
use super::measurement::walk;
use super::plan::{DesignSpec, Extent, Map, Plan};
use crate::error::Result;
use crate::golden::encode_ray;
use crate::measure::{exact_ray, uv_error};
use crate::oracle::ExactHit;
use crate::scene::border::tiles;
use crate::scene::{Camera, Picture, RaySet, ShadePoint, Shader};
use crate::trace::{shade_point, trace_interp};
use base64::prelude::{BASE64_STANDARD, Engine};
use rayon::prelude::*;

/// Pixels of a picture.
pub(super) const SIZE: (u32, u32) = (360, 270);
/// Pixels of the enlarged neighbourhood.
const NEAR: (usize, usize) = (24, 18);
/// Same texel: from no error to half a texel; another texel; given up; no ray.
const NONE: [u8; 3] = [243, 243, 240];
const OTHER: [u8; 3] = [213, 94, 0];
const LIMIT: [u8; 3] = [90, 20, 110];
const MISS: [u8; 3] = [255, 255, 255];

/// A view of a design as pictures.
pub struct ViewPictures {
    /// Rendered by the datapath, by the oracle, and the difference.
    pub whole: [Picture; 3],
    /// The same three around the worst pixel.
    pub near: [Picture; 3],
    /// Column and row of the worst pixel.
    pub worst: [u32; 2],
    /// Its position error in texels.
    pub error: f64,
    /// Pixels with a ray, wrong texels, given up.
    pub counts: [u64; 3],
}

fn crop(p: &Picture, at: [u32; 2]) -> Picture {
    let left = (at[0] as usize).saturating_sub(NEAR.0 / 2).min(p.width - NEAR.0);
    let top = (at[1] as usize).saturating_sub(NEAR.1 / 2).min(p.height - NEAR.1);
    let pixels = (0..NEAR.0 * NEAR.1).map(|k| p.pixels[(top + k / NEAR.0) * p.width + left + k % NEAR.0]).collect();
    Picture { width: NEAR.0, height: NEAR.1, pixels }
}

/// The views that pictures are made of, with their cameras for pictures of this size: all that have one.
pub fn cameras(plan: &Plan) -> Vec<(String, Camera)> {
    let views = plan.rays.iter().filter(|r| r.elevation.is_none()).map(|r| &r.set);
    let camera = |set: &RaySet| {
        let camera = set.camera(SIZE.0, SIZE.1)?;
        Some((set.name.clone(), Camera { width: SIZE.0, height: SIZE.1, ..camera }))
    };
    let all: Vec<(String, Camera)> = views.filter_map(camera).collect();
    // Tests need no more than one picture.
    if plan.selection.extent == Extent::Tiny { all.into_iter().skip(1).take(1).collect() } else { all }
}

/// One view of a map through a design.
///
/// # Errors
/// A design that is not legal.
pub fn view(plan: &Plan, map: &Map, spec: &DesignSpec, camera: &Camera) -> Result<ViewPictures> {
    let d = spec.design(&plan.config, map.spec.levels)?;
    let rays = map.rays(&plan.config, camera, 1)?;
    let words: Vec<_> = rays.iter().map(|r| encode_ray(&d, [r.u, r.v, r.du, r.dv])).collect();
    let hits = trace_interp(&d, &map.pyramid, &words)?;
    let exact: Vec<Option<(ExactHit, [f64; 2])>> =
        words.par_iter().map(|r| Ok(walk(map, &exact_ray(&d, r)?))).collect::<Result<_>>()?;
    let bottom = f64::from((1u32 << map.spec.height_bits) - 1);
    let side = 2f64.powi(map.spec.levels as i32);
    let pixels = (SIZE.0 * SIZE.1) as usize;
    let (mut ours, mut truth, mut differ) = (vec![None; pixels], vec![None; pixels], vec![MISS; pixels]);
    let mut worst = (-1.0, [0, 0]);
    let mut counts = [rays.len() as u64, 0, 0];
    let mut wrong = Vec::new();
    for ((r, h), e) in rays.iter().zip(&hits).zip(&exact) {
        let at = (r.py * SIZE.0 + r.px) as usize;
        if !h.limit {
            ours[at] = Some(shade_point(&d, h));
        }
        let Some((e, place)) = e else { continue };
        let [u, v] = place.map(|x| (x / side).rem_euclid(1.0));
        truth[at] = Some(ShadePoint { u, v, t: e.t_f64 / bottom, wall: e.wall });
        let error = if h.limit { f64::INFINITY } else { uv_error(&d, map.spec.levels, h, *place) };
        if error > worst.0 {
            worst = (error, [r.px, r.py]);
        }
        let bad = (h.i, h.j) != (e.i, e.j);
        if h.limit || bad {
            counts[if h.limit { 2 } else { 1 }] += 1;
            wrong.push((at, if h.limit { LIMIT } else { OTHER }));
        } else {
            // The square root lets small errors be seen.
            let grey = |c: u8| (f64::from(c) * (1.0 - 0.55 * (error * 2.0).min(1.0).sqrt())).round() as u8;
            differ[at] = NONE.map(grey);
        }
    }
    // A wrong pixel alone is lost on a page: where they are few each gets a ring.
    if wrong.len() * 400 < pixels {
        for (at, colour) in &wrong {
            let (x, y) = ((at % SIZE.0 as usize) as i64, (at / SIZE.0 as usize) as i64);
            for (dx, dy) in (-3i64..=3).flat_map(|dx| (-3i64..=3).map(move |dy| (dx, dy))) {
                let inside = (0..i64::from(SIZE.0)).contains(&(x + dx)) && (0..i64::from(SIZE.1)).contains(&(y + dy));
                if dx.abs().max(dy.abs()) == 3 && inside {
                    differ[((y + dy) * i64::from(SIZE.0) + x + dx) as usize] = *colour;
                }
            }
        }
    }
    wrong.iter().for_each(|(at, colour)| differ[*at] = *colour);
    let s = &map.spec;
    let shader = Shader::new(&map.texels, s.levels, s.height_bits, s.scale, tiles(s.border, s.repeat), s.kind);
    let (w, h) = (SIZE.0 as usize, SIZE.1 as usize);
    let whole = [
        Picture::shaded(&shader, w, h, &ours),
        Picture::shaded(&shader, w, h, &truth),
        Picture { width: w, height: h, pixels: differ },
    ];
    let near = [0, 1, 2].map(|k: usize| crop(&whole[k], worst.1));
    Ok(ViewPictures { whole, near, worst: worst.1, error: worst.0, counts })
}

/// A picture as a data URI.
///
/// # Errors
/// Never: the pictures have pixels.
pub fn data_uri(p: &Picture) -> Result<String> {
    Ok(format!("data:image/png;base64,{}", BASE64_STANDARD.encode(p.to_png()?)))
}
