//! Floating-point units: format by Verilog parameter, latency by configuration.
mod add;
mod add3;
mod compare;
mod div;
mod div_table;
mod fields;
mod from_fixed;
pub mod general;
mod lt;
mod mul;
mod quotient;
mod recip;
mod round;
mod rows;
mod sqrt;
mod to_fixed;

pub use add::fp_add;
pub use add3::fp_add3;
pub use compare::fp_compare;
pub use div::fp_div;
pub use fields::{Fields, FormatParams};
pub use from_fixed::{fp_from_fixed, fp_from_int};
pub use lt::fp_lt;
pub use mul::fp_mul;
pub use recip::fp_recip;
pub use sqrt::fp_sqrt;
pub use to_fixed::{fp_to_fixed, fp_to_int};

use crate::ir::Binding;

/// Names of the units that more than one builder makes, or that somebody counts.
pub mod names {
    /// Sum of two.
    pub const ADD: &str = "fp_add";
    /// Product.
    pub const MUL: &str = "fp_mul";
    /// Quotient.
    pub const DIV: &str = "fp_div";
    /// Order of two.
    pub const LT: &str = "fp_lt";
}

/// Parameter values at which every floating-point module is verified besides its defaults.
pub fn bindings() -> Vec<Binding> {
    let at = |e: i64, m: i64| Binding::from([("EXP_W".into(), e), ("MAN_W".into(), m)]);
    vec![at(7, 16), at(5, 10), at(8, 23), at(4, 3), at(3, 2), at(2, 2), at(11, 28)]
}
