//! The traversal: from a ray to the texel it hits.
use super::float;
use super::level::{Crossing, descend_levels, level_up, trim_return};
use super::pyramid::Pyramid;
use super::record::{Decision, Iteration, RayHit};
use super::setup::{Axis, RayInput, Setup, power_of_two};
use crate::config::{Design, Trim};
use crate::error::{Error, Result};

/// A tracer for one design, with the design's constants at hand.
#[derive(Clone, Debug)]
pub struct Golden {
    pub(super) design: Design,
    /// IDX_W.
    pub(super) idx_w: u32,
    /// 1, encoded.
    pub(super) one: u64,
    /// 2^TILE_W, encoded: what a ray's travel stays below.
    pub(super) travel_end: u64,
    /// 2^n, encoded.
    pub(super) texels_per_tile: u64,
    /// M = 2^HEIGHT_W - 1, encoded: the ray parameter at the bottom plane.
    pub(super) bottom: u64,
    /// C = 1 / M, encoded.
    pub(super) inv_bottom: u64,
    /// Encoded parameter at which a ray meets a node of maximum height code H, by H.
    tops: Vec<u64>,
}

impl Golden {
    /// A tracer for `design`.
    ///
    /// # Errors
    /// [`Error::Input`] if the sizes are outside of the ranges of `docs/datapath.md`.
    pub fn new(design: &Design) -> Result<Self> {
        let (fmt, size) = (design.format, design.traverse);
        let bias = u32::try_from(fmt.bias()).unwrap_or(0);
        let (n, h, tile) = (size.levels, size.height_bits, size.tile_bits);
        let legal = (2..=11).contains(&fmt.exp)
            && (7..=52).contains(&fmt.man)
            && (2..=12).contains(&n)
            && (2..=16).contains(&h)
            && h <= fmt.man + 1
            && (1..=8).contains(&tile)
            && size.idx_bits() <= 24
            // The plane behind the farthest texel is a finite number.
            && n + tile < bias
            && h + 2 <= bias
            // The position estimate is biased by 2^(n + 1 - man) at least, which must stand clear of underflow.
            && fmt.man <= bias + n
            && (1..=16).contains(&size.frac_bits)
            && (1..=4).contains(&design.mode.levels_down)
            && (1..=65535).contains(&size.step_limit)
            // A chord's end is estimated forward by more than all errors, what underflows included.
            && (design.mode.trim == Trim::None || fmt.man + 4 <= bias);
        if !legal {
            return Err(Error::input(format!(
                "no datapath of {n} levels, {h} height bits, {tile} tile bits and format {fmt}: see docs/datapath.md, Parameters"
            )));
        }
        let m = (1u64 << h) - 1;
        Ok(Self {
            design: *design,
            idx_w: size.idx_bits(),
            one: power_of_two(fmt, 0),
            travel_end: power_of_two(fmt, tile as i32),
            texels_per_tile: power_of_two(fmt, n as i32),
            bottom: float::from_int(fmt, m as i64),
            inv_bottom: float::recip_int(fmt, m),
            tops: (0..=m).map(|height| float::from_int(fmt, (m - height) as i64)).collect(),
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
    /// As [`Golden::trace`].
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
        let mut state = State {
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
            let it = self.iterate::<SEEN>(pyramid, &setup, &state);
            if SEEN {
                see(&it);
            }
            hit.steps += 1;
            let crossing = matches!(it.decision, Decision::CrossX | Decision::CrossY);
            hit.crossings += u32::from(crossing);
            hit.ups += u32::from(crossing && it.next_level > it.level);
            state = State {
                level: it.next_level,
                x: it.next_x,
                y: it.next_y,
                t: it.next_t,
                crossed: state.crossed || crossing,
                prev: crossing,
                descended: it.decision == Decision::Descend,
            };
            if it.decision == Decision::Hit {
                hit.wall = float::lt(self.design.format, it.t_v, it.t);
                break;
            }
            if hit.steps == size.step_limit {
                hit.limit = true;
                break;
            }
        }
        hit.t = state.t;
        (hit.i, hit.fu) = self.leave(&setup.u, state.x, state.t, setup.lod);
        (hit.j, hit.fv) = self.leave(&setup.v, state.y, state.t, setup.lod);
        hit
    }

    /// Wrapped texel and position inside it: where the ray is at `t`, kept in the level-`lod` node of texel `x`.
    fn leave(&self, axis: &Axis, x: i64, t: u64, lod: u32) -> (u32, u32) {
        let (fmt, size) = (self.design.format, &self.design.traverse);
        let at = float::add(fmt, axis.p, float::mul(fmt, axis.dt, t));
        let at = float::to_fixed(fmt, at, self.idx_w + size.frac_bits, size.frac_bits);
        let mask = (1i64 << lod) - 1;
        let kept = at.clamp((x & !mask) << size.frac_bits, (((x | mask) + 1) << size.frac_bits) - 1);
        (wrap(kept >> size.frac_bits, size.levels), (kept & ((1 << size.frac_bits) - 1)) as u32)
    }

    fn iterate<const SEEN: bool>(&self, pyramid: &Pyramid, setup: &Setup, s: &State) -> Iteration {
        let (fmt, n, rule) = (self.design.format, self.design.traverse.levels, self.design.mode.level_up);
        let k = s.level;
        let (b_x, t_x) = self.exit(&setup.u, k, s.x);
        let (b_y, t_y) = self.exit(&setup.v, k, s.y);
        let trims = match self.design.mode.trim {
            Trim::None => false,
            Trim::Descent => s.descended,
            Trim::Always => true,
        };
        let chord = trims.then(|| self.chord(setup, k, [s.x, s.y], [t_x, t_y]));
        // The node that is read: all else but a descent goes on from the node of level k.
        let r = chord.map_or(k, |c| c.level);
        let height = pyramid.node(r, wrap(s.x, n) >> r, wrap(s.y, n) >> r);
        let t_v = self.tops[height as usize];
        let m = self.later(s.t, t_v);
        let inside = float::lt(fmt, m, t_x) && float::lt(fmt, m, t_y);
        let estimates = SEEN || (inside && r > setup.lod) || (!inside && rule == crate::config::LevelUp::Selective);
        let (e_x, e_y) = if estimates { (self.estimate(&setup.u, m), self.estimate(&setup.v, m)) } else { (0, 0) };

        let mut it = Iteration {
            level: k,
            x: s.x,
            y: s.y,
            t: s.t,
            chord,
            height,
            t_v,
            b_x,
            b_y,
            t_x,
            t_y,
            m,
            e_x,
            e_y,
            decision: Decision::Hit,
            next_level: k,
            next_x: s.x,
            next_y: s.y,
            next_t: m,
        };
        if inside && r == setup.lod {
            it.next_level = r;
            return it;
        }
        let mask = (1i64 << k) - 1;
        if inside {
            it.decision = Decision::Descend;
            it.next_level = (r - descend_levels(self.design.mode.levels_down, r, s.crossed)).max(setup.lod);
            it.next_x = descend(&setup.u, s.x, mask, e_x);
            it.next_y = descend(&setup.v, s.y, mask, e_y);
            return it;
        }
        // x goes first on a tie.
        let x_first = !float::lt(fmt, t_y, t_x);
        let (t_e, plane) = if x_first { (t_x, b_x) } else { (t_y, b_y) };
        if x_first {
            it.decision = Decision::CrossX;
            it.next_x = beyond(&setup.u, b_x);
        } else {
            it.decision = Decision::CrossY;
            it.next_y = beyond(&setup.v, b_y);
        }
        it.next_t = self.later(s.t, t_e);
        let c = |level| Crossing { level, plane, x: s.x, y: s.y, e_x, e_y, previous: s.prev };
        it.next_level = if r < k { trim_return(rule, k, &c(r)) } else { n.min(k + u32::from(level_up(rule, &c(k)))) };
        it
    }

    /// The plane by which the ray can leave the level-k node of texel `x`, and the parameter there.
    fn exit(&self, axis: &Axis, k: u32, x: i64) -> (i64, u64) {
        let fmt = self.design.format;
        let mask = (1i64 << k) - 1;
        let b = if axis.neg { x & !mask } else { (x | mask) + 1 };
        if axis.never {
            return (b, fmt.infinity());
        }
        let away = float::add(fmt, float::from_int(fmt, b), float::neg(fmt, axis.p));
        (b, float::mul(fmt, away, axis.r))
    }

    /// The texel where the ray is at `t`, or one that it has left already: never one that it has yet to reach.
    fn estimate(&self, axis: &Axis, t: u64) -> i64 {
        let fmt = self.design.format;
        float::to_int(fmt, float::add(fmt, axis.pb, float::mul(fmt, axis.dt, t)), self.idx_w)
    }

    /// The larger of two parameters; the first when they are equal.
    fn later(&self, a: u64, b: u64) -> u64 {
        if float::lt(self.design.format, a, b) { b } else { a }
    }
}

/// What one iteration hands to the next.
#[derive(Clone, Copy, Debug)]
struct State {
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

/// The texel to go on from inside the node of `x`: the estimate, but still in the node, and never before `x`.
///
/// The estimate may lie behind a plane that was crossed already. Going back there would cost steps on an axis that moves,
/// could repeat for ever when each crossing goes a level up, and on an axis that never crosses would be wrong for good.
fn descend(axis: &Axis, x: i64, mask: i64, e: i64) -> i64 {
    if axis.neg { e.clamp(x & !mask, x) } else { e.clamp(x, x | mask) }
}

/// The texel behind plane `b`, seen along the ray.
fn beyond(axis: &Axis, b: i64) -> i64 {
    if axis.neg { b - 1 } else { b }
}

/// The map repeats.
fn wrap(x: i64, n: u32) -> u32 {
    x.rem_euclid(1 << n) as u32
}
