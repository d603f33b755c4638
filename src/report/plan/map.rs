//! A map of the report, and its rays.
use crate::config::{Border, Config, Design, MapConfig, MapKind};
use crate::error::{Error, Result};
use crate::golden::Pyramid;
use crate::scene::{Camera, RaySet, ViewRay, bordered_codes, load_codes, procedural};
use crate::trace::rays_inside;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// A map, as a measurement names it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MapSpec {
    /// Kind, or file stem.
    pub name: String,
    /// Kind.
    pub kind: MapKind,
    /// Seed of a procedural map; 0 of a file.
    pub seed: u64,
    /// log2 of the side.
    pub levels: u32,
    /// Bits of a height code.
    pub height_bits: u32,
    /// World height of a full-height texel.
    pub scale: f64,
    /// Repeats along the quad.
    pub repeat: u32,
    /// What lies beyond the border.
    pub border: Border,
    /// Twelve digits of blake3 over the height codes.
    pub codes: String,
}

/// A map, ready to be traced.
pub struct Map {
    /// What it is.
    pub spec: MapSpec,
    /// Height codes.
    pub texels: Vec<u32>,
    /// Their pyramid.
    pub pyramid: Pyramid,
    /// The file it came from.
    pub file: Option<PathBuf>,
    /// Only the designs that are followed along map sizes are measured on it.
    pub sweep: bool,
}

impl Map {
    /// The map of `map` with 2^levels texels along each side.
    ///
    /// # Errors
    /// A map that can't be read or does not fit.
    pub fn new(c: &Config, map: &MapConfig, levels: u32, sweep: bool) -> Result<Self> {
        let height_bits = c.traverse.height_bits;
        let (texels, name) = match &map.file {
            Some(file) if map.kind == MapKind::File => {
                let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
                (load_codes(file, map, levels, height_bits, false)?.0, name)
            }
            _ => {
                let heights = procedural(map.kind, levels - map.border.levels(), map.seed)?;
                let name = map.kind.word().to_owned();
                let texels = bordered_codes(&heights, map.border, levels, height_bits, map.resample)
                    .map_err(|e| Error::input(format!("{name}: {e}")))?;
                (texels, name)
            }
        };
        let pyramid = Pyramid::build(levels, height_bits, &texels)?;
        let bytes: Vec<u8> = texels.iter().flat_map(|code| code.to_le_bytes()).collect();
        let codes = blake3::hash(&bytes).to_hex()[..12].to_owned();
        let seed = if map.kind == MapKind::File { 0 } else { map.seed };
        let (kind, scale, repeat, border) = (map.kind, map.scale, map.repeat, map.border);
        let spec = MapSpec { name, kind, seed, levels, height_bits, scale, repeat, border, codes };
        Ok(Self { spec, texels, pyramid, file: map.file.clone(), sweep })
    }

    /// A camera's rays in tiles of the design, but for those that don't see what the map's border promises.
    ///
    /// # Errors
    /// No watertight design holds the map.
    pub fn rays(&self, c: &Config, camera: &Camera, stride: u32) -> Result<Vec<ViewRay>> {
        let s = &self.spec;
        self.inside(c, camera.bordered_rays(s.border, s.scale, s.repeat, stride))
    }

    /// As [`Map::rays`], of a set: of a camera every `stride`-th pixel's, of a table all.
    ///
    /// # Errors
    /// As [`Map::rays`]; a table's ray that enters outside of what the border prepares.
    pub fn set(&self, c: &Config, set: &RaySet, stride: u32) -> Result<Vec<ViewRay>> {
        let s = &self.spec;
        self.inside(c, set.rays(s.border, (s.scale, s.repeat), (c.view.width, c.view.height), stride)?)
    }

    fn inside(&self, c: &Config, rays: Vec<ViewRay>) -> Result<Vec<ViewRay>> {
        let s = &self.spec;
        let mut d = Design::default();
        (d.traverse.levels, d.traverse.height_bits, d.traverse.tile_bits) =
            (s.levels, s.height_bits, c.traverse.tile_bits);
        rays_inside(&d, s.border, &self.pyramid, rays)
    }
}
