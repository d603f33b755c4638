//! What is said to the user. The macros stand for the standard library's, which end in a panic when nobody listens any more or the disk is full.
use crate::files::standard_failed;
use std::fmt::Arguments;
use std::io::{self, ErrorKind, Write};
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether standard output carries a result (`--out -`): what is said goes to standard error then.
static CARRIES_RESULT: AtomicBool = AtomicBool::new(false);

/// From here on what is said goes to standard error: standard output carries a result.
pub fn keep_standard_output_free() {
    CARRIES_RESULT.store(true, Ordering::SeqCst);
}

/// Says something on standard output. If its reader has seen enough (`| head`), the run ends quietly; if it can't be written, with a sentence.
pub fn say(text: Arguments<'_>) {
    if CARRIES_RESULT.load(Ordering::SeqCst) {
        return tell(text);
    }
    if let Err(e) = io::stdout().write_fmt(text) {
        give_up(e);
    }
}

/// Writes out what is still held back.
pub fn flush() {
    if let Err(e) = io::stdout().flush() {
        give_up(e);
    }
}

/// Says something on standard error; if nobody hears it, it is not said.
pub fn tell(text: Arguments<'_>) {
    let _ = io::stderr().write_fmt(text);
}

/// Ends the run: what it would still say has no reader.
fn give_up(e: io::Error) -> ! {
    let code = if e.kind() == ErrorKind::BrokenPipe {
        crate::error::exit::OK
    } else {
        tell(format_args!("reliefrtl: {}\n", standard_failed(e)));
        crate::error::exit::USAGE
    };
    super::interrupt::end(code)
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
