//! What every crate of reliefrtl stands on: errors, files, child processes, float formats, constants of the arithmetic.
pub mod alike;
pub mod bits;
pub mod error;
pub mod files;
pub mod format;
pub mod measured;
pub mod process;
