//! Where a ray is between two iterations, and integer planes around it.
use super::planes::{AxisView, Setup};
use super::record::{Decision, Iteration};

/// What one iteration hands to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    /// Level of the node, or of the block's cells.
    pub(super) level: u32,
    pub(super) x: i64,
    pub(super) y: i64,
    pub(super) t: u64,
    /// Something was crossed so far.
    pub(super) crossed: bool,
    /// The last iteration crossed.
    pub(super) prev: bool,
    /// The last iteration descended.
    pub(super) descended: bool,
}

/// The plane by which the ray can leave the level-k node of texel `x`.
pub(super) fn exit(axis: &impl AxisView, k: u32, x: i64) -> i64 {
    let mask = (1i64 << k) - 1;
    if axis.neg() { x & !mask } else { (x | mask) + 1 }
}

/// The texel beyond plane `b`, seen along the ray.
pub(super) fn beyond(axis: &impl AxisView, b: i64) -> i64 {
    if axis.neg() { b - 1 } else { b }
}

/// Lets the ray go on beyond the exit plane of u if `x_first`, else of v; parameter and coordinate of that plane.
pub(super) fn cross<A: AxisView>(it: &mut Iteration, setup: &Setup<A>, x_first: bool) -> (u64, i64) {
    if x_first {
        it.decision = Decision::CrossX;
        it.next_x = beyond(&setup.u, it.b_x);
        (it.t_x, it.b_x)
    } else {
        it.decision = Decision::CrossY;
        it.next_y = beyond(&setup.v, it.b_y);
        (it.t_y, it.b_y)
    }
}

/// The map repeats.
pub(super) fn wrap(x: i64, n: u32) -> u32 {
    x.rem_euclid(1 << n) as u32
}
