//! What is computed once per ray: scaling before the loop, and the start level on the first trip round it.
use super::model::Published;
use crate::float::{self, Value, power_of_two};
use crate::level::start_level;
use crate::record::RayInput;

/// One axis of a ray; `p` and `d` are encoded texels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Travel {
    /// P: entry point.
    pub p: u64,
    /// D: texels travelled while the ray parameter runs from 0 to 1; a ray that does not move has +0.
    pub d: u64,
    /// The ray runs toward lower indices.
    pub neg: bool,
    /// Texel of the entry point.
    pub x: i64,
}

/// Both axes of a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Route {
    /// Along u.
    pub u: Travel,
    /// Along v.
    pub v: Travel,
}

impl Published {
    /// A ray in texels; `None` if it can't be traced.
    pub fn route(&self, ray: &RayInput) -> Option<Route> {
        Some(Route { u: self.travel(ray.u, ray.du)?, v: self.travel(ray.v, ray.dv)? })
    }

    /// The level of the first node: the root, or the lowest one that holds entry point and end point P + D * 1.
    pub fn first_level(&self, route: &Route) -> u32 {
        let n = self.design.traverse.levels;
        if !self.design.mode.start_level {
            return n;
        }
        let end = |axis| self.texel(self.position(axis, self.one));
        start_level(n, self.idx_w, route.u.x, route.v.x, end(&route.u), end(&route.v))
    }

    /// P + D * t along one axis, in texels.
    pub fn position(&self, axis: &Travel, t: u64) -> u64 {
        let fmt = self.design.format;
        float::add(fmt, axis.p, float::mul(fmt, axis.d, t))
    }

    /// Address conversion: the texel of a position.
    pub fn texel(&self, position: u64) -> i64 {
        float::to_int(self.design.format, position, self.idx_w)
    }

    /// Fraction bits of the position at `t`.
    pub fn fraction(&self, axis: &Travel, t: u64) -> u32 {
        let frac = self.design.traverse.frac_bits;
        let at = float::to_fixed(self.design.format, self.position(axis, t), self.idx_w + frac, frac);
        at.rem_euclid(1 << frac) as u32
    }

    fn travel(&self, p: u64, d: u64) -> Option<Travel> {
        let (fmt, size) = (self.design.format, self.design.traverse);
        let entry_ok = match float::decode(fmt, p) {
            Value::Zero(_) => true,
            Value::Finite(x) => !x.negative && float::lt(fmt, p, self.one),
            Value::Nan | Value::Infinite(_) => false,
        };
        let most = power_of_two(fmt, size.tile_bits as i32);
        let travel_ok = match float::decode(fmt, d) {
            Value::Zero(_) => true,
            Value::Finite(_) => float::lt(fmt, d & !fmt.sign_bit(), most),
            Value::Nan | Value::Infinite(_) => false,
        };
        if !entry_ok || !travel_ok {
            return None;
        }
        // A multiplication by 2^n is exact, and neither operand is large enough to overflow.
        let side = power_of_two(fmt, size.levels as i32);
        let p = float::mul(fmt, p & !fmt.sign_bit(), side);
        let moves = matches!(float::decode(fmt, d), Value::Finite(_));
        let d = if moves { float::mul(fmt, d, side) } else { 0 };
        Some(Travel { p, d, neg: d & fmt.sign_bit() != 0, x: self.texel(p) })
    }
}
