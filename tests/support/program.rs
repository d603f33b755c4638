//! The program as a user calls it.
use std::path::Path;
use std::process::{Command, Output};

/// Runs `reliefrtl` in a directory.
pub fn run(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(args).current_dir(dir).output().unwrap()
}
