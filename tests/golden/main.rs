//! The golden model: its arithmetic against oracles and against the units of arithmetic in all engines, the traversal against exact arithmetic,
//! and the parts that it is made of.
mod arithmetic;
mod bilinear;
mod border;
mod hard;
mod oracle;
mod parts;
mod traverse;

#[path = "../support/budget.rs"]
mod budget;
#[path = "../support/files.rs"]
mod files;
#[path = "../support/float_units.rs"]
mod float_units;
#[path = "../support/program.rs"]
mod program;
#[path = "../support/simulators.rs"]
mod simulators;

use std::path::Path;

/// Runs the program: exit code and both outputs.
fn run(dir: &Path, args: &[&str]) -> (i32, String, String) {
    let out = program::run(dir, args);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (out.status.code().unwrap(), text(&out.stdout), text(&out.stderr))
}
