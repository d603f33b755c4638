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
pub mod names;
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
pub use fields::{Fields, FormatParams, bindings};
pub use from_fixed::{fp_from_fixed, fp_from_int};
pub use lt::fp_lt;
pub use mul::fp_mul;
pub use recip::fp_recip;
pub use sqrt::fp_sqrt;
pub use to_fixed::{fp_to_fixed, fp_to_int};

use super::{div_rows, sqrt_rows};
use reliefrtl_config::{Design, Divider, ExtraUnit};
use reliefrtl_ir::Module;
use std::sync::Arc;

/// A unit that no traversal needs, and what it alone brings with it, leaves first.
pub fn extra(d: &Design, unit: ExtraUnit) -> Vec<Arc<Module>> {
    let (f, l) = (d.format, &d.latency);
    match unit {
        ExtraUnit::FpSqrt => vec![sqrt_rows::sqrt_rows_module(f.man + 2, f.man + 1), fp_sqrt(f, l.sqrt)],
        // Where the divider has a table, nothing else has brought the rows.
        ExtraUnit::FpRecip if l.divider == Divider::Table => {
            vec![div_rows::div_rows_module(f.man + 1, f.man + 2), fp_recip(f, l.div)]
        }
        ExtraUnit::FpRecip => vec![fp_recip(f, l.div)],
        ExtraUnit::FpCompare => vec![fp_compare(f, l.compare)],
        ExtraUnit::FpAdd3 => vec![fp_add3(f, l.add3)],
        // Of streams.
        ExtraUnit::Fifo | ExtraUnit::Arbiter => Vec::new(),
    }
}
