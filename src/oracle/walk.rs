//! The walk itself.
use super::exact::{Dyadic, Ratio, too_wide};
use crate::error::{Error, Result};
use crate::format::FloatFormat;
use std::cmp::Ordering;

/// A square map that repeats.
#[derive(Clone, Copy, Debug)]
pub struct ExactMap<'a> {
    /// log2 of the side in texels.
    pub levels: u32,
    /// Bits of a height code.
    pub height_bits: u32,
    /// Height codes, row-major, u along the row.
    pub texels: &'a [u32],
}

/// A ray by its exact numbers: entry point and travel in tiles, `(u, v)` each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactRay {
    /// Entry point, in [0, 1).
    pub p: [Dyadic; 2],
    /// Tiles travelled while the height falls from 1 to 0; below 2^8.
    pub d: [Dyadic; 2],
}

impl ExactRay {
    /// A ray of floating-point words; `None` if one of them is infinite or no number.
    pub fn float(format: FloatFormat, p: [u64; 2], d: [u64; 2]) -> Option<Self> {
        let read = |x: u64| Dyadic::read(x, format.exp, format.man);
        Some(Self { p: [read(p[0])?, read(p[1])?], d: [read(d[0])?, read(d[1])?] })
    }

    /// A ray of fixed-point words with `fraction_bits` behind the point: entry points unsigned, travels signed.
    pub fn fixed(fraction_bits: u32, p: [u64; 2], d: [i64; 2]) -> Self {
        let read = |x: i64| Dyadic::new(x.is_negative(), u128::from(x.unsigned_abs()), -(fraction_bits as i32));
        Self { p: p.map(|x| read(x as i64)), d: d.map(read) }
    }
}

/// The exact hit.
#[derive(Clone, Copy, Debug)]
pub struct ExactHit {
    /// Texel along u, wrapped.
    pub i: u32,
    /// Texel along v, wrapped.
    pub j: u32,
    /// The ray entered the texel below its top.
    pub wall: bool,
    /// Ray parameter in height codes, exact.
    pub t: Ratio,
    /// Ray parameter, to within a few units in the last place.
    pub t_f64: f64,
    /// How close the walk came to another decision: the smallest difference of compared parameters over M.
    /// 0 only on an exact tie.
    pub margin: f64,
    /// Texels visited.
    pub texels: u64,
}

/// One axis of the walk: where the next plane is.
struct Axis {
    /// Texels, unwrapped.
    at: i64,
    /// The planes' indices fall.
    falling: bool,
    /// Entry point in units of 2^-scale texels.
    p: i128,
    scale: u32,
    /// |travel| in texels: `d * 2^d_exp`, 0 if the ray never leaves along this axis.
    d: u128,
    d_exp: i32,
    /// M, for the parameter of a plane.
    bottom: u128,
}

impl Axis {
    fn new(p: Dyadic, d: Dyadic, map: &ExactMap) -> Result<Self> {
        let outside = || Error::input("an exact ray enters in [0, 1) and travels less than 256 tiles");
        // Below 1 means that the top bit of sig * 2^exp is below the point.
        let bits = |x: &Dyadic| (u128::BITS - x.sig.leading_zeros()) as i32 + x.exp;
        if p.sig != 0 && (p.negative || bits(&p) > 0) || d.sig != 0 && bits(&d) > 8 {
            return Err(outside());
        }
        let n = map.levels as i32;
        let exp = if p.sig == 0 { 0 } else { p.exp + n };
        let scale = (-exp).max(0) as u32;
        // Room for a plane of 2^22 texels beside the scale.
        if scale > 104 {
            return Err(too_wide());
        }
        let p = (p.sig as i128) << exp.max(0);
        let bottom = (1u128 << map.height_bits) - 1;
        Ok(Self { at: (p >> scale) as i64, falling: d.negative, p, scale, d: d.sig, d_exp: d.exp + n, bottom })
    }

