//! Proofs of the emitted units, and mutants that vectors and proofs have to notice.
mod mutants;
mod roundings;
mod stored;
mod streams;
mod yosys;

#[path = "../support/budget.rs"]
mod budget;
#[path = "../support/files.rs"]
mod files;
#[path = "../support/float_units.rs"]
mod float_units;
#[path = "../support/simulators.rs"]
mod simulators;
