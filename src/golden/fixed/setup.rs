//! What is computed once per ray.
use super::model::{Fixed, GUARD};
use super::words::travel;
use crate::planes::{AxisView, Setup, both};
use crate::record::RayInput;

/// What S may lack, by its four roundings and the factors that are left out.
const SLACK: u64 = 6;

/// One axis of a ray after setup. Lengths count in 2^-FRACTION_W tiles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FixedAxis {
    /// P: entry point.
    pub p: u64,
    /// A: how far the ray travels while its parameter runs from 0 to M, either way.
    pub a: u64,
    /// The ray runs toward lower indices.
    pub neg: bool,
    /// R: reciprocal of A times M, RECIP_W significant bits; 0 if A is.
    pub r: u64,
    /// Z: distances are shifted left by this before they are multiplied with R. Of A = 0 so far that any distance is lost.
    pub z: u32,
    /// S: travel per height code in 2^-(FRACTION_W + HEIGHT_W) tiles, rounded down.
    pub s: u64,
    /// X: texel of the entry point.
    pub x: i64,
    /// Xa: texel of the point where the ray meets the bottom plane.
    pub xa: i64,
    /// Le: a texel that the ray does not get beyond, by the parameters of its planes; of use where the design trims.
    pub le: i64,
}

impl AxisView for FixedAxis {
    fn neg(&self) -> bool {
        self.neg
    }

    fn entry(&self) -> i64 {
        self.x
    }

    fn end(&self) -> i64 {
        self.xa
    }

    fn last(&self) -> i64 {
        self.le
    }
}

impl Fixed {
    /// Setup of one ray.
    pub fn setup(&self, ray: &RayInput) -> Setup<FixedAxis> {
        let d = &self.design;
        let (du, dv) = (travel(d, ray.du), travel(d, ray.dv));
        let far = 1u64 << self.reach;
        // The most negative word alone has a magnitude that its positive counterpart does not have.
        if du.unsigned_abs() == far || dv.unsigned_abs() == far {
            return Setup::default();
        }
        both(d, ray.lod, self.axis(ray.u, du), self.axis(ray.v, dv))
    }

    fn axis(&self, p: u64, d: i64) -> FixedAxis {
        let p = p % (1 << self.fraction);
        let [x, xa] = self.ends(p, d);
        FixedAxis { x, xa, ..self.slope(p, d.unsigned_abs(), d < 0) }
    }

    /// What follows from a travel's magnitude and sign; the texels of the ray's ends are 0.
    pub fn slope(&self, p: u64, a: u64, neg: bool) -> FixedAxis {
        let (r, z) = self.reciprocal(a);
        let le = self.ahead(p, neg, self.whole(a));
        FixedAxis { p, a, neg, r, z, s: self.per_code(a), le, ..FixedAxis::default() }
    }

    /// X and Xa: the texels of the entry point and of the point where the ray meets the bottom plane.
    pub fn ends(&self, p: u64, d: i64) -> [i64; 2] {
        [i128::from(p), i128::from(p) + i128::from(d)].map(|at| self.texel(at))
    }

    /// The texel at a coordinate.
    pub(super) fn texel(&self, at: i128) -> i64 {
        (at >> (self.fraction - self.design.traverse.levels)) as i64
    }

    /// R and Z: `distance * 2^Z * R / 2^(RECIP_W + TILE_W - GUARD)` is about `distance * M * 2^G / A`.
    pub fn reciprocal(&self, a: u64) -> (u64, u32) {
        if a == 0 {
            return (0, self.reach + 1);
        }
        let (w, h) = (self.reciprocal, self.design.traverse.height_bits);
        // a < 2^reach; moved up until its top bit is the topmost of `reach` bits, and M alike.
        let lead = self.reach - (64 - a.leading_zeros());
        let (norm, m) = (i128::from(a) << lead, i128::from(self.bottom) << (self.reach - h));
        // Their quotient lies between 3/4 and 2.
        let over = m >= norm;
        let bits = if over { w - 1 } else { w };
        // To the nearest integer, a half upward; what would take a bit more than W is the largest of W bits instead.
        let nearest = ((m << (bits + 1)) / norm + 1) >> 1;
        let r = nearest.min((1 << w) - 1);
        (r as u64, lead + u32::from(over))
    }

    /// S, from 1/M = 2^-h (1 + 2^-h) (1 + 2^-2h) (1 + 2^-4h) ..., cut off after every factor and after four of them.
    pub fn per_code(&self, a: u64) -> u64 {
        let h = self.design.traverse.height_bits;
        (0..4).fold(i128::from(a), |s, k| s + s / (1 << (h << k).min(120))) as u64
    }

    /// t of a plane at a distance ahead of the entry point (2^-FRACTION_W tiles): all ones if it is never met.
    pub fn plane_time(&self, distance: u64, r: u64, z: u32) -> u64 {
        let moved = i128::from(distance) << z;
        if moved >> (self.reach + 1) != 0 {
            return self.never;
        }
        let w = self.reciprocal;
        let t = (moved * i128::from(r)) >> (w + self.design.traverse.tile_bits - GUARD);
        t.min(i128::from(self.never)) as u64
    }

    /// How far a ray has come at `t`, in 2^-FRACTION_W tiles, rounded down.
    pub fn way(&self, s: u64, t: u64) -> u64 {
        ((i128::from(s) * i128::from(t)) >> (self.fraction + GUARD)) as u64
    }
    /// More than a ray travels along an axis before the parameters of its planes are those of the bottom plane: the reciprocal may be too small
    /// by one part in 2^RECIP_W, and a parameter is rounded down to an integer. An axis that does not move stays.
    fn whole(&self, a: u64) -> u64 {
        a + (a >> (self.reciprocal - 1)) + (a >> (self.fraction + 1)) + u64::from(a != 0)
    }

    /// More than a ray has come by the parameters of its planes at `t`: as [`Fixed::way`], but with more than what rounding takes from S, from
    /// the reciprocal and from a parameter.
    pub fn way_ahead(&self, s: u64, t: u64) -> u64 {
        let t = t + (t >> (self.reciprocal - 1)) + 2;
        ((i128::from(s + SLACK) * i128::from(t)) >> (self.fraction + GUARD)) as u64
    }

    /// The texel `way` ahead of `p`; of a plane that the way just meets, the texel beyond it, in both directions.
    pub(super) fn ahead(&self, p: u64, neg: bool, way: u64) -> i64 {
        let (p, way) = (i128::from(p), i128::from(way));
        self.texel(if neg { p - way - 1 } else { p + way })
    }
}
