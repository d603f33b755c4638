//! The scene of a configuration: height codes, pyramid, and the rays of its views.
use crate::config::{Config, MapKind, View};
use crate::error::{Error, Result};
use crate::golden::{Pyramid, RayInput, encode_ray};
use crate::scene::{Camera, RaySet, Taken, ViewRay, bordered_codes, load_codes, procedural};
use crate::trace::rays_inside;
use std::path::Path;

/// A map, ready to be traced.
pub struct Scene {
    /// Height codes, row-major.
    pub texels: Vec<u32>,
    /// Its pyramid.
    pub pyramid: Pyramid,
    /// What the map is, for shading.
    pub kind: MapKind,
    /// Name for messages: a kind, or the file's name.
    pub name: String,
    /// What was taken of the file, if it is one.
    pub taken: Option<Taken>,
}

impl Scene {
    /// The map of a configuration; `file` and `resample` come from the command line and go first.
    ///
    /// # Errors
    /// A map that can't be read, or does not fit.
    pub fn new(c: &Config, file: Option<&Path>, resample: bool) -> Result<Self> {
        let t = &c.traverse;
        let file = file.or(c.map.file.as_deref().filter(|_| c.map.kind == MapKind::File));
        let (texels, taken, kind, name) = match file {
            Some(path) => {
                let (texels, taken) = load_codes(path, &c.map, t.levels, t.height_bits, resample)?;
                (texels, Some(taken), MapKind::File, path.display().to_string())
            }
            None => {
                let kind = c.map.kind;
                let map = procedural(kind, t.levels - c.map.border.levels(), c.map.seed)?;
                let texels = bordered_codes(&map, c.map.border, t.levels, t.height_bits, resample || c.map.resample)
                    .map_err(|e| Error::input(format!("{kind}: {e}")))?;
                (texels, None, kind, kind.word().to_string())
            }
        };
        let pyramid = Pyramid::build(t.levels, t.height_bits, &texels)?;
        Ok(Self { texels, pyramid, kind, name, taken })
    }

    /// The rays of a standard view at the configured size, every `stride`-th pixel; as [`Scene::rays`].
    ///
    /// # Errors
    /// As [`Scene::rays`].
    pub fn view(&self, c: &Config, view: View, stride: u32) -> Result<Vec<ViewRay>> {
        self.rays(c, &Camera::standard(view, c.view.width, c.view.height), stride)
    }

    /// The rays of a set: of a camera every `stride`-th pixel's, of a table all; as [`Scene::rays`].
    ///
    /// # Errors
    /// As [`Scene::rays`]; a table's ray that enters outside of what `map.border` prepares.
    pub fn set(&self, c: &Config, set: &RaySet, stride: u32) -> Result<Vec<ViewRay>> {
        let rays = set.rays(c.map.border, (c.map.scale, c.map.repeat), (c.view.width, c.view.height), stride)?;
        rays_inside(&c.design(), c.map.border, &self.pyramid, rays)
    }

    /// A camera's rays through every `stride`-th pixel, in tiles of the design; those that don't see what `map.border` promises are left
    /// out.
    ///
    /// # Errors
    /// An illegal design.
    pub fn rays(&self, c: &Config, camera: &Camera, stride: u32) -> Result<Vec<ViewRay>> {
        let rays = camera.bordered_rays(c.map.border, c.map.scale, c.map.repeat, stride);
        rays_inside(&c.design(), c.map.border, &self.pyramid, rays)
    }

    /// Rays for vectors: `vectors.rays` of each view, evenly over the picture.
    ///
    /// # Errors
    /// As [`Scene::rays`].
    pub fn sample(&self, c: &Config) -> Result<Vec<RayInput>> {
        let mut out = Vec::new();
        for view in &c.view.names {
            let rays = self.view(c, *view, c.view.stride)?;
            let n = (c.vectors.rays as usize).min(rays.len());
            // Of a design with a level of detail, every second ray has one: each word that the port takes in turn.
            let words = (c.traverse.levels + 1).next_power_of_two() as usize;
            let lod = |k: usize| if c.mode.lod && k % 2 == 1 { (k / 2 % words) as u32 } else { 0 };
            out.extend((0..n).map(|k| RayInput { lod: lod(k), ..encode(c, &rays[k * rays.len() / n]) }));
        }
        Ok(out)
    }
}

/// A camera ray, in tiles of the design, in the configured format.
pub fn encode(c: &Config, r: &ViewRay) -> RayInput {
    ray(c, [r.u, r.v, r.du, r.dv])
}

/// A ray (u, v, du, dv, in tiles of the design) in the configured format, its entry point wrapped into \[0, 1).
pub fn ray(c: &Config, ray: [f64; 4]) -> RayInput {
    encode_ray(&c.design(), ray)
}
