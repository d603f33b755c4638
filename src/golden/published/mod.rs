//! The published traversal (PIDM-HW sections 3 and 4.2, `docs/published.md`): positions are moved in floating point.
//!
//! Model of its own beside the watertight one; of that it shares the arithmetic and the rules for levels.
mod model;
mod route;
mod walk;

pub use model::Published;
pub use route::{Route, Travel};
pub use walk::Exit;

use super::datapath::Datapath;
use super::float;
use super::pyramid::Pyramid;
use super::record::{Iteration, RayHit, RayInput};
use reliefrtl_base::error::Result;
use reliefrtl_config::Design;

impl Datapath for Published {
    fn prepare(design: &Design) -> Result<Self> {
        Self::new(design)
    }

    fn encode(design: &Design, ray: [f64; 4]) -> RayInput {
        RayInput::wrapped(design.format, ray)
    }

    /// Its parameter is 1 at the bottom plane.
    fn decode(design: &Design, t: u64) -> f64 {
        float::to_f64(design.format, t) * f64::from((1u32 << design.traverse.height_bits) - 1)
    }

    fn design(&self) -> &Design {
        &self.design
    }

    fn trace_with(&self, map: &Pyramid, ray: &RayInput, on_iteration: Option<&mut dyn FnMut(&Iteration)>) -> RayHit {
        match on_iteration {
            Some(see) => self.walk(map, ray, see),
            None => self.walk(map, ray, &mut |_| ()),
        }
    }
}
