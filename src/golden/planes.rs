//! What a datapath that compares parameters of planes computes with: the walk from node to node is the same for all of them.
use super::level::start_level;
use super::record::RayInput;
use reliefrtl_config::Design;

/// One axis of a ray, as far as the walk looks at it. Texels are unwrapped.
pub(super) trait AxisView {
    /// The ray runs toward lower indices.
    fn neg(&self) -> bool;
    /// X: texel of the entry point.
    fn entry(&self) -> i64;
    /// Xa: texel of the point where the ray meets the bottom plane, for the start level.
    fn end(&self) -> i64;
    /// Le: a texel that the ray does not get beyond.
    fn last(&self) -> i64;
}

/// The arithmetic of a datapath. Ray parameters are words that only it can read.
pub(super) trait PlaneArithmetic {
    /// One axis of a ray after setup.
    type Axis: AxisView + Copy;

    /// The design.
    fn design(&self) -> &Design;
    /// Setup of one ray.
    fn ray(&self, ray: &RayInput) -> Setup<Self::Axis>;
    /// Whether parameter `a` comes before `b`.
    fn lt(&self, a: u64, b: u64) -> bool;
    /// Where a node of that height code is met.
    fn height_time(&self, height: u32) -> u64;
    /// Where the ray meets integer plane `b`.
    fn plane_time(&self, axis: &Self::Axis, b: i64) -> u64;
    /// The texel where the ray is at `t`, or one that it has left already: never one that it has yet to reach.
    fn texel_lower_bound(&self, axis: &Self::Axis, t: u64) -> i64;
    /// The texel where the ray is at `t`, or one further on: never one that it has left already.
    fn texel_upper_bound(&self, axis: &Self::Axis, t: u64) -> i64;
    /// Where the ray is at `t`, in 2^-FRAC_W texels.
    fn position(&self, axis: &Self::Axis, t: u64) -> i64;

    /// Whether the plane of u, met at `t_x`, comes before that of v, met at `t_y`; so it does where both are met at once.
    fn x_first(&self, t_x: u64, t_y: u64) -> bool {
        !self.lt(t_y, t_x)
    }
    /// The larger of two parameters; the first when they are equal.
    fn max(&self, a: u64, b: u64) -> u64 {
        if self.lt(a, b) { b } else { a }
    }
}

/// All that setup computes for a ray. Of an invalid ray only `valid` means anything; the rest is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Setup<A> {
    /// The ray may be traced.
    pub valid: bool,
    /// Along u.
    pub u: A,
    /// Along v.
    pub v: A,
    /// The level to start on.
    pub level: u32,
    /// The finest level at which the ray may end; 0 where the design has no such choice.
    pub lod: u32,
}

/// What setup says of both axes, and the first level of the walk: start level and level of detail, where the design has them. Of a block, its
/// cells' level.
pub(super) fn both<A: AxisView>(d: &Design, lod: u32, u: A, v: A) -> Setup<A> {
    let (n, idx_w) = (d.traverse.levels, d.traverse.idx_bits());
    let level = if d.mode.start_level { start_level(n, idx_w, u.entry(), v.entry(), u.end(), v.end()) } else { n };
    let level = cells_level(d, level);
    let lod = if d.mode.lod { lod.min(d.top_level()) } else { 0 };
    Setup { valid: true, u, v, level: level.max(lod), lod }
}

/// The level of what is read where the way lies in one node of a level: that node, or the cells of the block that it is.
pub(super) fn cells_level(d: &Design, level: u32) -> u32 {
    if d.fetch.blocks() { level.saturating_sub(1) } else { level }
}

/// Texel `to`, but still in the level-k node of `x`, and never before `x`.
///
/// An estimate may lie before a plane that was crossed already. Going back there would cost steps on an axis that moves,
/// could repeat for ever when each crossing goes a level up, and on an axis that never crosses would be wrong for good.
pub(super) fn kept(axis: &impl AxisView, k: u32, x: i64, to: i64) -> i64 {
    let mask = (1i64 << k) - 1;
    if axis.neg() { to.clamp(x & !mask, x) } else { to.clamp(x, x | mask) }
}
