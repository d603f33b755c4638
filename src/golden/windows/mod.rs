//! The search by windows ahead of the ray (`docs/windows.md`): the arithmetic and the hits of the fixed-point datapath, another way to them.
//!
//! Plain integer arithmetic in 128 bits, as in [`super::fixed`], whose setup and place it uses.
mod setup;
mod walk;

pub use setup::WindowAxis;

use super::datapath::Datapath;
use super::fixed::Fixed;
use super::image::Image;
use super::pyramid::Pyramid;
use super::record::{Iteration, RayHit, RayInput};
use super::window_maps::WindowMap;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::{Design, Window, WindowSet, WindowWidths};

/// The model of one design, with the design's constants at hand.
#[derive(Clone, Debug)]
pub struct Windows {
    /// The datapath whose hits it finds.
    fixed: Fixed,
    set: WindowSet,
    widths: WindowWidths,
}

impl Windows {
    /// The widths of its words.
    pub fn widths(&self) -> &WindowWidths {
        &self.widths
    }
}

impl Datapath for Windows {
    fn prepare(design: &Design) -> Result<Self> {
        let (fixed, set) = (Fixed::prepare(design)?, design.window_set());
        if let Some(problem) = set.misfit(design.traverse.levels) {
            return Err(Error::input(format!("no search by windows of this set: {set} {problem} (`docs/windows.md`)")));
        }
        if design.mode.lod {
            return Err(Error::input("no search by windows with mode.lod: it has no levels (`docs/windows.md`)"));
        }
        Ok(Self { fixed, set, widths: WindowWidths::of(design) })
    }

    fn encode(design: &Design, ray: [f64; 4]) -> RayInput {
        Fixed::encode(design, ray)
    }

    fn decode(design: &Design, t: u64) -> f64 {
        Fixed::decode(design, t)
    }

    fn images(design: &Design, map: &Pyramid) -> Vec<Image> {
        let maps = map.windows(&design.window_set());
        let image = |map: &WindowMap| Image {
            about: format!("windows {}, row by row", map.window()),
            words: map.memory().to_vec(),
        };
        maps.maps().iter().map(image).collect()
    }

    fn image_words(design: &Design) -> usize {
        let words = |w: &Window| 1 << (2 * (design.traverse.levels - w.grid_bits()));
        design.window_set().sizes().iter().map(words).sum()
    }

    /// In the map of single texels, which is the first.
    fn texel_word(design: &Design, i: u32, j: u32) -> usize {
        (j << design.traverse.levels | i) as usize
    }

    fn design(&self) -> &Design {
        self.fixed.design()
    }

    fn trace_with(&self, map: &Pyramid, ray: &RayInput, on_iteration: Option<&mut dyn FnMut(&Iteration)>) -> RayHit {
        match on_iteration {
            Some(see) => self.walk(map, ray, see),
            None => self.walk(map, ray, &mut |_| ()),
        }
    }
}
