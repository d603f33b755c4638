//! Verilog-2005 text of a module: prepared names first, then a walk that never changes the graph.
mod align;
mod apart;
mod bundle;
mod expr;
mod header;
mod instances;
mod layout;
mod prim;
mod printer;
mod registers;
mod style;
mod text;
mod widths;

pub use bundle::{delayed_bit, delayed_net};
pub use style::{SPDX, Style};
pub use text::print_module;
