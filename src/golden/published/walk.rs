//! The walk of the published traversal: positions are moved.
use super::model::Published;
use super::route::{Route, Travel};
use crate::float;
use crate::level::{Crossing, descend_levels, level_after};
use crate::pyramid::Pyramid;
use crate::record::{Decision, Iteration, RayHit, RayInput};

/// Where a ray can leave a node along one axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exit {
    /// The plane, in texels.
    pub plane: i64,
    /// The same as a number.
    pub edge: u64,
    /// Ray parameter at the plane, or a nudge past it.
    pub t: u64,
}

impl Published {
    /// Traces a ray and shows every iteration to `see`; the trip that finds the start level is none.
    ///
    /// # Panics
    /// If the pyramid has other levels or height bits than the design.
    pub(super) fn walk(&self, pyramid: &Pyramid, ray: &RayInput, see: &mut dyn FnMut(&Iteration)) -> RayHit {
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
        let beyond = float::from_fixed(fmt, (plane << nudge) + step, nudge);
        let away = float::add(fmt, beyond, float::neg(fmt, axis.p));
        Exit { plane, edge: float::from_int(fmt, plane), t: float::div(fmt, away, axis.d) }
    }

    /// Whether a position lies at or beyond the exit plane.
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
        // x goes first on a tie; the position is then past both planes.
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
        it.next_level = level_after(&self.design.mode, n, k, &c);
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
