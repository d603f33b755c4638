//! What the model of every datapath can do.
use super::image::Image;
use super::pyramid::{Pyramid, address};
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

    /// The memories of a map, in the order in which their words pass the load ports.
    ///
    /// # Panics
    /// If the map is too small for the design.
    fn images(_: &Design, map: &Pyramid) -> Vec<Image>
    where
        Self: Sized,
    {
        Image::of_pyramid(map)
    }

    /// Words of all of [`Datapath::images`] of a map of the design's size.
    fn image_words(design: &Design) -> usize
    where
        Self: Sized,
    {
        address(design.traverse.levels, design.traverse.levels, 0, 0) + 1
    }

    /// Where among these words the height code of texel (i, j) stands.
    fn texel_word(design: &Design, i: u32, j: u32) -> usize
    where
        Self: Sized,
    {
        address(design.traverse.levels, 0, i, j)
    }

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
