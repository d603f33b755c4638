//! One iteration after the other: all windows at once.
use super::Windows;
use super::setup::WindowAxis;
use crate::pyramid::Pyramid;
use crate::record::{Decision, Iteration, RayHit, RayInput};
use crate::walk::leave;
use crate::window_maps::WindowMap;
use reliefrtl_config::WindowSet;

/// What one iteration hands to the next.
#[derive(Clone, Copy, Debug)]
struct State {
    /// k: planes that the ray has passed, along u and v.
    k: [i64; 2],
    t: u64,
}

/// A window of one size at a ray's place.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    height: u32,
    /// r: texels beyond the ray's, along u and v.
    r: [i64; 2],
    /// Parameters of its planes.
    planes: [u64; 2],
    /// O: where the ray leaves it.
    exit: u64,
    /// d: the depth of its highest code.
    depth: u64,
}

impl Seen {
    /// The window can hold the hit.
    fn inside(&self) -> bool {
        self.depth < self.exit
    }

    /// The ray leaves it by a plane of constant u; so it does on a tie.
    fn x_first(&self) -> bool {
        self.planes[0] <= self.planes[1]
    }
}

impl Windows {
    /// Traces a ray, and shows every iteration to `see`.
    ///
    /// # Panics
    /// If the pyramid has other levels or height bits than the design.
    pub(super) fn walk(&self, pyramid: &Pyramid, ray: &RayInput, see: &mut dyn FnMut(&Iteration)) -> RayHit {
        let size = &self.fixed.design.traverse;
        assert_eq!((pyramid.levels(), pyramid.height_bits()), (size.levels, size.height_bits), "wrong pyramid");
        let Some(axes) = self.setup(ray) else {
            return RayHit { limit: true, ..RayHit::default() };
        };
        let maps = pyramid.windows(&self.set);
        let mut state = State { k: [0, 0], t: 0 };
        let mut hit = RayHit::default();
        loop {
            let (next, it) = self.iterate(maps.maps(), &axes, &state);
            see(&it);
            hit.steps += 1;
            state = next;
            if it.decision == Decision::Hit {
                hit.wall = it.t_v < it.t;
                break;
            }
            if hit.steps == size.step_limit {
                hit.limit = true;
                break;
            }
        }
        hit.t = state.t;
        (hit.i, hit.fu) = leave(&self.fixed, &axes[0].fixed, axes[0].texel(state.k[0]), state.t, 0);
        (hit.j, hit.fv) = leave(&self.fixed, &axes[1].fixed, axes[1].texel(state.k[1]), state.t, 0);
        hit
    }

    fn look(&self, map: &WindowMap, axes: &[WindowAxis; 2], s: &State) -> Seen {
        let window = map.window();
        let both = |of: &dyn Fn(&WindowAxis, i64) -> i64| [of(&axes[0], s.k[0]), of(&axes[1], s.k[1])];
        let r = both(&|axis, k| axis.beyond(k, window));
        let [i, j] = both(&|axis, k| axis.index(k, window));
        let planes = [0, 1].map(|c| self.plane_time(&axes[c], s.k[c] + r[c]));
        let height = map.word(i, j);
        let depth = self.fixed.height_time(u64::from(height));
        Seen { height, r, planes, exit: planes[0].min(planes[1]), depth }
    }

    fn iterate(&self, maps: &[WindowMap], axes: &[WindowAxis; 2], s: &State) -> (State, Iteration) {
        let mut seen = [Seen::default(); WindowSet::MOST];
        for (seen, map) in seen.iter_mut().zip(maps) {
            *seen = self.look(map, axes, s);
        }
        let seen = &seen[..maps.len()];
        let texel = seen[0];
        let a = seen.iter().rposition(|w| !w.inside()).unwrap_or(0);
        let (left, larger) = (seen[a], seen.get(a + 1));
        let hit = texel.inside() && s.t < texel.exit;
        let m = match (hit, texel.inside()) {
            (true, _) => s.t.max(texel.depth),
            (false, true) => s.t,
            (false, false) => s.t.max(left.exit).max(larger.map_or(0, |w| w.depth)),
        };
        let x_first = left.x_first();
        let e = [0, 1].map(|c| self.planes_passed(&axes[c], m));
        let mut next = State { k: s.k, t: m };
        if !hit {
            let c = usize::from(!x_first);
            next.k[c] += left.r[c] + 1;
            next.k = [0, 1].map(|c| next.k[c].max(e[c]));
        }
        let decision = match (hit, x_first) {
            (true, _) => Decision::Hit,
            (false, true) => Decision::CrossX,
            (false, false) => Decision::CrossY,
        };
        let texels = |k: [i64; 2]| [0, 1].map(|c| axes[c].texel(k[c]));
        let ([x, y], [next_x, next_y], [e_x, e_y]) = (texels(s.k), texels(next.k), texels(e));
        let [b_x, b_y] = [0, 1].map(|c| axes[c].plane(s.k[c] + left.r[c]));
        let it = Iteration {
            level: a as u32,
            x,
            y,
            t: s.t,
            chord: None,
            height: left.height,
            t_v: left.depth,
            b_x,
            b_y,
            t_x: left.planes[0],
            t_y: left.planes[1],
            m,
            e_x,
            e_y,
            decision,
            next_level: 0,
            next_x,
            next_y,
            next_t: m,
        };
        (next, it)
    }
}
