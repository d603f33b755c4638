//! The hardware: one file a unit, named as the unit is.
pub mod div_rows;
pub mod float;
pub mod interleave;
pub mod lzc;
pub mod traversal;
