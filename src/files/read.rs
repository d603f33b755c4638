//! Reading what a user names and what stands in a tree: never more than a file of its kind may have, and of a tree regular files only, so that nothing waits
//! for whoever is at the other end of a FIFO.
use crate::error::{Error, Result};
use std::fs::{File, OpenOptions};
use std::io::{self, Read};
use std::path::Path;

/// Bytes of a configuration or a camera, at most.
pub const SETTINGS: u64 = 1 << 24;
/// Bytes of a table of rays, of figures or of cells, at most.
pub const TABLE: u64 = 1 << 30;
/// Bytes of a file of an emitted tree, at most.
const TREE: u64 = 1 << 31;

/// Bytes of what a user names, a pipe too.
///
/// # Errors
/// [`Error::File`] if it can't be read; [`Error::Input`] if it has more than `most` bytes.
pub fn read_named(path: impl AsRef<Path>, most: u64) -> Result<Vec<u8>> {
    let path = path.as_ref();
    let file = File::open(path).map_err(|e| Error::file("read", path, e))?;
    bounded(file, path, most)
}

/// The same as text.
///
/// # Errors
/// As [`read_named`]; [`Error::File`] if it is not UTF-8.
pub fn read_named_text(path: impl AsRef<Path>, most: u64) -> Result<String> {
    text(path.as_ref(), read_named(path.as_ref(), most)?)
}

/// Bytes of a regular file of a tree, or of one that a link there leads to.
///
/// # Errors
/// [`Error::File`] if it can't be read; [`Error::Input`] if it is no regular file or has more than 2 GiB.
pub fn read_of_tree(path: impl AsRef<Path>) -> Result<Vec<u8>> {
    let path = path.as_ref();
    let mut how = OpenOptions::new();
    how.read(true);
    #[cfg(unix)]
    {
        use nix::libc::{O_NOCTTY, O_NONBLOCK};
        use std::os::unix::fs::OpenOptionsExt;
        how.custom_flags(O_NONBLOCK | O_NOCTTY);
    }
    let file = how.open(path).map_err(|e| Error::file("read", path, e))?;
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
