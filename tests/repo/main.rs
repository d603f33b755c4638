//! The project itself: its layers, its committed tree, its guide.
mod datapaths;
mod emission;
mod glossary;
mod guide;
mod layers;
mod registers;
mod source;
mod structure;
mod unit_table;
mod units;

#[path = "../support/files.rs"]
mod files;
#[path = "../support/simulators.rs"]
mod simulators;
