//! Running the programs of others: the one place that starts any. Each stands in a process group of its own, which ends with this process,
//! however that ends.
mod group;
#[cfg(unix)]
mod watchdog;

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::Path;
use std::process::{Command, Output, Stdio};

pub use group::{end, stop, stopping};

/// Runs a program to its end, without input, and collects what it says. While [`stop`] is under way it does not return.
///
/// # Errors
/// As [`Command::spawn`]: the program is not there, say.
pub fn output(command: &mut Command) -> io::Result<Output> {
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    group::confine(command);
    group::wait_if_stopping();
    let child = command.spawn()?;
    let live = group::Live::new(child.id());
    let out = child.wait_with_output();
    drop(live);
    // What a killed program said is nobody's result: the signal's handler ends this process.
    group::wait_if_stopping();
    out
}

/// Whether a program starts, asked for its version.
pub fn starts(program: impl AsRef<OsStr>) -> bool {
    output(command(program).arg("--version")).is_ok()
}

/// A program as [`Command::new`] takes it from any working directory: a path with several parts is made absolute, a plain name is left for the
/// search path.
pub fn program_path(named: &OsStr) -> OsString {
    if Path::new(named).components().count() < 2 {
        return named.to_owned();
    }
    std::path::absolute(named).map_or_else(|_| named.to_owned(), Into::into)
}

/// A command of `program`, for [`output`].
pub fn command(program: impl AsRef<OsStr>) -> Command {
    Command::new(program_path(program.as_ref()))
}

/// A command of `program` that stands in `dir`, with its temporary files there, so that it meets no path but those that it is given.
pub fn command_in(dir: &Path, program: impl AsRef<OsStr>) -> Command {
    let mut command = command(program);
    command.current_dir(dir).env("TMPDIR", ".").env("TMP", ".").env("TEMP", ".").env_remove("PWD");
    command
}
