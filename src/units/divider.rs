//! The core of the divider.
use super::{div_rows, recip_table};
use reliefrtl_config::{Design, Divider};
use reliefrtl_ir::Module;
use std::sync::Arc;

/// What `fp_div` stands on besides its own text.
pub(super) fn divider_core(d: &Design) -> Arc<Module> {
    match d.latency.divider {
        Divider::Rows => div_rows::div_rows_module(d.format.man + 1, d.format.man + 3),
        Divider::Table => recip_table::recip_table_module(),
    }
}
