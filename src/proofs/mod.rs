//! Proofs of the emitted units: harnesses and scripts for SymbiYosys, and running them.
//!
//! A proof holds for every input at the parameter values of the configuration, which no vector set can say. Integer units are proved at
//! full width against their definition; arithmetic only where a solver ends (`docs/proofs.md`).
mod flights;
mod proof;
mod run;
mod text;

pub use proof::{BIT_LEVEL, Extra, INVARIANT, PROOF, Proof, Reach, WORD_LEVEL};
pub use run::{Proved, Tools, prove};
pub use text::proof_files;
