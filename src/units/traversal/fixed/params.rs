//! Parameters and widths of the fixed-point units. What they may be: `docs/fixed.md`, Parameters.
use crate::quantity::{Quantity, integer};
use reliefrtl_config::{Design, Divider};
use reliefrtl_ir::{Binding, Builder, Expr};

/// Bits that the ray parameter has beyond FRACTION_W: its least bit is then well below what a position's least bit is worth.
pub const GUARD: i64 = 2;

/// Declares the parameters of a unit, one call each, in the order of the ports' documentation.
pub struct Params<'a> {
    /// The unit.
    pub b: &'a Builder,
    /// Gives the defaults.
    pub d: &'a Design,
}

impl Params<'_> {
    /// FRACTION_W: fraction bits of an entry point and of a travel, in tiles.
    pub fn fraction(&self) -> Expr {
        let f = self.b.param("FRACTION_W", self.d.datapath.fraction_bits, "fraction bits of positions, in tiles");
        self.b.require(8, &f);
        self.b.require(&f, 28);
        self.b.note(
            "Fixed point: positions and travels count in 2^-FRACTION_W tiles, the ray parameter in \
             2^-(FRACTION_W+2-HEIGHT_W) height codes. Everything but the reciprocal is exact or rounded down.",
        );
        f
    }

    /// RECIP_W: significant bits of the reciprocal.
    pub fn recip(&self) -> Expr {
        let w = self.b.param("RECIP_W", self.d.datapath.reciprocal_bits, "significant bits of a reciprocal");
        match self.d.latency.divider {
            Divider::Rows => {
                self.b.require(8.max(i64::from(chunks(self.d)) - 2), &w);
                self.b.require(&w, 32);
            }
            Divider::Table => {
                self.b.require(8, &w);
                self.b.require(&w, Design::TABLE_RECIP);
            }
        }
        w
    }

    /// LEVELS, at most FRACTION_W, so that a texel's corner is exact.
    pub fn levels(&self, fraction: &Expr) -> Expr {
        let n = self.b.param("LEVELS", self.d.traverse.levels, "the map has 2^LEVELS x 2^LEVELS texels");
        self.b.require(2, &n);
        self.b.require(&n, 12);
        self.b.require(&n, fraction);
        n
    }

    /// HEIGHT_W, at most FRACTION_W, so that a height code is exact.
    pub fn height(&self, fraction: &Expr) -> Expr {
        let h = self.b.param("HEIGHT_W", self.d.traverse.height_bits, "bits of a height code");
        self.b.require(2, &h);
        self.b.require(&h, 16);
        self.b.require(&h, fraction);
        h
    }

    /// TILE_W, and the bits of a travel's magnitude, FRACTION_W + TILE_W.
    pub fn reach(&self, fraction: &Expr) -> (Expr, Expr) {
        let t = self.d.traverse.tile_bits;
        let tile = self.b.param("TILE_W", t, "a ray travels less than 2^TILE_W tiles along each axis");
        reach_conditions(self.b, fraction, &tile);
        let reach = self.b.local("ReachW", fraction + &tile, "bits of a travel's magnitude");
        (tile, reach)
    }

    /// Bits of a signed, unwrapped texel coordinate.
    pub fn index(&self, levels: &Expr, tile: &Expr) -> Expr {
        self.b.require(levels + tile + 2, 24);
        self.b.local("IdxW", levels + tile + 2, "bits of a signed, unwrapped texel coordinate")
    }
}

/// Parts of the reciprocal's rows, each of which has a row at least. A search by windows has as many as its reciprocal has rows, so that none may be
/// narrower; else every legal width has them.
pub fn chunks(d: &Design) -> u32 {
    let rows = |bits: u32| bits + 2;
    let most =
        if d.datapath.kind.facts().short_loop { d.datapath.reciprocal_bits } else { d.datapath.reciprocal_bits.min(8) };
    d.latency.div.clamp(1, rows(most))
}

/// What FRACTION_W and TILE_W may be together: a travel's magnitude has at most 32 bits.
pub fn reach_conditions(b: &Builder, fraction: &Expr, tile: &Expr) {
    b.require(1, tile);
    b.require(tile, 8);
    b.require(fraction + tile, 32);
}

/// Bits of a ray parameter.
pub fn time_width(fraction: &Expr) -> Expr {
    fraction + GUARD
}

/// Bits of Z, how far a distance is moved up before it meets the reciprocal: 0 to FRACTION_W + TILE_W + 1.
pub fn shift_width(reach: &Expr) -> Expr {
    (reach + 2).clog2()
}

/// Unit of a position or travel.
pub const LENGTH: Quantity = integer("2^-FRACTION_W tiles");
/// Unit of a ray parameter.
pub const TIME: Quantity = integer("2^-(FRACTION_W+2-HEIGHT_W) height codes");

/// Parameter values at which the fixed-point units are verified besides their defaults.
pub fn bindings() -> Vec<Binding> {
    let at = |f: i64, w: i64, n: i64, h: i64, t: i64| {
        let values = [("FRACTION_W", f), ("RECIP_W", w), ("LEVELS", n), ("HEIGHT_W", h), ("TILE_W", t)];
        values.iter().map(|(k, v)| (k.to_string(), *v)).collect()
    };
    vec![at(24, 24, 8, 8, 4), at(20, 18, 12, 16, 4), at(12, 10, 12, 8, 1), at(8, 8, 8, 8, 8), at(28, 31, 2, 16, 4)]
}
