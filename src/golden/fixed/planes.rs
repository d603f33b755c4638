//! What the walk from node to node computes with, in fixed point.
use super::model::Fixed;
use super::setup::FixedAxis;
use crate::planes::{PlaneArithmetic, Setup};
use crate::record::RayInput;
use reliefrtl_config::Design;

impl Fixed {
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
