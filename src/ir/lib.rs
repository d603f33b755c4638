//! The one description of the hardware: fixed-width operations in pipeline stages, widths over module parameters.
mod builder;
mod conditions;
mod contract;
mod expr;
mod keywords;
mod lines;
mod loops;
mod memo;
mod module;
mod names;
mod ports;
mod record;
mod schedule;
mod sig;
mod verify;

pub use builder::{Builder, Sig};
pub use conditions::hold;
pub use contract::Term;
pub use expr::{Atom, Binding, Expr, Func};
pub use keywords::{SYSTEM_VERILOG, VERILOG, is_keyword};
pub use lines::{Lines, with_lines};
pub use memo::Memo;
pub use module::*;
pub use names::Names;
pub use record::{OutputRecord, Record};
pub use schedule::plan_stages;
pub use verify::verify;
