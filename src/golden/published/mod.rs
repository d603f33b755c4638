//! The published traversal (PIDM-HW sections 3 and 4.2, `docs/published.md`): positions are moved in floating point.
//!
//! Model of its own beside the watertight one; of that it shares the arithmetic and the rules for levels.
mod setup;

pub use setup::{Route, Travel};

use super::float;
use super::level::{Crossing, descend_levels, level_up};
use super::pyramid::Pyramid;
use super::record::{Decision, Iteration, RayHit};
use super::setup::RayInput;
use crate::config::Design;
use crate::error::{Error, Result};

/// A tracer for one design of the published datapath, with the design's constants at hand.
#[derive(Clone, Debug)]
pub struct Published {
    design: Design,
    /// IDX_W.
    idx_w: u32,
    /// 1, encoded: the ray parameter at the bottom plane.
    one: u64,
    /// Encoded parameter at which a ray meets a node of maximum height code H, by H: (M - H) * (1 / M).
    tops: Vec<u64>,
}

/// Where a ray can leave a node along one axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exit {
    /// The plane, in texels.
    pub plane: i64,
    /// The same as a number.
    pub edge: u64,
    /// Ray parameter at the plane, or a nudge behind it.
    pub t: u64,
}

impl Published {
    /// A tracer for `design`.
    ///
    /// # Errors
    /// [`Error::Input`] if the sizes are outside of the ranges of `docs/published.md`.
    pub fn new(design: &Design) -> Result<Self> {
        let (fmt, size, nudge) = (design.format, design.traverse, design.datapath.nudge_bits);
        let bias = u32::try_from(fmt.bias()).unwrap_or(0);
        let (n, h, tile) = (size.levels, size.height_bits, size.tile_bits);
        let legal = (2..=11).contains(&fmt.exp)
            && (7..=52).contains(&fmt.man)
            && (2..=12).contains(&n)
            && (2..=16).contains(&h)
            && h <= fmt.man + 1
            && (1..=8).contains(&tile)
            && size.idx_bits() <= 24
            && nudge <= 16
            // The nudged plane is converted in one word.
            && size.idx_bits() + nudge + fmt.man <= 60
            // The plane behind the farthest texel is a finite number, and so is the parameter of a height code.
            && n + tile < bias
            && h + 2 <= bias
            && (1..=16).contains(&size.frac_bits)
            && (1..=4).contains(&design.mode.levels_down)
            && (1..=65535).contains(&size.step_limit);
        if !legal {
            return Err(Error::input(format!(
                "no published datapath of {n} levels, {h} height bits, {tile} tile bits, {nudge} nudge bits and format {fmt}: see docs/published.md, Parameters"
            )));
        }
        let m = (1u64 << h) - 1;
        let inv = float::recip_int(fmt, m);
        let top = |height: u64| float::mul(fmt, float::from_int(fmt, (m - height) as i64), inv);
        let one = float::from_int(fmt, 1);
        Ok(Self { design: *design, idx_w: size.idx_bits(), one, tops: (0..=m).map(top).collect() })
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
        self.trace_with(pyramid, ray, |_| ())
    }

    /// Traces a ray and shows every iteration to `see`; the trip that finds the start level is none.
    ///
    /// # Panics
    /// As [`Published::trace`].
    pub fn trace_with(&self, pyramid: &Pyramid, ray: &RayInput, mut see: impl FnMut(&Iteration)) -> RayHit {
        let (fmt, size) = (self.design.format, &self.design.traverse);
        assert_eq!((pyramid.levels(), pyramid.height_bits()), (size.levels, size.height_bits), "wrong pyramid");
        let Some(route) = self.route(ray) else {
            return RayHit { limit: true, ..RayHit::default() };
        };
        let mut state =
            State { level: self.first_level(&route), x: route.u.x, y: route.v.x, t: 0, crossed: false, prev: false };
        let mut hit = RayHit::default();
        loop {
            let it = self.iterate(pyramid, &route, &state);
            see(&it);
            hit.steps += 1;
            let crossing = matches!(it.decision, Decision::CrossX | Decision::CrossY);
            hit.crossings += u32::from(crossing);
            hit.ups += u32::from(crossing && it.next_level > it.level);
            let crossed = state.crossed || crossing;
            state = State { level: it.next_level, x: it.next_x, y: it.next_y, t: it.next_t, crossed, prev: crossing };
            if it.decision == Decision::Hit {
                hit.wall = float::lt(fmt, it.t_v, it.t);
                break;
            }
            if hit.steps == size.step_limit {
                hit.limit = true;
                break;
            }
        }
        let side = 1i64 << size.levels;
        hit.t = state.t;
        (hit.i, hit.j) = (state.x.rem_euclid(side) as u32, state.y.rem_euclid(side) as u32);
        (hit.fu, hit.fv) = (self.fraction(&route.u, state.t), self.fraction(&route.v, state.t));
        hit
    }

