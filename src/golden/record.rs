//! A ray, what a traversal returns of it, and what each of the iterations did.
use super::float;
use reliefrtl_base::format::FloatFormat;

/// A ray as it enters the unit; every field is an encoded number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct RayInput {
    /// Entry point on the top plane along u, in tiles; [0, 1).
    pub u: u64,
    /// Entry point along v, in tiles; [0, 1).
    pub v: u64,
    /// Tiles travelled along u while the height falls from 1 to 0; less than 2^TILE_W either way.
    pub du: u64,
    /// As `du`, along v.
    pub dv: u64,
    /// The finest level at which the ray may end, in as many bits as LEVELS needs; above LEVELS it means LEVELS. Read only where the design's
    /// `mode.lod` is set.
    pub lod: u32,
}

impl RayInput {
    /// The ray whose fields are nearest to the given ones, at full detail.
    pub fn from_f64(fmt: FloatFormat, u: f64, v: f64, du: f64, dv: f64) -> Self {
        let [u, v, du, dv] = [u, v, du, dv].map(|x| float::from_f64(fmt, x));
        Self { u, v, du, dv, lod: 0 }
    }

    /// The ray of floating-point words that are nearest to (u, v, du, dv), in tiles. The map repeats, so the entry point is wrapped into
    /// \[0, 1), also where it rounds up to 1.
    pub(super) fn wrapped(fmt: FloatFormat, [u, v, du, dv]: [f64; 4]) -> Self {
        let one = (fmt.bias() as u64) << fmt.man;
        let wrap = |x: u64| if x == one { 0 } else { x };
        let r = Self::from_f64(fmt, u.rem_euclid(1.0), v.rem_euclid(1.0), du, dv);
        Self { u: wrap(r.u), v: wrap(r.v), ..r }
    }
}

/// What the bilinear refinement found (`docs/bilinear.md`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Patch {
    /// The ray goes from above the interpolated surface to below it within the window.
    Hit,
    /// It is still above at the window's end.
    Above,
    /// It is below at the window's begin already.
    Below,
}

impl Patch {
    /// All.
    pub const ALL: [Self; 3] = [Self::Hit, Self::Above, Self::Below];

    /// The code at the port `out_patch`; 0 is a ray that was given up.
    pub const fn code(self) -> u64 {
        self as u64 + 1
    }

    /// The word in tables.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Hit => "hit",
            Self::Above => "above",
            Self::Below => "below",
        }
    }
}

/// A refined hit. Where the patch was not hit, texel, fractions and parameter are those of the block hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BilinearHit {
    /// What was found.
    pub patch: Patch,
    /// Texel along u, 0 to 2^n - 1.
    pub i: u32,
    /// Texel along v.
    pub j: u32,
    /// Position inside the texel along u, in units of 2^-FRAC_W.
    pub fu: u32,
    /// Position inside the texel along v.
    pub fv: u32,
    /// Ray parameter in height codes, encoded.
    pub t: u64,
}

/// What the unit returns for a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RayHit {
    /// Texel along u, 0 to 2^n - 1.
    pub i: u32,
    /// Texel along v.
    pub j: u32,
    /// Position inside the texel along u, in units of 2^-FRAC_W.
    pub fu: u32,
    /// Position inside the texel along v.
    pub fv: u32,
    /// Ray parameter in height codes, encoded.
    pub t: u64,
    /// The ray met a side wall of the texel, not its top.
    pub wall: bool,
    /// No hit: the ray was invalid (then all else is 0) or was given up at the step limit.
    pub limit: bool,
    /// Iterations.
    pub steps: u32,
    /// Iterations that crossed.
    pub crossings: u32,
    /// Crossings that went a level up.
    pub ups: u32,
    /// The refined hit of a design with `mode.bilinear`; `None` of a ray that was given up.
    pub bilinear: Option<BilinearHit>,
}

/// What an iteration does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Decision {
    /// The ray ends in this texel.
    Hit,
    /// The ray meets the node's top inside: look closer.
    Descend,
    /// The ray leaves the node through a plane of constant u.
    CrossX,
    /// The ray leaves the node through a plane of constant v.
    CrossY,
}

/// The rest of a ray inside a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chord {
    /// Texel along u that the ray does not get beyond before it leaves the node.
    pub x: i64,
    /// As `x`, along v.
    pub y: i64,
    /// The lowest level at which one node holds the chord's two ends.
    pub level: u32,
}

/// Everything an iteration reads and computes. Parameters `t`.. and `m` are encoded height codes, texels are unwrapped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Iteration {
    /// Level of the node.
    pub level: u32,
    /// Texel along u.
    pub x: i64,
    /// Texel along v.
    pub y: i64,
    /// Ray parameter on entry.
    pub t: u64,
    /// The chord that a trim looked at, and the level of the node that was read instead; `None` where nothing was trimmed.
    pub chord: Option<Chord>,
    /// H: the maximum height code of the node that was read.
    pub height: u32,
    /// Parameter where the ray meets the node's top.
    pub t_v: u64,
    /// Plane of constant u by which the ray can leave, in texels.
    pub b_x: i64,
    /// As `b_x`, along v.
    pub b_y: i64,
    /// Parameter at plane `b_x`.
    pub t_x: u64,
    /// Parameter at plane `b_y`.
    pub t_y: u64,
    /// The larger of `t` and `t_v`.
    pub m: u64,
    /// Biased estimate of the texel at `m`, along u.
    pub e_x: i64,
    /// As `e_x`, along v.
    pub e_y: i64,
    /// What follows.
    pub decision: Decision,
    /// Level after the iteration.
    pub next_level: u32,
    /// Texel along u after the iteration.
    pub next_x: i64,
    /// Texel along v after the iteration.
    pub next_y: i64,
    /// Ray parameter after the iteration; of a hit, the hit's.
    pub next_t: u64,
}
