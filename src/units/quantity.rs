//! What the words at the ports of units count, where several units say it.
pub use reliefrtl_ir::{BIT, BITS, FLOAT, Quantity, float, integer};

/// Coordinates of texels, signed where they are unwrapped.
pub const TEXELS: Quantity = integer("texels");
/// Levels of the pyramid, or how many there are between two.
pub const LEVELS: Quantity = integer("levels");
/// Heights, unsigned.
pub const CODES: Quantity = integer("height codes");
/// Addresses and counts of a memory's words.
pub const WORDS: Quantity = integer("words");
/// How often a ray went through the loop.
pub const ITERATIONS: Quantity = integer("iterations");