    /// Ray parameter where a node of maximum height code `height` is met.
    pub fn height_time(&self, height: u32) -> u64 {
        self.tops[height as usize]
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

    /// The plane by which the ray can leave the level-`k` node of texel `x`.
    pub fn exit(&self, axis: &Travel, k: u32, x: i64) -> Exit {
        let (fmt, nudge) = (self.design.format, self.design.datapath.nudge_bits);
        let size = 1i64 << k;
        let first = x.div_euclid(size) * size;
        let plane = self.wrapped(if axis.neg { first } else { first + size });
        let step = match (nudge, axis.neg) {
            (0, _) => 0,
            (_, false) => 1,
            (_, true) => -1,
        };
        let behind = float::from_fixed(fmt, (plane << nudge) + step, nudge);
        let away = float::add(fmt, behind, float::neg(fmt, axis.p));
        Exit { plane, edge: float::from_int(fmt, plane), t: float::div(fmt, away, axis.d) }
    }

    /// Whether a position lies at or behind the exit plane.
    pub fn beyond(&self, axis: &Travel, position: u64, edge: u64) -> bool {
        float::lt(self.design.format, position, edge) == axis.neg
    }

    fn iterate(&self, pyramid: &Pyramid, route: &Route, s: &State) -> Iteration {
        let (fmt, n, k) = (self.design.format, self.design.traverse.levels, s.level);
        let node = |x: i64| (x.rem_euclid(1 << n) >> k) as u32;
        let height = pyramid.node(k, node(s.x), node(s.y));
        let t_v = self.height_time(height);
        let (x, y) = (self.exit(&route.u, k, s.x), self.exit(&route.v, k, s.y));
        let m = self.max(s.t, t_v);
        let (hit_x, hit_y) = (self.position(&route.u, m), self.position(&route.v, m));
        let (e_x, e_y) = (self.texel(hit_x), self.texel(hit_y));
        // x goes first on a tie; the position is then behind both planes.
        let x_first = !float::lt(fmt, y.t, x.t);
        let t_e = if x_first { x.t } else { y.t };
        let elsewhere = self.beyond(&route.u, hit_x, x.edge) || self.beyond(&route.v, hit_y, y.edge);
        let past_end = float::lt(fmt, self.one, t_e);
        let mut it = Iteration {
            level: k,
            x: s.x,
            y: s.y,
            t: s.t,
            height,
            t_v,
            b_x: x.plane,
            b_y: y.plane,
            t_x: x.t,
            t_y: y.t,
            m,
            e_x,
            e_y,
            chord: None,
            decision: Decision::Hit,
            next_level: k,
            next_x: e_x,
            next_y: e_y,
            next_t: m,
        };
        if !elsewhere || past_end {
            if k > 0 {
                it.decision = Decision::Descend;
                it.next_level = k - descend_levels(self.design.mode.levels_down, k, s.crossed);
            }
            return it;
        }
        it.decision = if x_first { Decision::CrossX } else { Decision::CrossY };
        it.next_x = self.texel(self.position(&route.u, t_e));
        it.next_y = self.texel(self.position(&route.v, t_e));
        it.next_t = self.max(s.t, t_e);
        let plane = if x_first { x.plane } else { y.plane };
        let c = Crossing { level: k, plane, x: s.x, y: s.y, e_x, e_y, previous: s.prev };
        it.next_level = n.min(k + u32::from(level_up(self.design.mode.level_up, &c)));
        it
    }

    /// The larger of two parameters; the first when they are equal.
    fn max(&self, a: u64, b: u64) -> u64 {
        if float::lt(self.design.format, a, b) { b } else { a }
    }

    /// A coordinate in a word of IDX_W bits.
    fn wrapped(&self, v: i64) -> i64 {
        let spare = 64 - self.idx_w;
        (v << spare) >> spare
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
}
