//! The entries of the table of units, a file an area. A unit's name stands as a string in its entry and at its hardware's builder, nowhere else.

/// Text of a proof's harness.
macro_rules! harness {
    ($name:literal) => {
        include_str!(concat!("../../proofs/templates/fv_", $name, ".v"))
    };
}

pub mod bilinear;
pub mod cells;
pub mod fixed;
pub mod float;
pub mod integer;
pub mod published;
pub mod stream;
pub mod traversal;
pub mod watertight;
pub mod windows;

use super::row::{Context, Row};

/// Values of W for units of any width.
const WIDTHS: &[&[(&str, i64)]] = &[&[("W", 1)], &[("W", 2)], &[("W", 3)], &[("W", 7)], &[("W", 17)], &[("W", 32)]];

/// Makes the word of a level, where the unit has the port, a level of the pyramid.
fn some_level(c: &Context<'_>, row: &mut Row<'_>, port: &str) {
    row.map(port, |k| k % (c.levels() + 1));
}

/// Swaps two coordinates that are not in order.
fn in_order(c: &Context<'_>, row: &mut Row<'_>, low: &str, high: &str) {
    let (a, b) = (row[low], row[high]);
    if c.signed(a) > c.signed(b) {
        (row[low], row[high]) = (b, a);
    }
}
