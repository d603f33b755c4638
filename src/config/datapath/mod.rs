//! The datapaths: what each of them has, reads and promises, in one table. Its arithmetic stands in `golden`, its hardware in `units`.
mod by_windows;
mod facts;
mod fixed;
mod float;
mod kind;
mod published;
mod pyramid;
mod table;
mod watertight;
mod windows;
mod written;

pub use facts::{DatapathFacts, Reads};
pub use kind::{DatapathConfig, DatapathKind, Search};
pub use table::{datapaths, searches};
