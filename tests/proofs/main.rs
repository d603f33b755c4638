//! Proofs of the emitted units, and mutants that vectors and proofs have to notice.
mod mutants;
mod roundings;
mod stored;
mod yosys;
