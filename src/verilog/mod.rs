//! Verilog-2005 text of a module: prepared names first, then a walk that never changes the graph.
mod align;
mod bundle;
mod expr;
mod header;
mod layout;
mod prim;
mod style;
mod text;

pub use bundle::delayed_bit;
pub use style::{SPDX, Style};
pub use text::print_module;
