//! The traversal in fixed point: what the walk from node to node computes with.
use super::super::pyramid::Pyramid;
use super::super::record::{Iteration, RayHit};
use super::super::setup::{RayInput, Setup};
use super::super::walk::{PlaneArithmetic, walk};
use super::{FixedAxis, GUARD, illegal, time_fraction};
use crate::config::Design;
use crate::error::{Error, Result};

/// A tracer for one design, with the design's constants at hand.
#[derive(Clone, Debug)]
pub struct Fixed {
    pub(super) design: Design,
    /// FRACTION_W: fraction bits of positions, in tiles.
    pub(super) fraction: u32,
    /// RECIP_W: significant bits of the reciprocal.
    pub(super) reciprocal: u32,
    /// FRACTION_W + TILE_W: bits of a travel's magnitude.
    pub(super) reach: u32,
    /// M = 2^HEIGHT_W - 1: the ray parameter at the bottom plane.
    pub(super) bottom: u64,
    /// G: fraction bits of the ray parameter.
    pub(super) time_fraction: u32,
    /// The largest ray parameter; no height is met there.
    pub(super) never: u64,
}

impl Fixed {
    /// A tracer for `design`.
    ///
    /// # Errors
    /// [`Error::Input`] if the sizes are outside of the ranges of `docs/fixed.md`.
    pub fn new(design: &Design) -> Result<Self> {
        if let Some(rule) = illegal(design) {
            return Err(Error::input(format!("no fixed-point datapath of these sizes: {rule} (`docs/fixed.md`)")));
        }
        let (t, path) = (&design.traverse, &design.datapath);
        Ok(Self {
            design: *design,
            fraction: path.fraction_bits,
            reciprocal: path.reciprocal_bits,
            reach: path.fraction_bits + t.tile_bits,
            bottom: (1 << t.height_bits) - 1,
            time_fraction: time_fraction(design),
            never: (1 << (path.fraction_bits + GUARD)) - 1,
        })
    }

    /// The design this tracer is for.
    pub fn design(&self) -> &Design {
        &self.design
    }

    /// Traces a ray.
    ///
    /// # Panics
    /// If the pyramid has other levels or height bits than the design.
    pub fn trace(&self, pyramid: &Pyramid, ray: &RayInput) -> RayHit {
        walk::<false, _>(self, pyramid, ray, &mut |_| ())
    }

    /// Traces a ray and shows every iteration to `see`.
    ///
    /// # Panics
    /// As [`Fixed::trace`].
    pub fn trace_with(&self, pyramid: &Pyramid, ray: &RayInput, mut see: impl FnMut(&Iteration)) -> RayHit {
        walk::<true, _>(self, pyramid, ray, &mut see)
    }

    /// t_v of a height code: its depth, as the parameter counts height codes, without any rounding.
    pub fn height_time(&self, height: u64) -> u64 {
        (self.bottom - height) << self.time_fraction
    }

    /// The texel where the ray is at `m`, or one that it has left already: never one that it has yet to reach.
    ///
    /// R may be too large by one part in 2^W, so the plane parameters may be; a parameter that much smaller makes up for it.
    pub fn estimate(&self, axis: &FixedAxis, m: u64) -> i64 {
        self.texel(self.at(axis, m - (m >> self.reciprocal)))
    }

    /// Where the ray is at `t`, in 2^-FRACTION_W tiles.
    fn at(&self, axis: &FixedAxis, t: u64) -> i128 {
        let way = i128::from(self.way(axis.s, t));
        i128::from(axis.p) + if axis.neg { -way } else { way }
    }

    /// The texel of a chord's end, where the ray leaves by a plane of the other axis at `t`: the one where it is by the parameters of its
    /// planes, or one further on.
    pub fn chord_end(&self, axis: &FixedAxis, t: u64) -> i64 {
        self.ahead(axis.p, axis.neg, self.way_ahead(axis.s, t))
    }

    /// Where the ray is at `t`, in 2^-FRAC_W texels, rounded down.
    pub fn place(&self, axis: &FixedAxis, t: u64) -> i64 {
        let size = &self.design.traverse;
        (self.at(axis, t) << size.frac_bits >> (self.fraction - size.levels)) as i64
    }
}

impl PlaneArithmetic for Fixed {
    type Axis = FixedAxis;

    fn design(&self) -> &Design {
        &self.design
    }

    fn ray(&self, ray: &RayInput) -> Setup<FixedAxis> {
        self.setup(ray)
    }

    fn lt(&self, a: u64, b: u64) -> bool {
        a < b
    }

    fn height_time(&self, height: u32) -> u64 {
        self.height_time(u64::from(height))
    }

    fn plane_time(&self, axis: &FixedAxis, b: i64) -> u64 {
        let plane = i128::from(b) << (self.fraction - self.design.traverse.levels);
        // A ray never comes back to a plane, so the plane lies ahead of the entry point or goes through it.
        let distance = (plane - i128::from(axis.p)).unsigned_abs() as u64;
        self.plane_time(distance, axis.r, axis.z)
    }

    fn texel_lower_bound(&self, axis: &FixedAxis, t: u64) -> i64 {
        self.estimate(axis, t)
    }

    fn texel_upper_bound(&self, axis: &FixedAxis, t: u64) -> i64 {
        self.chord_end(axis, t)
    }

    fn position(&self, axis: &FixedAxis, t: u64) -> i64 {
        self.place(axis, t)
    }
}
