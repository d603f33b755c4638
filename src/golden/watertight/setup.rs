//! What is computed once per ray, before the first iteration.
use super::model::Watertight;
use crate::float::{self, Value, power_of_two};
use crate::planes::{AxisView, Setup, both};
use crate::record::RayInput;

/// One axis of a ray after setup. All but flags and `x` are encoded numbers; lengths are in texels, parameters in height codes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Axis {
    /// P: entry point.
    pub p: u64,
    /// Dn: texels travelled while the ray parameter runs from 0 to M.
    pub dn: u64,
    /// The ray runs toward lower indices (sign bit of d).
    pub neg: bool,
    /// R = M / Dn: ray parameter per texel.
    pub r: u64,
    /// The ray never meets a plane of this axis.
    pub never: bool,
    /// Dt: texels per unit of the ray parameter, about Dn / M.
    pub dt: u64,
    /// B: how far the position estimate is moved backwards, at least its error.
    pub b: u64,
    /// Pb: entry point for the position estimate, `p` moved backwards by `b`.
    pub pb: u64,
    /// Pf: entry point for the estimate of a chord's end, `p` moved forward by `b`; of a travel too small to be told per height code, the
    /// ray's end. Of use where the design trims.
    pub pf: u64,
    /// Le: a texel that the ray does not get beyond; of use where the design trims.
    pub le: i64,
    /// X: texel of the entry point.
    pub x: i64,
    /// Xa: texel of the point where the ray meets the bottom plane, as far as rounding lets it be known; for the start level.
    pub xa: i64,
}

impl AxisView for Axis {
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

impl Watertight {
    /// Setup of one ray.
    pub fn setup(&self, ray: &RayInput) -> Setup<Axis> {
        if !(self.entry_ok(ray.u) && self.entry_ok(ray.v) && self.travel_ok(ray.du) && self.travel_ok(ray.dv)) {
            return Setup::default();
        }
        both(&self.design, ray.lod, self.axis(ray.u, ray.du), self.axis(ray.v, ray.dv))
    }

    /// An entry point lies in [0, 1); both zeros are fine, and subnormals are zeros.
    fn entry_ok(&self, p: u64) -> bool {
        let fmt = self.design.format;
        match float::decode(fmt, p) {
            Value::Zero(_) => true,
            Value::Finite(x) => !x.negative && float::lt(fmt, p, self.one),
            Value::Nan | Value::Infinite(_) => false,
        }
    }

    /// A ray travels less than 2^TILE_W tiles, either way.
    fn travel_ok(&self, d: u64) -> bool {
        let fmt = self.design.format;
        match float::decode(fmt, d) {
            Value::Zero(_) => true,
            Value::Finite(_) => float::lt(fmt, d & !fmt.sign_bit(), self.travel_end),
            Value::Nan | Value::Infinite(_) => false,
        }
    }

    fn axis(&self, p: u64, d: u64) -> Axis {
        let fmt = self.design.format;
        // A multiplication by 2^n is exact, and neither operand is large enough to overflow.
        let p = float::mul(fmt, p & !fmt.sign_bit(), self.texels_per_tile);
        self.scaled_axis(p, float::mul(fmt, d, self.texels_per_tile))
    }

    /// One axis of a ray that enters at `p` and travels `dn`, both in texels; `dn` is a number.
    pub fn scaled_axis(&self, p: u64, dn: u64) -> Axis {
        let fmt = self.design.format;
        let neg = dn & fmt.sign_bit() != 0;
        let r = float::div(fmt, self.bottom, dn);
        let never = matches!(float::decode(fmt, r), Value::Infinite(_));
        let dt = float::mul(fmt, dn, self.inv_bottom);
        let b = self.bias(dn);
        let pb = float::add(fmt, p, if neg { b } else { float::neg(fmt, b) });
        let x = float::to_int(fmt, p, self.idx_w);
        let xa = float::to_int(fmt, float::add(fmt, p, dn), self.idx_w);
        let (pf, le) = self.ahead(p, dn, dt, if neg { float::neg(fmt, b) } else { b });
        Axis { p, dn, neg, r, never, dt, b, pb, pf, le, x, xa }
    }

    /// B, at least the error of the position estimate: a power of two that grows with map and travel.
    fn bias(&self, dn: u64) -> u64 {
        let fmt = self.design.format;
        let n = self.design.traverse.levels as i32;
        let k = match float::decode(fmt, dn) {
            // |dn| < 2^e with e one above its exponent; exp is that of the significand's last bit.
            Value::Finite(x) => (n + 2).max(x.exp + fmt.man as i32 + 1 + 4),
            _ => n + 2,
        };
        power_of_two(fmt, k - fmt.man as i32 - 1)
    }

    /// Pf and Le of an axis: entry point moved forward by `bias`, and a texel that the ray does not get beyond.
    fn ahead(&self, p: u64, dn: u64, dt: u64, bias: u64) -> (u64, i64) {
        let fmt = self.design.format;
        let zero = |x: u64| matches!(float::decode(fmt, x), Value::Zero(_));
        let start = if zero(dn) { p } else { float::add(fmt, p, bias) };
        let end = float::add(fmt, start, dn);
        // A travel per height code that is no number any more says nothing about the way: then the whole way is assumed.
        (if zero(dt) { end } else { start }, float::to_int(fmt, end, self.idx_w))
    }
}
