//! What the walk from node to node computes with, in floating point.
use super::model::Watertight;
use super::setup::Axis;
use crate::float;
use crate::planes::{PlaneArithmetic, Setup};
use crate::record::RayInput;
use reliefrtl_config::Design;

impl PlaneArithmetic for Watertight {
    type Axis = Axis;

    fn design(&self) -> &Design {
        &self.design
    }

    fn ray(&self, ray: &RayInput) -> Setup<Axis> {
        self.setup(ray)
    }

    fn lt(&self, a: u64, b: u64) -> bool {
        float::lt(self.design.format, a, b)
    }

    fn height_time(&self, height: u32) -> u64 {
        self.tops[height as usize]
    }

    fn plane_time(&self, axis: &Axis, b: i64) -> u64 {
        let fmt = self.design.format;
        if axis.never {
            return fmt.infinity();
        }
        let away = float::add(fmt, float::from_int(fmt, b), float::neg(fmt, axis.p));
        float::mul(fmt, away, axis.r)
    }

    fn texel_lower_bound(&self, axis: &Axis, t: u64) -> i64 {
        let fmt = self.design.format;
        float::to_int(fmt, float::add(fmt, axis.pb, float::mul(fmt, axis.dt, t)), self.idx_w)
    }

    fn texel_upper_bound(&self, axis: &Axis, t: u64) -> i64 {
        let fmt = self.design.format;
        match float::decode(fmt, t) {
            float::Value::Infinite(_) => axis.le,
            _ => float::to_int(fmt, float::add(fmt, axis.pf, float::mul(fmt, axis.dt, t)), self.idx_w),
        }
    }

    fn position(&self, axis: &Axis, t: u64) -> i64 {
        let (fmt, size) = (self.design.format, &self.design.traverse);
        let at = float::add(fmt, axis.p, float::mul(fmt, axis.dt, t));
        float::to_fixed(fmt, at, self.idx_w + size.frac_bits, size.frac_bits)
    }
}
