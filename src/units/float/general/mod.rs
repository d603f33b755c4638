//! What every choice of rounding, subnormals and specials needs: operands taken apart, one rounding, and the units that
//! follow the choices where they are not those of `traverse` (`docs/arithmetic.md`).
mod add;
mod div;
mod mul;
mod operand;
mod round;

pub use super::from_fixed::fp_from_fixed_in_general as fp_from_fixed;
pub use add::fp_add;
pub use div::fp_div;
pub use mul::fp_mul;
pub use operand::{Operand, exponent_width};
pub use round::{Classes, Exact, Range, round};

use reliefrtl_ir::Sig;

/// The OR of those that are there.
pub fn any<'b>(of: &[Option<Sig<'b>>]) -> Option<Sig<'b>> {
    of.iter().flatten().copied().reduce(|a, b| a | b)
}
