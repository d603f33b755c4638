//! The watertight traversal (`docs/datapath.md`), in floating point.
pub mod bilinear;
mod model;
mod planes;
mod setup;

pub use model::Watertight;
pub use setup::Axis;

use super::datapath::Datapath;
use super::float;
use super::pyramid::Pyramid;
use super::record::{Iteration, RayHit, RayInput};
use super::walk::walk;
use reliefrtl_base::error::Result;
use reliefrtl_config::Design;

impl Datapath for Watertight {
    fn prepare(design: &Design) -> Result<Self> {
        Self::new(design)
    }

    fn encode(design: &Design, ray: [f64; 4]) -> RayInput {
        RayInput::wrapped(design.format, ray)
    }

    fn decode(design: &Design, t: u64) -> f64 {
        float::to_f64(design.format, t)
    }

    fn design(&self) -> &Design {
        &self.design
    }

    fn trace_with(&self, map: &Pyramid, ray: &RayInput, on_iteration: Option<&mut dyn FnMut(&Iteration)>) -> RayHit {
        let hit = walk(self, map, ray, on_iteration);
        match self.design.mode.bilinear {
            true => RayHit { bilinear: self.refine(map, ray, &hit).map(|r| r.hit()), ..hit },
            false => hit,
        }
    }
}
