//! One tracer for every datapath: the words that enter, the hits that leave.
use super::fixed::{self, Fixed};
use super::float;
use super::published::Published;
use super::pyramid::Pyramid;
use super::record::{Iteration, RayHit};
use super::setup::RayInput;
use super::traverse::Watertight;
use crate::config::{DatapathKind, Design, Trim};
use crate::error::{Error, Result};

/// The golden model of a design's datapath.
#[derive(Clone, Debug)]
pub enum Tracer {
    /// `docs/datapath.md`.
    Watertight(Watertight),
    /// `docs/published.md`.
    Published(Published),
    /// `docs/fixed.md`.
    Fixed(Fixed),
}

impl Tracer {
    /// A tracer for `design`.
    ///
    /// # Errors
    /// [`crate::error::Error::Input`] if the sizes are outside of the datapath's ranges.
    pub fn new(design: &Design) -> Result<Self> {
        let more = design.mode.trim != Trim::None || design.mode.lod;
        if more && design.datapath.kind == DatapathKind::Published {
            return Err(Error::input(
                "mode.trim and mode.lod need a datapath that compares parameters of planes: watertight or fixed",
            ));
        }
        if design.mode.bilinear && design.datapath.kind != DatapathKind::Watertight {
            return Err(Error::input("mode.bilinear needs the watertight datapath"));
        }
        match design.datapath.kind {
            DatapathKind::Watertight => Watertight::new(design).map(Self::Watertight),
            DatapathKind::Published => Published::new(design).map(Self::Published),
            DatapathKind::Fixed => Fixed::new(design).map(Self::Fixed),
        }
    }

    /// The design this tracer is for.
    pub fn design(&self) -> &Design {
        match self {
            Self::Watertight(g) => g.design(),
            Self::Published(g) => g.design(),
            Self::Fixed(g) => g.design(),
        }
    }

    /// Traces a ray.
    ///
    /// # Panics
    /// If the pyramid has other levels or height bits than the design.
    pub fn trace(&self, pyramid: &Pyramid, ray: &RayInput) -> RayHit {
        match self {
            Self::Watertight(g) => g.trace(pyramid, ray),
            Self::Published(g) => g.trace(pyramid, ray),
            Self::Fixed(g) => g.trace(pyramid, ray),
        }
    }

    /// Traces a ray and shows every iteration to `see`.
    ///
    /// # Panics
    /// As [`Tracer::trace`].
    pub fn trace_with(&self, pyramid: &Pyramid, ray: &RayInput, see: impl FnMut(&Iteration)) -> RayHit {
        match self {
            Self::Watertight(g) => g.trace_with(pyramid, ray, see),
            Self::Published(g) => g.trace_with(pyramid, ray, see),
            Self::Fixed(g) => g.trace_with(pyramid, ray, see),
        }
    }
}

/// The ray whose words in the design's number format are nearest to (u, v, du, dv), in tiles. The map repeats, so the entry point is
/// wrapped into \[0, 1), also where it rounds up to 1.
pub fn encode_ray(design: &Design, [u, v, du, dv]: [f64; 4]) -> RayInput {
    if design.datapath.kind == DatapathKind::Fixed {
        return fixed::encode(design, [u, v, du, dv]);
    }
    let f = design.format;
    let one = (f.bias() as u64) << f.man;
    let wrap = |x: u64| if x == one { 0 } else { x };
    let r = RayInput::from_f64(f, u.rem_euclid(1.0), v.rem_euclid(1.0), du, dv);
    RayInput { u: wrap(r.u), v: wrap(r.v), ..r }
}

/// A travel's word of the fixed-point datapath as a number, in 2^-FRACTION_W tiles.
pub fn decode_travel(design: &Design, word: u64) -> i64 {
    fixed::travel(design, word)
}

/// The ray parameter of a word `t`, in height codes, exact where an f64 holds it.
pub fn decode_time(design: &Design, t: u64) -> f64 {
    match design.datapath.kind {
        DatapathKind::Fixed => fixed::time(design, t),
        DatapathKind::Watertight => float::to_f64(design.format, t),
        // 1 is the bottom plane.
        DatapathKind::Published => {
            float::to_f64(design.format, t) * f64::from((1u32 << design.traverse.height_bits) - 1)
        }
    }
}
