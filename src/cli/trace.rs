//! `reliefrtl trace`.
use super::args::{Cli, TraceArgs};
use crate::error::Result;

/// Runs `trace`.
pub fn run(_cli: &Cli, _a: &TraceArgs) -> Result<()> {
    unreachable!("wired with the scene")
}
