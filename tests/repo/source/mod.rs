//! The crate's own source, as the tests of its structure read it.
mod graph;
mod modules;
mod tokens;

pub use graph::{Edge, circles, edges, folder};
pub use modules::{files, modules};
pub use tokens::{closing, tokens};
