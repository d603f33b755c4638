//! Chord trim: the smallest node that holds the rest of the ray inside the current one (`docs/datapath.md`, "Chord trim").
use super::level::start_level;
use super::planes::{AxisView, PlaneArithmetic, Setup, cells_level, kept};
use super::record::Chord;

/// The chord from texel `(x, y)` to the exit of its level-k node, whose planes are met at `t_x` and `t_y`.
pub(super) fn chord<P: PlaneArithmetic>(
    planes: &P,
    s: &Setup<P::Axis>,
    k: u32,
    [x, y]: [i64; 2],
    [t_x, t_y]: [u64; 2],
) -> Chord {
    // x goes first on a tie.
    let x_first = planes.x_first(t_x, t_y);
    let end_x = chord_end(planes, &s.u, k, x, (!x_first).then_some(t_y));
    let end_y = chord_end(planes, &s.v, k, y, x_first.then_some(t_x));
    let size = &planes.design().traverse;
    let level = start_level(size.levels, size.idx_bits(), x, y, end_x, end_y);
    Chord { x: end_x, y: end_y, level: cells_level(planes.design(), level).max(s.lod) }
}

/// Along one axis, a texel of the level-k node of `x` that the ray does not get beyond before it leaves the node. It leaves by a plane of
/// the other axis at parameter `t`, or by this axis' own plane.
fn chord_end<P: PlaneArithmetic>(planes: &P, axis: &P::Axis, k: u32, x: i64, t: Option<u64>) -> i64 {
    let reach = t.map_or(axis.last(), |t| planes.texel_upper_bound(axis, t));
    let nearer = if axis.neg() { reach.max(axis.last()) } else { reach.min(axis.last()) };
    kept(axis, k, x, nearer)
}
