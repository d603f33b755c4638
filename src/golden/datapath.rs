//! What the model of every datapath can do.
use super::pyramid::Pyramid;
use super::record::{Iteration, RayHit, RayInput};
use reliefrtl_base::error::Result;
use reliefrtl_config::Design;

/// The model of a datapath, with the constants of one design at hand.
///
/// What a datapath has and promises, and what it is called, stands in [`reliefrtl_config::DatapathFacts`]; the exact values of its words are read by
/// the oracle alone.
pub trait Datapath: std::fmt::Debug + Send + Sync {
    /// Computes the constants of `design`.
    ///
    /// # Errors
    /// [`reliefrtl_base::error::Error::Input`] if sizes or modes are outside of the datapath's ranges.
    fn prepare(design: &Design) -> Result<Self>
    where
        Self: Sized;

    /// The ray whose words in the design's number format are nearest to (u, v, du, dv), in tiles, at full detail. The map repeats, so the entry
    /// point is wrapped into \[0, 1), also where it rounds up to 1.
    fn encode(design: &Design, ray: [f64; 4]) -> RayInput
    where
        Self: Sized;

    /// The ray parameter of a word `t`, in height codes, exact where an f64 holds it.
    fn decode(design: &Design, t: u64) -> f64
    where
        Self: Sized;

    /// The design.
    fn design(&self) -> &Design;

    /// Traces a ray and shows every iteration to `on_iteration`.
    ///
    /// # Panics
    /// If the pyramid has other levels or height bits than the design.
    fn trace_with(&self, map: &Pyramid, ray: &RayInput, on_iteration: Option<&mut dyn FnMut(&Iteration)>) -> RayHit;

    /// Traces a ray.
    ///
    /// # Panics
    /// As [`Datapath::trace_with`].
    fn trace(&self, map: &Pyramid, ray: &RayInput) -> RayHit {
        self.trace_with(map, ray, None)
    }
}