    /// Parameter of the plane by which the ray leaves the current texel; None if it never does.
    fn exit(&self) -> Result<Option<Ratio>> {
        if self.d == 0 {
            return Ok(None);
        }
        let plane = i128::from(if self.falling { self.at } else { self.at + 1 }) << self.scale;
        // Never negative: the plane lies ahead of the entry point, or on it.
        let way = (plane - self.p).unsigned_abs();
        let num = way.checked_mul(self.bottom).ok_or_else(too_wide)?;
        Ok(Some(Ratio { num, den: self.d, exp: -(self.scale as i32) - self.d_exp }))
    }

    fn step(&mut self) {
        self.at += if self.falling { -1 } else { 1 };
    }
}

/// Compares and remembers how close it was.
struct Judge {
    bottom: f64,
    margin: f64,
}

impl Judge {
    fn order(&mut self, a: &Ratio, b: &Ratio) -> Result<Ordering> {
        let order = a.order(b)?;
        let gap =
            if order.is_eq() { 0.0 } else { ((a.to_f64() - b.to_f64()).abs() / self.bottom).max(f64::MIN_POSITIVE) };
        self.margin = self.margin.min(gap);
        Ok(order)
    }

    /// As [`Judge::order`], where None stands for a parameter beyond all others.
    fn order_exits(&mut self, a: Option<&Ratio>, b: Option<&Ratio>) -> Result<Ordering> {
        match (a, b) {
            (Some(a), Some(b)) => self.order(a, b),
            (Some(_), None) => Ok(Ordering::Less),
            (None, Some(_)) => Ok(Ordering::Greater),
            (None, None) => Ok(Ordering::Equal),
        }
    }
}

impl ExactMap<'_> {
    /// Walks the texels along `ray` until it hits one.
    ///
    /// # Errors
    /// [`Error::Input`] if the ray is outside of its domain or the map's size is wrong, or if 128-bit integers don't hold the
    /// exact products (never with formats up to 7/16); a wrong answer is never returned.
    pub fn trace(&self, ray: &ExactRay) -> Result<ExactHit> {
        if self.texels.len() != 1 << (2 * self.levels) {
            return Err(Error::input(format!("the map has {} texels, not 4^{}", self.texels.len(), self.levels)));
        }
        let mut u = Axis::new(ray.p[0], ray.d[0], self)?;
        let mut v = Axis::new(ray.p[1], ray.d[1], self)?;
        let bottom = (1u64 << self.height_bits) - 1;
        let mut judge = Judge { bottom: bottom as f64, margin: f64::INFINITY };
        let mut entry = Ratio::integer(0);
        let (mut u_exit, mut v_exit) = (u.exit()?, v.exit()?);
        let side = 1i64 << self.levels;
        for texels in 1.. {
            let (i, j) = (u.at.rem_euclid(side), v.at.rem_euclid(side));
            let top = Ratio::integer(bottom - u64::from(self.texels[(j * side + i) as usize]));
            let u_first = judge.order_exits(u_exit.as_ref(), v_exit.as_ref())?.is_le();
            let exit = if u_first { u_exit } else { v_exit };
            let meets = judge.order_exits(Some(&top), exit.as_ref())?.is_lt();
            // A texel touched only in a corner has no interior for the ray to end in.
            if meets && judge.order_exits(Some(&entry), exit.as_ref())?.is_lt() {
                let wall = judge.order(&top, &entry)?.is_lt();
                let t = if wall { entry } else { top };
                let margin = judge.margin;
                return Ok(ExactHit { i: i as u32, j: j as u32, wall, t, t_f64: t.to_f64(), margin, texels });
            }
            // An axis without an exit is never first; `entry` only grows.
            entry = exit.unwrap_or(entry);
            if u_first {
                u.step();
                u_exit = u.exit()?;
            } else {
                v.step();
                v_exit = v.exit()?;
            }
        }
        unreachable!("the ray ends at the bottom plane")
    }
}
