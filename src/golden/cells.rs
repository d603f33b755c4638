//! Four siblings judged in one iteration (`docs/cells.md`): the block of level k + 1 with its cells of level k.
//!
//! A cell is named by its half of the block along each axis: the near or the far one, seen along the ray.
use super::level::{Crossing, level_after, trim_return};
use super::planes::{AxisView, PlaneArithmetic, Setup, kept};
use super::pyramid::Pyramid;
use super::record::{Decision, Iteration};
use super::state::{State, cross, exit, wrap};
use super::trim::chord;
use reliefrtl_config::{Design, LevelUp, Trim};

/// Whether four cells go with the modes of a design, if it reads them.
pub(super) fn legal(d: &Design) -> bool {
    let mode = &d.mode;
    let down = |levels: u32| (1..=3).contains(&levels);
    !d.fetch.blocks()
        || matches!(mode.level_up, LevelUp::Selective | LevelUp::Tevs)
            && mode.trim != Trim::Descent
            && down(mode.levels_down)
            && down(d.levels_down_after())
            && !mode.bilinear
}

/// The halves of a block along one axis.
#[derive(Clone, Copy, Debug)]
struct Halves {
    /// The ray is in the far half already.
    past: bool,
    /// Parameter at the middle plane.
    t_mid: u64,
    /// Parameter at the exit plane.
    t_far: u64,
    /// The texel where the ray is, or from which on it can be in the far half.
    start: [i64; 2],
}

impl Halves {
    /// Those of the blocks of level `k` + 1 at texel `x`; `t_far` belongs to a block that may be larger.
    fn of<P: PlaneArithmetic>(planes: &P, axis: &P::Axis, k: u32, x: i64, t_far: u64) -> Self {
        let mid = (x >> (k + 1) << (k + 1)) + (1 << k);
        let past = (x >= mid) != axis.neg();
        let first = if axis.neg() { mid - 1 } else { mid };
        Self { past, t_mid: planes.plane_time(axis, mid), t_far, start: [x, if past { x } else { first }] }
    }

    /// Where the ray comes into a half; `None` if it is there, or will never be there again.
    fn entry(&self, far: bool) -> Option<u64> {
        (far && !self.past).then_some(self.t_mid)
    }

    /// Where the ray leaves a half.
    fn exit(&self, far: bool) -> u64 {
        if far { self.t_far } else { self.t_mid }
    }

    /// A ray that is past the middle is not in the near half.
    fn open(&self, far: bool) -> bool {
        far || !self.past
    }
}

/// A cell as the ray meets it.
#[derive(Clone, Copy, Debug)]
struct Cell {
    /// Texels of the ray on entry, along u and v.
    start: [i64; 2],
    height: u32,
    t_v: u64,
    /// E: parameter on entry.
    enters: u64,
    /// The ray is in it for a while, and meets its height meanwhile.
    hit: bool,
}

/// A block of four cells.
struct Block<'a, P: PlaneArithmetic> {
    planes: &'a P,
    pyramid: &'a Pyramid,
    /// Level of the cells.
    level: u32,
    /// Parameter of the ray.
    t: u64,
    /// Along u and v.
    halves: [Halves; 2],
}

impl<P: PlaneArithmetic> Block<'_, P> {
    /// The cell in these halves, the far ones along u and v.
    fn cell(&self, far: [bool; 2]) -> Cell {
        let (p, [u, v]) = (self.planes, &self.halves);
        let start = [u.start[usize::from(far[0])], v.start[usize::from(far[1])]];
        let node = start.map(|x| wrap(x, self.pyramid.levels()) >> self.level);
        let height = self.pyramid.node(self.level, node[0], node[1]);
        let t_v = p.height_time(height);
        let entries = [u.entry(far[0]), v.entry(far[1])].into_iter().flatten();
        let enters = entries.fold(self.t, |t, plane| p.max(t, plane));
        let (exit_u, exit_v) = (u.exit(far[0]), v.exit(far[1]));
        let leaves = if p.lt(exit_v, exit_u) { exit_v } else { exit_u };
        let open = u.open(far[0]) && v.open(far[1]);
        Cell { start, height, t_v, enters, hit: open && p.lt(enters, leaves) && p.lt(t_v, leaves) }
    }

    /// The first cell with a hit: of those that the ray is in for a while, no two are as many halves away.
    fn first_hit(&self) -> Option<Cell> {
        let order = [[false, false], [true, false], [false, true], [true, true]];
        order.into_iter().map(|far| self.cell(far)).find(|cell| cell.hit)
    }

    /// The cell out of which the ray leaves the block; by a plane of u if `x_first`.
    fn last(&self, x_first: bool) -> Cell {
        let (p, [u, v]) = (self.planes, &self.halves);
        self.cell(if x_first {
            [true, v.past || p.lt(v.t_mid, u.t_far)]
        } else {
            // x goes first on a tie.
            [u.past || !p.lt(v.t_far, u.t_mid), true]
        })
    }
}

