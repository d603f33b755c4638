//! The walk from node to node, or from one block of four cells to the next: the same for every datapath that compares parameters of planes; what it computes with is a [`PlaneArithmetic`].
use super::cells;
use super::level::{Crossing, descend_levels, level_after, trim_return};
use super::planes::{AxisView, PlaneArithmetic, Setup, kept};
use super::pyramid::Pyramid;
use super::record::{Decision, Iteration, RayHit, RayInput};
use super::state::{State, cross, exit, wrap};
use super::trim::chord;
use reliefrtl_config::{LevelUp, Trim};

/// Traces a ray, and shows every iteration to `on_iteration`.
///
/// # Panics
/// If the pyramid has other levels or height bits than the design.
pub(super) fn walk<P: PlaneArithmetic>(
    planes: &P,
    pyramid: &Pyramid,
    ray: &RayInput,
    on_iteration: Option<&mut dyn FnMut(&Iteration)>,
) -> RayHit {
    match on_iteration {
        Some(see) => walk_on::<true, P>(planes, pyramid, ray, see),
        None => walk_on::<false, P>(planes, pyramid, ray, &mut |_| ()),
    }
}

/// As [`walk`]. `RECORD`: the iterations are looked at, so that what no decision needs is computed too.
fn walk_on<const RECORD: bool, P: PlaneArithmetic>(
    planes: &P,
    pyramid: &Pyramid,
    ray: &RayInput,
    see: &mut dyn FnMut(&Iteration),
) -> RayHit {
    let size = &planes.design().traverse;
    assert_eq!((pyramid.levels(), pyramid.height_bits()), (size.levels, size.height_bits), "wrong pyramid");
    let setup = planes.ray(ray);
    if !setup.valid {
        return RayHit { limit: true, ..RayHit::default() };
    }
    let mut state = State {
        level: setup.level,
        x: setup.u.entry(),
        y: setup.v.entry(),
        t: 0,
        crossed: false,
        prev: false,
        descended: false,
    };
    let mut hit = RayHit::default();
    loop {
        let (it, wall) = if planes.design().fetch.blocks() {
            cells::iterate::<RECORD, P>(planes, pyramid, &setup, &state)
        } else {
            let it = iterate::<RECORD, P>(planes, pyramid, &setup, &state);
            (it, planes.lt(it.t_v, it.t))
        };
        if RECORD {
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
            hit.wall = wall;
            break;
        }
        if hit.steps == size.step_limit {
            hit.limit = true;
            break;
        }
    }
    hit.t = state.t;
    (hit.i, hit.fu) = leave(planes, &setup.u, state.x, state.t, setup.lod);
    (hit.j, hit.fv) = leave(planes, &setup.v, state.y, state.t, setup.lod);
    hit
}

/// Wrapped texel and position inside it: where the ray is at `t`, kept in the level-`lod` node of texel `x`.
pub(super) fn leave<P: PlaneArithmetic>(planes: &P, axis: &P::Axis, x: i64, t: u64, lod: u32) -> (u32, u32) {
    let size = &planes.design().traverse;
    let mask = (1i64 << lod) - 1;
    let (first, beyond) = ((x & !mask) << size.frac_bits, ((x | mask) + 1) << size.frac_bits);
    let kept = planes.position(axis, t).clamp(first, beyond - 1);
    (wrap(kept >> size.frac_bits, size.levels), (kept & ((1 << size.frac_bits) - 1)) as u32)
}

fn iterate<const RECORD: bool, P: PlaneArithmetic>(
    planes: &P,
    pyramid: &Pyramid,
    setup: &Setup<P::Axis>,
    s: &State,
) -> Iteration {
    let (n, mode) = (planes.design().traverse.levels, planes.design().mode);
    let (k, rule) = (s.level, mode.level_up);
    let (b_x, b_y) = (exit(&setup.u, k, s.x), exit(&setup.v, k, s.y));
    let (t_x, t_y) = (planes.plane_time(&setup.u, b_x), planes.plane_time(&setup.v, b_y));
    let trims = match mode.trim {
        Trim::None => false,
        Trim::Descent => s.descended,
        Trim::Always => true,
    };
    let chord = trims.then(|| chord(planes, setup, k, [s.x, s.y], [t_x, t_y]));
    // The node that is read: all else but a descent goes on from the node of level k.
    let r = chord.map_or(k, |c| c.level);
    let height = pyramid.node(r, wrap(s.x, n) >> r, wrap(s.y, n) >> r);
    let t_v = planes.height_time(height);
    let m = planes.max(s.t, t_v);
    let inside = planes.lt(m, t_x) && planes.lt(m, t_y);
    let estimates = RECORD || (inside && r > setup.lod) || (!inside && rule == LevelUp::Selective);
    let (e_x, e_y) =
        if estimates { (planes.texel_lower_bound(&setup.u, m), planes.texel_lower_bound(&setup.v, m)) } else { (0, 0) };

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
    if inside {
        it.decision = Decision::Descend;
        it.next_level = (r - descend_levels(mode.levels_down, r, s.crossed)).max(setup.lod);
        it.next_x = kept(&setup.u, k, s.x, e_x);
        it.next_y = kept(&setup.v, k, s.y, e_y);
        return it;
    }
    // x goes first on a tie.
    let x_first = planes.x_first(t_x, t_y);
    let (t_e, plane) = cross(&mut it, setup, x_first);
    it.next_t = planes.max(s.t, t_e);
    let c = |level| Crossing { level, plane, x: s.x, y: s.y, e_x, e_y, previous: s.prev };
    it.next_level = if r < k { trim_return(rule, k, &c(r)) } else { level_after(&mode, n, k, &c(k)) };
    it
}
