//! The traversal in fixed point: from a ray to the texel it hits.
use super::super::level::{Crossing, descend_levels, level_up, trim_return};
use super::super::pyramid::Pyramid;
use super::super::record::{Decision, Iteration, RayHit};
use super::super::setup::RayInput;
use super::{FixedAxis, FixedSetup, GUARD, illegal, time_fraction};
use crate::config::{Design, LevelUp, Trim};
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
        self.run::<false>(pyramid, ray, &mut |_| ())
    }

    /// Traces a ray and shows every iteration to `see`.
    ///
    /// # Panics
    /// As [`Fixed::trace`].
    pub fn trace_with(&self, pyramid: &Pyramid, ray: &RayInput, mut see: impl FnMut(&Iteration)) -> RayHit {
        self.run::<true>(pyramid, ray, &mut see)
    }

    /// `SEEN`: somebody looks at the iterations, so that what no decision needs is computed too.
    fn run<const SEEN: bool>(&self, pyramid: &Pyramid, ray: &RayInput, see: &mut dyn FnMut(&Iteration)) -> RayHit {
        let size = &self.design.traverse;
        assert_eq!((pyramid.levels(), pyramid.height_bits()), (size.levels, size.height_bits), "wrong pyramid");
        let setup = self.setup(ray);
        if !setup.valid {
            return RayHit { limit: true, ..RayHit::default() };
        }
        let mut at = Place {
            level: setup.level,
            x: setup.u.x,
            y: setup.v.x,
            t: 0,
            crossed: false,
            prev: false,
            descended: false,
        };
        let mut hit = RayHit::default();
        loop {
            let it = self.iterate::<SEEN>(pyramid, &setup, &at);
            if SEEN {
                see(&it);
            }
            let crossing = matches!(it.decision, Decision::CrossX | Decision::CrossY);
            hit.steps += 1;
            hit.crossings += u32::from(crossing);
            hit.ups += u32::from(crossing && it.next_level > it.level);
            at = Place {
                level: it.next_level,
                x: it.next_x,
                y: it.next_y,
                t: it.next_t,
                crossed: at.crossed || crossing,
                prev: crossing,
                descended: it.decision == Decision::Descend,
            };
            if it.decision == Decision::Hit {
                hit.wall = it.t > it.t_v;
                break;
            }
            if hit.steps == size.step_limit {
                hit.limit = true;
                break;
            }
        }
        hit.t = at.t;
        (hit.i, hit.fu) = self.leave(&setup.u, at.t, at.x, setup.lod);
        (hit.j, hit.fv) = self.leave(&setup.v, at.t, at.y, setup.lod);
        hit
    }

    fn iterate<const SEEN: bool>(&self, pyramid: &Pyramid, setup: &FixedSetup, at: &Place) -> Iteration {
        let (n, k, rule) = (self.design.traverse.levels, at.level, self.design.mode.level_up);
        let (b_x, t_x) = self.exit(&setup.u, k, at.x);
        let (b_y, t_y) = self.exit(&setup.v, k, at.y);
        let trims = match self.design.mode.trim {
            Trim::None => false,
            Trim::Descent => at.descended,
            Trim::Always => true,
        };
        let chord = trims.then(|| self.chord(setup, k, [at.x, at.y], [t_x, t_y]));
        // The node that is read: all else but a descent goes on from the node of level k.
        let r = chord.map_or(k, |c| c.level);
        let height = pyramid.node(r, self.wrap(at.x) >> r, self.wrap(at.y) >> r);
        let t_v = self.height_time(u64::from(height));
        let m = at.t.max(t_v);
        let inside = m < t_x && m < t_y;
        let estimates = SEEN || (inside && r > setup.lod) || (!inside && rule == LevelUp::Selective);
        let (e_x, e_y) = if estimates { (self.estimate(&setup.u, m), self.estimate(&setup.v, m)) } else { (0, 0) };
        let mut it = Iteration {
            level: k,
            x: at.x,
            y: at.y,
            t: at.t,
            height,
            t_v,
            b_x,
            b_y,
            t_x,
            t_y,
            m,
            e_x,
            e_y,
            chord,
            decision: Decision::Hit,
            next_level: k,
            next_x: at.x,
            next_y: at.y,
            next_t: m,
        };
        if inside && r == setup.lod {
            it.next_level = r;
            return it;
        }
        if inside {
            it.decision = Decision::Descend;
            it.next_level = (r - descend_levels(self.design.mode.levels_down, r, at.crossed)).max(setup.lod);
            it.next_x = onward(&setup.u, k, at.x, e_x);
            it.next_y = onward(&setup.v, k, at.y, e_y);
            return it;
        }
        // Both planes at once: x goes first.
        let x_first = t_x <= t_y;
        let plane = if x_first { b_x } else { b_y };
        let behind = |axis: &FixedAxis| if axis.neg { plane - 1 } else { plane };
        if x_first {
            (it.decision, it.next_x) = (Decision::CrossX, behind(&setup.u));
        } else {
            (it.decision, it.next_y) = (Decision::CrossY, behind(&setup.v));
        }
        it.next_t = at.t.max(t_x.min(t_y));
        let c = |level| Crossing { level, plane, x: at.x, y: at.y, e_x, e_y, previous: at.prev };
        it.next_level = if r < k { trim_return(rule, k, &c(r)) } else { n.min(k + u32::from(level_up(rule, &c(k)))) };
        it
    }

    /// t_v of a height code: its depth, as the parameter counts height codes, without any rounding.
    pub fn height_time(&self, height: u64) -> u64 {
        (self.bottom - height) << self.time_fraction
    }

    /// The plane by which the ray can leave the level-k node of texel `x`, and the parameter there.
    fn exit(&self, axis: &FixedAxis, k: u32, x: i64) -> (i64, u64) {
        let first = x >> k << k;
        let b = if axis.neg { first } else { first + (1 << k) };
        let plane = i128::from(b) << (self.fraction - self.design.traverse.levels);
        // A ray never comes back to a plane, so the plane lies ahead of the entry point or goes through it.
        let distance = (plane - i128::from(axis.p)).unsigned_abs() as u64;
        (b, self.plane_time(distance, axis.r, axis.z))
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

    /// Wrapped texel, and position inside it in units of 2^-FRAC_W: where the ray is at `t`, kept in the level-`lod` node of texel `x`.
    pub fn leave(&self, axis: &FixedAxis, t: u64, x: i64, lod: u32) -> (u32, u32) {
        let (below, frac) = (self.fraction - self.design.traverse.levels, self.design.traverse.frac_bits);
        let (first, last) = (x >> lod << lod, x | ((1 << lod) - 1));
        let at =
            (self.at(axis, t) << frac >> below).clamp(i128::from(first) << frac, (i128::from(last + 1) << frac) - 1);
        (self.wrap((at >> frac) as i64), (at & ((1 << frac) - 1)) as u32)
    }

    /// The map repeats.
    fn wrap(&self, x: i64) -> u32 {
        x.rem_euclid(1 << self.design.traverse.levels) as u32
    }
}

/// What one iteration hands to the next.
#[derive(Clone, Copy, Debug)]
struct Place {
    level: u32,
    x: i64,
    y: i64,
    t: u64,
    /// Something was crossed so far.
    crossed: bool,
    /// The last iteration crossed.
    prev: bool,
    /// The last iteration descended.
    descended: bool,
}

/// The texel to go on from inside the level-k node of `x`: the estimate, but in the node, and never before `x`.
fn onward(axis: &FixedAxis, k: u32, x: i64, e: i64) -> i64 {
    let (first, last) = (x >> k << k, x | ((1 << k) - 1));
    if axis.neg { e.clamp(first, x) } else { e.clamp(x, last) }
}
