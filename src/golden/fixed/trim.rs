//! Chord trim in fixed point: the smallest node that holds the rest of the ray inside the current one (`docs/fixed.md`, "Chord trim").
use super::super::level::start_level;
use super::super::record::Chord;
use super::{Fixed, FixedAxis, FixedSetup};

/// What a way is lengthened by, in 2^-FRACTION_W tiles, before it bounds a texel: S falls short by less than 6 units, which a parameter makes
/// less than 7 of a length, and the length is rounded down.
const AHEAD: i128 = 8;

impl Fixed {
    /// Le: a texel that the ray does not get beyond before it meets the bottom plane.
    pub(super) fn last(&self, p: u64, a: u64, neg: bool) -> i64 {
        // A plane's parameter may be too small by one part in 2^(W-1) and by one unit, which is worth 2^TILE_W / 3 lengths at most.
        let tile = 1i128 << self.design.traverse.tile_bits;
        let way = i128::from(a) + i128::from(a >> (self.reciprocal - 1)) + tile + AHEAD;
        self.texel(i128::from(p) + if neg { -way } else { way })
    }

    /// The chord from texel `(x, y)` to the exit of its level-k node, whose planes are met at `t_x` and `t_y`.
    pub(super) fn chord(&self, s: &FixedSetup, k: u32, [x, y]: [i64; 2], [t_x, t_y]: [u64; 2]) -> Chord {
        // x goes first on a tie.
        let x_first = t_x <= t_y;
        let end_x = self.chord_end(&s.u, k, x, (!x_first).then_some(t_y));
        let end_y = self.chord_end(&s.v, k, y, x_first.then_some(t_x));
        let t = &self.design.traverse;
        Chord { x: end_x, y: end_y, level: start_level(t.levels, t.idx_bits(), x, y, end_x, end_y).max(s.lod) }
    }

    /// Along one axis, a texel of the level-k node of `x` that the ray does not get beyond before it leaves the node. It leaves by a plane of
    /// the other axis at parameter `t`, or by this axis' own plane.
    fn chord_end(&self, axis: &FixedAxis, k: u32, x: i64, t: Option<u64>) -> i64 {
        let (first, last) = (x >> k << k, x | ((1 << k) - 1));
        let reach = t.map_or(axis.le, |t| self.reach_at(axis, t));
        if axis.neg { reach.max(axis.le).clamp(first, x) } else { reach.min(axis.le).clamp(x, last) }
    }

    /// The texel where the ray is at `t`, or one further on: no plane behind that texel has a parameter of `t` or less.
    pub fn reach_at(&self, axis: &FixedAxis, t: u64) -> i64 {
        let late = t + 3 + (t >> (self.reciprocal - 1));
        let way = i128::from(self.way(axis.s, late)) + AHEAD;
        self.texel(i128::from(axis.p) + if axis.neg { -way } else { way })
    }
}
