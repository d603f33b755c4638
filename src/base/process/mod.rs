//! Running the programs of others: the one place that starts any. Each stands in a process group of its own, which ends with this process,
//! however that ends.
mod group;
#[cfg(unix)]
mod watchdog;

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

pub use group::{end, stop, stopping};

/// How often a program that is busy is tried again, and how long is waited between.
const BUSY_TRIES: u32 = 100;
const BUSY_WAIT: Duration = Duration::from_millis(20);

/// Runs a program to its end, without input, and collects what it says. While [`stop`] is under way it does not return.
///
/// # Errors
/// As [`Command::spawn`]: the program is not there, say.
pub fn output(command: &mut Command) -> io::Result<Output> {
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    group::wait_if_stopping();
    let mut live = group::Live::confine(command);
    let child = spawn(command)?;
    live.runs(child.id());
    let out = child.wait_with_output();
    drop(live);
    // What a killed program said is no result: the signal's handler ends this process.
    group::wait_if_stopping();
    out
}

/// Starts a program. One that this process has just written is busy for as long as a child that another thread was starting meanwhile holds the
/// file open, which is until that child has become its own program.
fn spawn(command: &mut Command) -> io::Result<Child> {
    for _ in 0..BUSY_TRIES {
        match command.spawn() {
            Err(e) if e.kind() == io::ErrorKind::ExecutableFileBusy => std::thread::sleep(BUSY_WAIT),
            other => return other,
        }
    }
    command.spawn()
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

#[cfg(test)]
mod tests {
    /// A program is waited for while another process has it open for writing, and started then.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_busy_program_is_started_when_it_is_written() {
        use std::io::Write;
        use std::os::unix::fs::PermissionsExt;
        use std::time::Duration;
        let dir = tempfile::tempdir().unwrap();
        let program = dir.path().join("program");
        let mut file = std::fs::File::create(&program).unwrap();
        file.write_all(&std::fs::read("/bin/true").unwrap()).unwrap();
        file.set_permissions(std::fs::Permissions::from_mode(0o755)).unwrap();
        let busy = super::command(&program).spawn().map(|_| ()).unwrap_err();
        assert_eq!(busy.kind(), std::io::ErrorKind::ExecutableFileBusy);
        std::thread::scope(|s| {
            s.spawn(|| {
                std::thread::sleep(Duration::from_millis(100));
                drop(file);
            });
            assert!(super::output(&mut super::command(&program)).unwrap().status.success());
        });
    }
}
