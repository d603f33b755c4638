//! Pictures of traced rays.
use super::Scene;
use crate::config::Config;
use crate::golden::RayHit;
use crate::measure::corner_cases::ends;
use crate::scene::border::tiles;
use crate::scene::hard::{HardScene, footprints};
use crate::scene::{Camera, Picture, RaySet, Shader, ViewRay};
use crate::trace::shade_point;

/// A table's rays on the map from above.
pub fn footprint_picture(c: &Config, scene: &Scene, set: &RaySet, rays: &[ViewRay], hits: &[RayHit]) -> Picture {
    let d = c.design();
    let rays = rays.iter().map(|r| [r.u, r.v, r.du, r.dv]).collect();
    let hard = HardScene { design: d, texels: scene.texels.clone(), rays };
    footprints(&hard, &set.name, c.map.seed, &ends(&d, hits))
}

/// The picture of hits: the surface, or the iterations.
pub fn surface_picture(
    c: &Config,
    scene: &Scene,
    camera: &Camera,
    stride: u32,
    rays: &[ViewRay],
    hits: &[RayHit],
    steps: bool,
) -> Picture {
    let (w, h) = camera.picture_size(stride);
    let (w, h) = (w as usize, h as usize);
    let at = |r: &ViewRay| (r.py / stride) as usize * w + (r.px / stride) as usize;
    let t = &c.traverse;
    if steps {
        let mut pixels = vec![None; w * h];
        rays.iter().zip(hits).for_each(|(r, x)| pixels[at(r)] = Some(x.steps));
        return Picture::steps(w, h, &pixels);
    }
    let d = c.design();
    let mut pixels = vec![None; w * h];
    rays.iter().zip(hits).for_each(|(r, x)| pixels[at(r)] = Some(shade_point(&d, x)));
    let shader =
        Shader::new(&scene.texels, t.levels, t.height_bits, c.map.scale, tiles(c.map.border, c.map.repeat), scene.kind);
    Picture::shaded(&shader, w, h, &pixels)
}
