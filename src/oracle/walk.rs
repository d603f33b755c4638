//! The walk itself.
use super::axis::{Axis, NEVER};
use super::exact::{Dyadic, Ratio};
use reliefrtl_base::error::{Error, Result};
use reliefrtl_base::format::{FloatFormat, Words};
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
    /// A ray by the words that enter a datapath; `None` if one of them is infinite or no number.
    pub fn of_words(words: Words, p: [u64; 2], d: [u64; 2]) -> Option<Self> {
        match words {
            Words::Float(format) => Self::float(format, p, d),
            Words::Fixed { fraction_bits, travel_bits } => {
                let spare = u64::BITS - travel_bits;
                Some(Self::fixed(fraction_bits, p, d.map(|word| (word << spare) as i64 >> spare)))
            }
        }
    }

    /// A ray of floating-point words; `None` if one of them is infinite or no number.
    pub fn float(format: FloatFormat, p: [u64; 2], d: [u64; 2]) -> Option<Self> {
        let read = |x: u64| Dyadic::read(x, format.exp, format.man);
        Some(Self { p: [read(p[0])?, read(p[1])?], d: [read(d[0])?, read(d[1])?] })
    }

    /// A ray of fixed-point words with `fraction_bits` after the point: entry points unsigned, travels signed.
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
    /// How close the walk came to another texel: the smallest change of compared parameters that leads to one, over M.
    /// 0 only on an exact tie.
    pub margin: f64,
    /// How close it came to the other value of `wall`: top and entry apart, over M. 0 only on an exact tie.
    pub wall_margin: f64,
    /// Texels visited.
    pub texels: u64,
}

/// A parameter: near, and exact when it must be.
struct Time<'a> {
    near: f64,
    exact: &'a dyn Fn() -> Result<Option<Ratio>>,
}

/// Compares, by f64 where that is safe.
struct Judge {
    filter: bool,
}

impl Judge {
    /// Exact order, and how far the two are apart; 0 only of equal ones. None stands for a parameter beyond all others.
    #[inline]
    fn order(&self, a: &Time<'_>, b: &Time<'_>) -> Result<(Ordering, f64)> {
        let apart = (a.near - b.near).abs();
        // Each is off by less than one part in 2^50.
        if self.filter && apart > (a.near + b.near) * 2f64.powi(-48) {
            return Ok((if a.near < b.near { Ordering::Less } else { Ordering::Greater }, apart));
        }
        Self::exactly(a, b)
    }

    #[cold]
    fn exactly(a: &Time<'_>, b: &Time<'_>) -> Result<(Ordering, f64)> {
        match ((a.exact)()?, (b.exact)()?) {
            (Some(a), Some(b)) => a.order(&b),
            (Some(_), None) => Ok((Ordering::Less, f64::INFINITY)),
            (None, Some(_)) => Ok((Ordering::Greater, f64::INFINITY)),
            (None, None) => Ok((Ordering::Equal, f64::INFINITY)),
        }
    }
}

impl ExactMap<'_> {
    /// Walks the texels along `ray` until it hits one.
    ///
    /// # Errors
    /// [`Error::Input`] if the ray is outside of its domain or the map's size is wrong, or if 256-bit integers don't hold the
    /// exact products (never with formats up to 8/23); a wrong answer is never returned.
    pub fn trace(&self, ray: &ExactRay) -> Result<ExactHit> {
        self.walk(ray, true)
    }

    /// As [`ExactMap::trace`], with every comparison in 256-bit integers: slow, and a check of the other.
    ///
    /// # Errors
    /// As [`ExactMap::trace`].
    pub fn trace_wide(&self, ray: &ExactRay) -> Result<ExactHit> {
        self.walk(ray, false)
    }

    fn walk(&self, ray: &ExactRay, filter: bool) -> Result<ExactHit> {
        if self.texels.len() != 1 << (2 * self.levels) {
            return Err(Error::input(format!("the map has {} texels, not 4^{}", self.texels.len(), self.levels)));
        }
        let size = [self.levels, self.height_bits];
        let mut u = Axis::new(ray.p[0], ray.d[0], size)?;
        let mut v = Axis::new(ray.p[1], ray.d[1], size)?;
        let judge = Judge { filter: filter && u.near_is_near && v.near_is_near };
        let bottom = (1u64 << self.height_bits) - 1;
        let mask = (1i64 << self.levels) - 1;
        let place = |i: i64, j: i64| (((j & mask) << self.levels) | (i & mask)) as usize;
        let top_of = |i: i64, j: i64| bottom - u64::from(self.texels[place(i, j)]);
        let mut margin = f64::INFINITY;
        // The plane last crossed; none yet.
        let mut entry_near = 0.0;
        let mut entry: Option<(bool, i64)> = None;
        for texels in 1.. {
            let top = top_of(u.at, v.at);
            let top_exact = || Ok(Some(Ratio::integer(top)));
            let (u_exact, v_exact) = (|| u.exit(), || v.exit());
            let top_time = Time { near: top as f64, exact: &top_exact };
            let (u_time, v_time) = (Time { near: u.near, exact: &u_exact }, Time { near: v.near, exact: &v_exact });
            let entry_exact = || entry_ratio(&u, &v, entry);
            let entry_time = Time { near: entry_near, exact: &entry_exact };
            let (order, gap) = judge.order(&u_time, &v_time)?;
            let u_first = order.is_le();
            let (exit, later) = if u_first { (&u_time, &v_time) } else { (&v_time, &u_time) };
            let (met, to_top) = judge.order(&top_time, exit)?;
            if met.is_lt() {
                let (room, to_entry) = judge.order(&entry_time, exit)?;
                // A texel touched only in a corner has no interior for the ray to end in.
                if room.is_lt() {
                    let (side, wall_margin) = judge.order(&top_time, &entry_time)?;
                    let wall = side.is_lt();
                    margin = margin.min(to_top.min(to_entry));
                    let t = if wall { entry_ratio(&u, &v, entry)?.expect("crossed") } else { Ratio::integer(top) };
                    return Ok(ExactHit {
                        i: (u.at & mask) as u32,
                        j: (v.at & mask) as u32,
                        wall,
                        t,
                        t_f64: t.to_f64(),
                        margin: if margin < NEVER / 2.0 { margin / bottom as f64 } else { f64::INFINITY },
                        wall_margin: wall_margin / bottom as f64,
                        texels,
                    });
                }
                margin = 0.0;
            }
            margin = margin.min(to_top);
            if gap < margin {
                // In the other order the ray would look at the texel on the other side of the corner.
                let aside = if u_first { top_of(u.at, v.ahead()) } else { top_of(u.ahead(), v.at) };
                let aside_exact = || Ok(Some(Ratio::integer(aside)));
                let (above, short) = judge.order(&Time { near: aside as f64, exact: &aside_exact }, later)?;
                margin = margin.min(if above.is_lt() { gap } else { gap.max(short) });
            }
            // An axis without an exit is never first: the top plane would have been met before.
            entry_near = exit.near;
            let crossed = if u_first { &mut u } else { &mut v };
            entry = Some((u_first, crossed.at));
            crossed.step();
        }
        unreachable!("the ray ends at the bottom plane")
    }
}

/// The exact parameter of the plane last crossed: of the axis u or not, out of this texel.
fn entry_ratio(u: &Axis, v: &Axis, entry: Option<(bool, i64)>) -> Result<Option<Ratio>> {
    match entry {
        None => Ok(Some(Ratio::integer(0))),
        Some((true, from)) => u.exit_of(from),
        Some((false, from)) => v.exit_of(from),
    }
}
