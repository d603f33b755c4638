//! What is said to the user. The macros stand for the standard library's, which end in a panic when the reader is gone or the disk is full.
use crate::error::{Error, exit};
use crate::files::standard_failed;
use std::fmt::Arguments;
use std::io::{self, ErrorKind, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

/// Whether standard output carries a result (`--out -`): what is said goes to standard error then.
static CARRIES_RESULT: AtomicBool = AtomicBool::new(false);

/// Why nothing can be said on standard output any more.
static FAILED: Mutex<Option<io::Error>> = Mutex::new(None);

/// From here on what is said goes to standard error: standard output carries a result.
pub fn keep_standard_output_free() {
    CARRIES_RESULT.store(true, Ordering::SeqCst);
}

/// Says something on standard output. If that fails (its reader has gone, the disk is full), what is said from here on is dropped and the work
/// goes on, so that files are written and verdicts found all the same; [`finish`] tells.
pub fn say(text: Arguments<'_>) {
    if CARRIES_RESULT.load(Ordering::SeqCst) {
        return tell(text);
    }
    attempt(|| io::stdout().write_fmt(text));
}

/// Writes out what is still held back.
pub fn flush() {
    attempt(|| io::stdout().flush());
}

/// Whether standard output has lost its reader.
pub fn unheard() -> bool {
    FAILED.lock().unwrap_or_else(PoisonError::into_inner).is_some()
}

fn attempt(write: impl FnOnce() -> io::Result<()>) {
    let mut failed = FAILED.lock().unwrap_or_else(PoisonError::into_inner);
    if failed.is_none() {
        *failed = write().err();
    }
}

/// Says something on standard error; without a reader it is not said.
pub fn tell(text: Arguments<'_>) {
    let _ = io::stderr().write_fmt(text);
}

/// The exit code of a run whose own is `code`, after its last word: a run that went well and could not say so did not, which `report` says.
pub fn finish(code: i32, report: impl FnOnce(&Error)) -> i32 {
    flush();
    let failed = FAILED.lock().unwrap_or_else(PoisonError::into_inner).take();
    let own = match failed {
        None => return code,
        // Whoever read it (`| head`) has seen enough: the end is quiet.
        Some(e) if e.kind() == ErrorKind::BrokenPipe => exit::READER_GONE,
        Some(e) => {
            let e = standard_failed(e);
            report(&e);
            e.exit_code()
        }
    };
    if code == exit::OK { own } else { code }
}

macro_rules! print {
    ($($text:tt)*) => { $crate::cli::print::say(format_args!($($text)*)) };
}

macro_rules! println {
    ($($text:tt)*) => { $crate::cli::print::say(format_args!("{}\n", format_args!($($text)*))) };
}

macro_rules! eprintln {
    ($($text:tt)*) => { $crate::cli::print::tell(format_args!("{}\n", format_args!($($text)*))) };
}
