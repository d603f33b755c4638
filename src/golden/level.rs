//! Which pyramid level to start on, to descend to, and when to go up: integers only.
use reliefrtl_config::{LevelUp, ModeConfig};

/// The lowest level, at most `n`, whose node holds both texels `(x, y)` and `(xa, ya)`.
///
/// Coordinates are signed, unwrapped texels of `idx_w` bits.
pub fn start_level(n: u32, idx_w: u32, x: i64, y: i64, xa: i64, ya: i64) -> u32 {
    // Two texels share their level-k node when their indices agree above bit k; negative ones agree within idx_w bits.
    let mask = (1i64 << idx_w) - 1;
    let same = |k: u32| (x & mask) >> k == (xa & mask) >> k && (y & mask) >> k == (ya & mask) >> k;
    (0..n).find(|&k| same(k)).unwrap_or(n)
}

/// How many levels a descent from level `k` takes: `levels_down` until the first crossing, where there are that many.
pub fn descend_levels(levels_down: u32, k: u32, crossed: bool) -> u32 {
    if !crossed && k >= levels_down { levels_down } else { 1 }
}

/// What the level-up rules look at when a ray leaves a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crossing {
    /// Level of the node that is left.
    pub level: u32,
    /// Index of the crossed plane in texels, a multiple of 2^level.
    pub plane: i64,
    /// Texel of the ray before the crossing, unwrapped.
    pub x: i64,
    /// As `x`, along v.
    pub y: i64,
    /// Texel of the predicted hit, unwrapped.
    pub e_x: i64,
    /// As `e_x`, along v.
    pub e_y: i64,
    /// The iteration before was a crossing too.
    pub previous: bool,
}

/// Whether a crossing goes one level up, wherever the root is.
pub fn level_up(rule: LevelUp, c: &Crossing) -> bool {
    // The planes of the parent's border are those of even index, in node units.
    let exits_parent = (c.plane >> c.level) % 2 == 0;
    match rule {
        LevelUp::None => false,
        LevelUp::Tevs => exits_parent,
        LevelUp::Selective => {
            let dx = (c.e_x >> c.level) - (c.x >> c.level);
            let dy = (c.e_y >> c.level) - (c.y >> c.level);
            dx.abs().max(dy.abs()) != 1 && exits_parent
        }
        LevelUp::Coherent => c.previous,
        LevelUp::Always => true,
    }
}

/// The level after a crossing out of a node of level `k`, where the root is of level `top`: the rule never goes beyond it.
pub fn level_after(mode: &ModeConfig, top: u32, k: u32, c: &Crossing) -> u32 {
    top.min(k + u32::from(level_up(mode.level_up, c)))
}

/// The level after a crossing out of a node that was trimmed from level `k` to `c.level`: back to `k`, whose plane is crossed too; but where
/// selective level-up sees the predicted hit in a neighbouring node, the trimmed level stays.
pub fn trim_return(rule: LevelUp, k: u32, c: &Crossing) -> u32 {
    if rule == LevelUp::Selective && !level_up(rule, c) { c.level } else { k }
}
