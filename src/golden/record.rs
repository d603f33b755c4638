//! What a traversal returns, and what each of its iterations did.

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
