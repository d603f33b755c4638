//! One axis of the walk: where the next plane is, as a number that may be a little off and as one that is not.
use super::exact::{Dyadic, Ratio, scale, too_wide};
use super::wide::U256;
use reliefrtl_base::error::{Error, Result};

/// Beyond every parameter, and a number that differences can be taken of.
pub(super) const NEVER: f64 = 1e300;

/// A walk along one axis.
pub(super) struct Axis {
    /// Texel, unwrapped.
    pub(super) at: i64,
    /// Parameter of the plane by which the ray leaves the current texel, to within one part in 2^50; [`NEVER`] if it never does.
    pub(super) near: f64,
    /// The planes' indices fall.
    falling: bool,
    /// The ray never leaves along this axis.
    never: bool,
    /// Texel of the entry point, and where the entry point lies in it, in units of 2^-scale texels.
    first: i64,
    inside: u128,
    scale: u32,
    /// |travel| in texels: `d * 2^d_exp`.
    d: u128,
    d_exp: i32,
    /// M, for the parameter of a plane.
    bottom: u128,
    /// `inside` in texels, and the parameter of one texel, in f64.
    inside_f64: f64,
    per_texel: f64,
    /// The f64 numbers are as near as [`Axis::near`] says.
    pub(super) near_is_near: bool,
}

impl Axis {
    /// A map of 2^`levels` texels a side, with height codes of `height_bits` bits.
    pub(super) fn new(p: Dyadic, d: Dyadic, [levels, height_bits]: [u32; 2]) -> Result<Self> {
        // Below 1 means that the top bit of sig * 2^exp is below the point.
        let bits = |x: &Dyadic| (u128::BITS - x.sig.leading_zeros()) as i32 + x.exp;
        if p.sig != 0 && (p.negative || bits(&p) > 0) || d.sig != 0 && bits(&d) > 8 {
            return Err(Error::input("an exact ray enters in [0, 1) and travels less than 256 tiles"));
        }
        let n = levels as i32;
        let exp = if p.sig == 0 { 0 } else { p.exp + n };
        let unit = exp.min(0).unsigned_abs();
        // Room for a plane of 2^24 texels beside the scale.
        if unit > U256::BITS - 24 {
            return Err(too_wide());
        }
        let (first, inside) = if unit < 128 {
            let p = p.sig << exp.max(0);
            ((p >> unit) as i64, p & ((1 << unit) - 1))
        } else {
            (0, p.sig)
        };
        let bottom = (1u128 << height_bits) - 1;
        // f64 holds numbers of so few bits exactly, and products of such numbers don't leave its range.
        let plain = |x: &Dyadic| x.sig >> 53 == 0 && x.exp > -400;
        let mut axis = Self {
            at: first,
            near: NEVER,
            falling: d.negative,
            never: d.sig == 0,
            first,
            inside,
            scale: unit,
            d: d.sig,
            d_exp: d.exp + n,
            bottom,
            inside_f64: scale(inside as f64, -(unit as i32)),
            per_texel: scale(bottom as f64 / d.sig.max(1) as f64, -(d.exp + n)),
            near_is_near: plain(&p) && plain(&d),
        };
        axis.approach();
        Ok(axis)
    }

    /// Parameter of the plane by which the ray leaves the current texel; None if it never does.
    pub(super) fn exit(&self) -> Result<Option<Ratio>> {
        self.exit_of(self.at)
    }

    /// As [`Axis::exit`], of the texel `at`, which lies on the ray's way.
    pub(super) fn exit_of(&self, at: i64) -> Result<Option<Ratio>> {
        if self.never {
            return Ok(None);
        }
        let whole = U256::from(u128::from(self.planes(at))).checked_shl(self.scale).ok_or_else(too_wide)?;
        // Never negative: the plane lies ahead of the entry point, or on it.
        let way = if self.falling {
            whole.checked_add(self.inside.into()).ok_or_else(too_wide)?
        } else {
            whole.abs_diff(self.inside.into())
        };
        let num = way.checked_mul(self.bottom).ok_or_else(too_wide)?;
        Ok(Some(Ratio { num, den: self.d, exp: -(self.scale as i32) - self.d_exp }))
    }

    /// Goes on to the next texel.
    pub(super) fn step(&mut self) {
        self.at = self.ahead();
        self.approach();
    }

    /// The next texel.
    pub(super) const fn ahead(&self) -> i64 {
        self.at + if self.falling { -1 } else { 1 }
    }

    /// Whole texels from the border beyond the entry point's texel to the exit plane.
    const fn planes(&self, at: i64) -> u64 {
        (if self.falling { self.first - at } else { at + 1 - self.first }) as u64
    }

    /// Three roundings, of the way, of the factor and of their product: the places of the planes are exact in f64.
    fn approach(&mut self) {
        if !self.never {
            let whole = self.planes(self.at) as f64;
            let way = if self.falling { whole + self.inside_f64 } else { whole - self.inside_f64 };
            self.near = way * self.per_texel;
        }
    }
}
