//! The fixed-point datapath (`docs/fixed.md`): parameters of integer planes, compared as unsigned integers.
//!
//! Plain integer arithmetic in 128 bits; nothing is narrower than it needs to be, so nothing can overflow unseen.
mod model;
mod planes;
mod setup;
mod words;

pub use model::Fixed;
pub use setup::FixedAxis;
pub use words::travel;

use super::datapath::Datapath;
use super::pyramid::Pyramid;
use super::record::{Iteration, RayHit, RayInput};
use super::walk::walk;
use reliefrtl_base::error::Result;
use reliefrtl_config::Design;

impl Datapath for Fixed {
    fn prepare(design: &Design) -> Result<Self> {
        Self::new(design)
    }

    fn encode(design: &Design, ray: [f64; 4]) -> RayInput {
        words::encode(design, ray)
    }

    fn decode(design: &Design, t: u64) -> f64 {
        words::time(design, t)
    }

    fn design(&self) -> &Design {
        &self.design
    }

    fn trace_with(&self, map: &Pyramid, ray: &RayInput, on_iteration: Option<&mut dyn FnMut(&Iteration)>) -> RayHit {
        walk(self, map, ray, on_iteration)
    }
}
