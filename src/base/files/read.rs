//! Reading what a user names and what stands in a tree: never more than a file of its kind may have, and of a tree regular files only, so that nothing waits
//! for whoever is at the other end of a FIFO.
use crate::error::{Error, Result};
use std::fs::{File, OpenOptions};
use std::io::{self, Read};
use std::path::Path;

/// What some editors put before UTF-8 text.
pub const MARK: &[u8] = b"\xef\xbb\xbf";
/// Bytes of a configuration or a camera, at most.
pub const SETTINGS: u64 = 1 << 24;
/// Bytes of a table of rays, of figures or of cells, at most.
pub const TABLE: u64 = 1 << 30;
/// Bytes of a file of an emitted tree, at most.
const TREE: u64 = 1 << 31;

/// Bytes of what a user names.
///
/// # Errors
/// As [`open_named`]; [`Error::Input`] if it has more than `most` bytes.
pub fn read_named(path: impl AsRef<Path>, most: u64) -> Result<Vec<u8>> {
    let path = path.as_ref();
    bounded(open_named(path)?, path, most)
}

/// Opens what a user names to read it: a regular file, or what this process was given open (`/dev/stdin`, `/dev/fd/N`: what a shell's `<(...)` is).
/// Any other FIFO or device would wait for whoever is at its other end.
///
/// # Errors
/// [`Error::File`] if it can't be opened; [`Error::Input`] with what it is instead.
pub fn open_named(path: &Path) -> Result<File> {
    let failed = |e| Error::file("read", path, e);
    let given = path == Path::new("/dev/stdin") || ["/dev/fd", "/proc/self/fd"].iter().any(|at| path.starts_with(at));
    let there = std::fs::metadata(path).map_err(failed)?;
    if there.is_dir() {
        return Err(Error::input(format!("cannot read {}: it is a directory, name a file", path.display())));
    }
    if given {
        return File::open(path).map_err(failed);
    }
    let no = |there: &std::fs::Metadata| {
        let is = super::inside::kind(there);
        Error::input(format!("cannot read {}: it is {is}, name a regular file, or /dev/stdin", path.display()))
    };
    if !there.is_file() {
        return Err(no(&there));
    }
    // What stands there now may be another one.
    let file = open_at_once(path).map_err(failed)?;
    let there = file.metadata().map_err(failed)?;
    if there.is_file() { Ok(file) } else { Err(no(&there)) }
}

/// Opens without waiting for whoever is at the other end of a FIFO.
fn open_at_once(path: &Path) -> io::Result<File> {
    let mut how = OpenOptions::new();
    how.read(true);
    #[cfg(unix)]
    {
        use nix::libc::{O_NOCTTY, O_NONBLOCK};
        use std::os::unix::fs::OpenOptionsExt;
        how.custom_flags(O_NONBLOCK | O_NOCTTY);
    }
    how.open(path)
}

/// The same as text, without the byte order mark that some editors put first.
///
/// # Errors
/// As [`read_named`]; [`Error::Input`] if it is not UTF-8.
pub fn read_named_text(path: impl AsRef<Path>, most: u64) -> Result<String> {
    let mut bytes = read_named(path.as_ref(), most)?;
    if bytes.starts_with(MARK) {
        bytes.drain(..MARK.len());
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let is = if error.as_bytes().starts_with(b"\xff\xfe") || error.as_bytes().starts_with(b"\xfe\xff") {
            "it looks like UTF-16".to_owned()
        } else {
            format!("the byte at offset {at} is no part of it")
        };
        Error::input(format!("{} is not UTF-8 text: {is}", path.as_ref().display()))
    })
}

/// Bytes of a regular file of a tree, or of one that a link there leads to.
///
/// # Errors
/// [`Error::File`] if it can't be read; [`Error::Input`] if it is no regular file or has more than 2 GiB.
pub fn read_of_tree(path: impl AsRef<Path>) -> Result<Vec<u8>> {
    let path = path.as_ref();
    let file = open_at_once(path).map_err(|e| Error::file("read", path, e))?;
    let there = file.metadata().map_err(|e| Error::file("read", path, e))?;
    if !there.is_file() {
        return Err(no_file(path, super::inside::kind(&there)));
    }
    bounded(file, path, TREE)
}

/// The same as text.
///
/// # Errors
/// As [`read_of_tree`]; [`Error::File`] if it is not UTF-8.
pub fn read_text_of_tree(path: impl AsRef<Path>) -> Result<String> {
    text(path.as_ref(), read_of_tree(path.as_ref())?)
}

/// Refuses a directory of a tree, which another program is about to read, that holds anything but files and directories. One that is not there
/// holds nothing.
///
/// # Errors
/// [`Error::Input`] with the first of them.
pub fn only_files_in(dir: &Path) -> Result<()> {
    let Ok(entries) = std::fs::read_dir(dir) else { return Ok(()) };
    let mut paths: Vec<_> = entries.flatten().map(|e| e.path()).collect();
    paths.sort();
    for path in paths {
        // What a link leads to; one that leads nowhere is the reader's to report.
        match std::fs::metadata(&path) {
            Ok(there) if !there.is_file() && !there.is_dir() => {
                return Err(no_file(&path, super::inside::kind(&there)));
            }
            _ => {}
        }
    }
    Ok(())
}

fn no_file(path: &Path, kind: &str) -> Error {
    Error::input(format!("{} is {kind}: in an emitted tree there are regular files", path.display()))
}

fn text(path: &Path, bytes: Vec<u8>) -> Result<String> {
    let not_text = |e| Error::file("read", path, io::Error::new(io::ErrorKind::InvalidData, e));
    String::from_utf8(bytes).map_err(not_text)
}

fn bounded(file: File, path: &Path, most: u64) -> Result<Vec<u8>> {
    let too_many =
        || Error::input(format!("{} has more than {most} bytes, the most that are read of it", path.display()));
    // A regular file says so before any of it is read.
    if file.metadata().is_ok_and(|m| m.is_file() && m.len() > most) {
        return Err(too_many());
    }
    let mut bytes = Vec::new();
    file.take(most + 1).read_to_end(&mut bytes).map_err(|e| Error::file("read", path, e))?;
    if bytes.len() as u64 > most { Err(too_many()) } else { Ok(bytes) }
}
