//! A hard case, and what it makes for a design.
use super::Numbers;
use super::draw::{Draw, Ray};
use reliefrtl_config::Design;

/// Makes a map, and what makes each of its rays.
pub(super) type Make = fn(&Draw) -> (Vec<u32>, fn(&mut Draw) -> Ray);

/// A named case.
#[derive(Clone, Copy)]
pub struct Case {
    /// Its name on the command line.
    pub name: &'static str,
    /// What it aims at.
    pub about: &'static str,
    /// Whether it asks for a step limit of exactly what its rays need, too.
    pub limit: bool,
    pub(super) levels: Option<u32>,
    pub(super) make: Make,
}

/// A case for a design.
#[derive(Clone, Debug)]
pub struct HardScene {
    /// The design, with the case's map size.
    pub design: Design,
    /// Height codes, row-major.
    pub texels: Vec<u32>,
    /// Rays in tiles.
    pub rays: Vec<Ray>,
}

impl Case {
    pub(super) const fn new(name: &'static str, about: &'static str, make: Make) -> Self {
        Self { name, about, limit: false, levels: None, make }
    }

    pub(super) const fn at_the_limit(self) -> Self {
        Self { limit: true, ..self }
    }

    /// The case's map and `rays` rays for a design. A case that asks for a map size of its own changes the design's; where the number
    /// format then can't hold the farthest plane, rays travel fewer tiles.
    pub fn scene(&self, design: &Design, rays: usize, seed: u64) -> HardScene {
        let mut design = *design;
        if let Some(levels) = self.levels {
            design.traverse.levels = levels;
            if let Some(format) = design.words().float() {
                let room = (format.bias() as u32).saturating_sub(levels + 1).max(1);
                design.traverse.tile_bits = design.traverse.tile_bits.min(room);
            }
        }
        let mut draw = Draw::new(Numbers::of(&design), self.name, seed);
        let (texels, ray) = (self.make)(&draw);
        let rays = (0..rays).map(|_| ray(&mut draw)).collect();
        HardScene { design, texels, rays }
    }
    /// The case's rays over a map of the design's size; `None` of a case that asks for a size of its own.
    pub fn over(&self, design: &Design, texels: &[u32], rays: usize, seed: u64) -> Option<HardScene> {
        if self.levels.is_some() {
            return None;
        }
        Some(HardScene { texels: texels.to_vec(), ..self.scene(design, rays, seed) })
    }
}

impl std::fmt::Debug for Case {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}
