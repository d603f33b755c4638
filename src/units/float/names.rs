//! Names of the units that more than one builder makes, or that are counted.

/// Sum of two.
pub const ADD: &str = "fp_add";
/// Product.
pub const MUL: &str = "fp_mul";
/// Quotient.
pub const DIV: &str = "fp_div";
/// Order of two.
pub const LT: &str = "fp_lt";