/// One iteration, and whether a hit in it is on a wall. `RECORD`: what no decision needs is computed too.
pub(super) fn iterate<const RECORD: bool, P: PlaneArithmetic>(
    planes: &P,
    pyramid: &Pyramid,
    setup: &Setup<P::Axis>,
    s: &State,
) -> (Iteration, bool) {
    let (d, k) = (planes.design(), s.level);
    let rule = d.mode.level_up;
    let (b_x, b_y) = (exit(&setup.u, k + 1, s.x), exit(&setup.v, k + 1, s.y));
    let (t_x, t_y) = (planes.plane_time(&setup.u, b_x), planes.plane_time(&setup.v, b_y));
    let chord = (d.mode.trim != Trim::None).then(|| chord(planes, setup, k + 1, [s.x, s.y], [t_x, t_y]));
    let r = chord.map_or(k, |c| c.level);
    let halves = [
        Halves::of(planes, &setup.u, r, s.x, t_x), //
        Halves::of(planes, &setup.v, r, s.y, t_y),
    ];
    let block = Block { planes, pyramid, level: r, t: s.t, halves };
    let x_first = planes.x_first(t_x, t_y);
    let found = block.first_hit();
    let cell = found.unwrap_or_else(|| block.last(x_first));
    let m = planes.max(cell.enters, cell.t_v);
    let ends = found.is_some() && r == setup.lod;
    let estimates = RECORD || if found.is_some() { !ends } else { rule == LevelUp::Selective };
    let (e_x, e_y) =
        if estimates { (planes.texel_lower_bound(&setup.u, m), planes.texel_lower_bound(&setup.v, m)) } else { (0, 0) };
    let [x, y] = cell.start;
    let mut it = Iteration {
        level: k,
        x: s.x,
        y: s.y,
        t: s.t,
        chord,
        height: cell.height,
        t_v: cell.t_v,
        b_x,
        b_y,
        t_x,
        t_y,
        m,
        e_x,
        e_y,
        decision: Decision::Hit,
        next_level: r,
        next_x: x,
        next_y: y,
        next_t: m,
    };
    if ends {
        return (it, planes.lt(cell.t_v, cell.enters));
    }
    if found.is_some() {
        let down = if s.crossed { d.levels_down_after() } else { d.mode.levels_down };
        it.decision = Decision::Descend;
        it.next_level = r.saturating_sub(down).max(setup.lod);
        (it.next_x, it.next_y) = (kept(&setup.u, r, x, e_x), kept(&setup.v, r, y, e_y));
        return (it, false);
    }
    let (t_e, plane) = cross(&mut it, setup, x_first);
    it.next_t = planes.max(s.t, t_e);
    it.next_level = across(d, k, r, &Crossing { level: r, plane, x, y, e_x, e_y, previous: s.prev });
    (it, false)
}

/// The level after a crossing out of the block of level `k` + 1, whose cells were read at level `r`.
fn across(d: &Design, k: u32, r: u32, c: &Crossing) -> u32 {
    // The plane bounds the block; whether it bounds the block's parent too is a level further up.
    let exits_parent = (c.plane >> (k + 1)) % 2 == 0;
    if r < k {
        // Of a trimmed block, the plane does not count: it bounds larger ones besides.
        return trim_return(d.mode.level_up, k, &Crossing { plane: 0, ..*c });
    }
    let at_parent = Crossing { plane: if exits_parent { 0 } else { 1 << c.level }, ..*c };
    level_after(&d.mode, d.top_level(), k, &at_parent)
}
