//! Units of floating-point arithmetic.
use reliefrtl::catalogue::unit_entries;
use std::sync::LazyLock;

/// All that the table of units has.
pub static FLOAT_UNITS: LazyLock<Vec<&'static str>> =
    LazyLock::new(|| unit_entries().map(|u| u.name).filter(|name| name.starts_with("fp_")).collect());
