//! What `reciprocal` shows to the outside, the same whether rows or a table divide.
use super::params::{LENGTH, Params, shift_width};
use crate::quantity::{BITS, integer};
use reliefrtl_config::{Design, Divider};
use reliefrtl_ir::{Builder, Expr, Sig};

/// Starts the module.
pub fn builder(source: &str, divider: Divider) -> Builder {
    let b = Builder::new("reciprocal", source, "slope of a ray's parameter along an axis: a reciprocal and a shift");
    b.choice("divider", divider.word());
    b
}

/// Parameters and ports, the same whatever the divider.
pub struct Ports<'b> {
    /// RECIP_W.
    pub w: Expr,
    /// HEIGHT_W.
    pub h: Expr,
    /// Bits of a travel's magnitude.
    pub reach: Expr,
    /// Bits of the shift.
    pub shift_w: Expr,
    /// The travel.
    pub a: Sig<'b>,
    /// The reciprocal.
    pub o_r: usize,
    /// The shift.
    pub o_z: usize,
}

impl<'b> Ports<'b> {
    /// Declares them; `locals` are further derived constants, of RECIP_W.
    pub fn declare(b: &'b Builder, d: &Design, locals: impl FnOnce(&Expr)) -> Self {
        let of = Params { b, d };
        let f = of.fraction();
        let w = of.recip();
        let h = of.height(&f);
        let (_, reach) = of.reach(&f);
        let shift_w = b.local("ShiftW", shift_width(&reach), "bits of a shift");
        locals(&w);
        b.clock();
        b.clock_enable();
        let a = b.input("a", &reach, LENGTH, "travel, its magnitude");
        let o_r = b.output("r", &w, integer("a number of RECIP_W bits"), "M / a without its power of two; 0 if a is");
        let o_z = b.output("z", &shift_w, BITS, "that power: how far a distance is moved up before its product with r");
        Self { w, h, reach, shift_w, a, o_r, o_z }
    }
}
