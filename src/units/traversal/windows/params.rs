//! Widths of the units of a search by windows (`docs/windows.md`).
use crate::quantity::{Quantity, integer};
use crate::traversal::fixed::params::{Params, time_width};
use reliefrtl_config::{Design, Window, WindowSet};
use reliefrtl_ir::{Binding, Builder, Expr};

/// Operand bits of one multiplier.
pub const OPERAND: i64 = 18;
/// Bits of the texels up to the border of a cell of the grid: of a grid of at most 16.
pub const CELL_W: i64 = 4;
/// Bits of the texels of a window beyond this one: at most 63 + 15.
pub const SPAN_W: i64 = 7;

/// Unit of a plane's parameter before it is cut to a ray parameter.
pub const FINE: Quantity = integer("2^-GuardW of a ray parameter");
/// Unit of k.
pub const PLANES: Quantity = integer("planes");

/// The widths, declared as parameters and local constants of a unit. Which of them a unit has follows from what it asks for.
pub struct Widths<'a> {
    /// The unit.
    pub of: Params<'a>,
    /// FRACTION_W.
    pub f: Expr,
}

impl<'a> Widths<'a> {
    /// Declares FRACTION_W.
    pub fn new(b: &'a Builder, d: &'a Design) -> Self {
        let of = Params { b, d };
        let f = of.fraction();
        Self { of, f }
    }

    /// Bits of a ray parameter.
    pub fn time(&self) -> Expr {
        self.of.b.local("TimeW", time_width(&self.f), "bits of a ray parameter")
    }

    /// Declares RECIP_W, LEVELS and TILE_W, and what a plane's parameter is: all that Q and C need.
    pub fn planes(&self) -> Planes {
        let w = self.of.recip();
        let (levels, tile) = self.map();
        Planes::of(self.of.b, &self.f, &w, &levels, &tile)
    }

    /// Declares LEVELS and TILE_W.
    pub fn map(&self) -> (Expr, Expr) {
        let levels = self.of.levels(&self.f);
        let (tile, _) = self.of.reach(&self.f);
        self.of.b.require(&levels + &tile + 2, 24);
        (levels, tile)
    }
}

/// Widths of planes and of what counts them.
pub struct Planes {
    /// RECIP_W.
    pub w: Expr,
    /// LEVELS.
    pub levels: Expr,
    /// TILE_W.
    pub tile: Expr,
    /// Fraction bits of a plane's parameter beyond those of t.
    pub guard: Expr,
    /// Bits of Q and C.
    pub plane: Expr,
    /// Bits of k.
    pub count: Expr,
}

impl Planes {
    /// Declares the local constants.
    pub fn of(b: &Builder, f: &Expr, w: &Expr, levels: &Expr, tile: &Expr) -> Self {
        b.require(f + tile + w, 63);
        let guard =
            b.local("GuardW", (w + tile + levels - f - 2).larger(0), "bits of a plane parameter below those of t");
        let plane = b.local("PlaneW", f + 2 + &guard, "bits of a plane parameter");
        let count = b.local("CountW", count_width(levels, tile), "bits of a count of planes");
        Self { w: w.clone(), levels: levels.clone(), tile: tile.clone(), guard, plane, count }
    }
}

/// Bits of k, the planes that a ray has passed.
pub fn count_width(levels: &Expr, tile: &Expr) -> Expr {
    levels + tile + 1
}

/// Widths of the estimate.
pub struct Estimate {
    /// e: fraction bits of its texel.
    pub fraction: Expr,
    /// Bits of s.
    pub travel: Expr,
    /// Bits of o: one more than e, so that there always is one.
    pub offset: Expr,
    /// B: bits of the parameter that it multiplies with.
    pub time: Expr,
}

impl Estimate {
    /// Declares the local constants.
    pub fn of(b: &Builder, f: &Expr, levels: &Expr, tile: &Expr) -> Self {
        let fraction = b.local(
            "EstimateW",
            estimate_fraction(f, levels, tile),
            "fraction bits of an estimated position, in texels",
        );
        let travel = b.local("TravelW", levels + tile + &fraction, "bits of a travel per height code");
        Self {
            travel,
            offset: &fraction + 1,
            fraction,
            time: b.local(
                "FactorW",
                Expr::from(OPERAND).smaller(f + 2),
                "bits of the ray parameter that the estimate multiplies",
            ),
        }
    }
}

fn estimate_fraction(f: &Expr, levels: &Expr, tile: &Expr) -> Expr {
    (Expr::from(OPERAND) - levels - tile).larger(0).smaller(f - levels)
}

/// Parameter values at which the units are verified besides their defaults.
pub fn bindings() -> Vec<Binding> {
    crate::traversal::fixed::params::bindings()
}

/// The set as a word of letters, digits and `_`.
pub fn set_word(set: &WindowSet) -> String {
    let size = |w: &Window| format!("{}at{}", w.side, w.grid);
    set.sizes().iter().map(size).collect::<Vec<_>>().join("_")
}
