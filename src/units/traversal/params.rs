//! Parameters that the traversal's units share.
use crate::float::FormatParams;
use reliefrtl_config::{Design, TraverseConfig, Trim};
use reliefrtl_ir::{Binding, Builder, Expr};

/// LEVELS, with the width of a level number.
pub struct LevelParams {
    /// LEVELS: log2 of the map's side.
    pub levels: Expr,
    /// Bits of a level number.
    pub level_w: Expr,
}

impl LevelParams {
    /// Declares LEVELS and what it may be.
    pub fn declare(b: &Builder, t: &TraverseConfig) -> Self {
        let levels = b.param("LEVELS", t.levels, "the map has 2^LEVELS x 2^LEVELS texels");
        b.require(2, &levels);
        b.require(&levels, 12);
        let level_w = b.local("LevelW", (&levels + 1).clog2(), "bits of a level");
        Self { levels, level_w }
    }
}

/// What the sizes of a ray may be in every floating-point datapath, so that heights, texels and tiles are exact numbers of the format and no
/// intermediate result leaves its width (`docs/datapath.md` and `docs/published.md`, Parameters).
pub fn float_sizes(b: &Builder, f: &FormatParams, levels: &Expr, height: &Expr, tile: &Expr) {
    b.require(2, height);
    b.require(height, 16);
    b.require(height, &f.man + 1);
    b.require(7, &f.man);
    b.require(1, tile);
    b.require(tile, 8);
    b.require(levels + tile + 2, 24);
    b.require(levels + tile + 1, f.bias());
    b.require(height + 2, f.bias());
}

/// The same of the watertight datapath, and what its biases need besides.
pub fn ray_conditions(b: &Builder, d: &Design, f: &FormatParams, levels: &Expr, height: &Expr, tile: &Expr) {
    float_sizes(b, f, levels, height, tile);
    b.require(&f.man, f.bias() + levels);
    if d.mode.trim != Trim::None {
        // What underflows must stay below the bias of a chord's end.
        b.require(&f.man + 4, f.bias());
    }
}

/// Declares IDX_W, the width of a signed, unwrapped texel coordinate.
pub fn index_width(b: &Builder, t: &TraverseConfig, levels: Option<&Expr>) -> Expr {
    let idx = b.param("IDX_W", t.idx_bits(), "bits of a signed, unwrapped texel coordinate");
    if let Some(l) = levels {
        b.require(l + 2, &idx);
    }
    b.require(&idx, 24);
    idx
}

/// Parameter values at which the integer units are verified besides their defaults.
pub fn bindings() -> Vec<Binding> {
    let at = |l: i64| Binding::from([("LEVELS".into(), l), ("IDX_W".into(), l + 6), ("HEIGHT_W".into(), 8)]);
    (2..=12).map(at).collect()
}
