//! What stands in an output directory: looked at without following links, opened only where it is a regular file.
use super::beside::write_beside;
use super::staging::writing;
use super::system::{make_directory, open};
use crate::error::{Error, Result};
use std::fs::{self, Metadata};
use std::io;
use std::path::{Component, Path, PathBuf};

/// What stands at a place inside a directory.
pub(super) enum Place {
    /// Nothing, and nothing in the way either.
    Free,
    /// A regular file.
    File,
    /// Something else there or above it, and in a word what.
    Blocked(PathBuf, &'static str),
}

/// What something is, in words.
pub(super) fn kind(there: &Metadata) -> &'static str {
    let kind = there.file_type();
    if kind.is_symlink() {
        return "a link";
    }
    if kind.is_dir() {
        return "a directory";
    }
    if kind.is_file() {
        return "a file";
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if kind.is_fifo() {
            return "a FIFO";
        }
        if kind.is_socket() {
            return "a socket";
        }
    }
    "a device"
}

/// Whether a path stays below the directory that it is relative to.
pub(super) fn stays_inside(path: &str) -> bool {
    let mut parts = Path::new(path).components().peekable();
    parts.peek().is_some() && parts.all(|part| matches!(part, Component::Normal(_)))
}

/// What stands at `path`, which [`stays_inside`], of the directory `root`.
pub(super) fn look(root: &Path, path: &str) -> Place {
    let mut place = root.to_owned();
    let mut parts = Path::new(path).components().peekable();
    while let Some(part) = parts.next() {
        place.push(part);
        let last = parts.peek().is_none();
        match fs::symlink_metadata(&place) {
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Place::Free,
            Err(_) => return Place::Blocked(place, "unreadable"),
            Ok(there) if last && there.is_file() => return Place::File,
            Ok(there) if !last && there.is_dir() => {}
            Ok(there) => return Place::Blocked(place, kind(&there)),
        }
    }
    Place::Free
}

/// Digest of a regular file of `size` bytes, in hex; `None` if it is something else, has another size or can't be read.
pub(super) fn digest(path: &Path, size: u64) -> Option<String> {
    let file = open(path).ok()?;
    let there = file.metadata().ok()?;
    if !there.is_file() || there.len() != size {
        return None;
    }
    let mut hash = blake3::Hasher::new();
    hash.update_reader(io::Read::take(file, size)).ok()?;
    Some(hash.finalize().to_hex().to_string())
}

/// Text of a regular file of at most `most` bytes; `None` if it is something else, is longer or can't be read.
pub(super) fn text(path: &Path, most: u64) -> Option<String> {
    let file = open(path).ok()?;
    let there = file.metadata().ok()?;
    let mut text = String::new();
    (there.is_file() && there.len() <= most).then_some(())?;
    io::Read::read_to_string(&mut io::Read::take(file, most), &mut text).ok()?;
    Some(text)
}

/// Text of the file `path` of the output directory `root`, if it is a regular one of at most `most` bytes and no link leads to it.
pub fn read_inside(root: &Path, path: &str, most: u64) -> Option<String> {
    match look(root, path) {
        Place::File => text(&root.join(path), most),
        Place::Free | Place::Blocked(..) => None,
    }
}

/// Digest (blake3, in hex) of the file `path` of the directory `root`, if it is a regular one and no link leads to it.
pub fn digest_inside(root: &Path, path: &str) -> Option<String> {
    let place = root.join(path);
    match look(root, path) {
        Place::File => digest(&place, fs::symlink_metadata(&place).ok()?.len()),
        Place::Free | Place::Blocked(..) => None,
    }
}

/// Writes one file of an output directory: beside its place, then renamed. Directories above it are created.
///
/// # Errors
/// [`Error::Input`] if something stands there, or above it, that is no file of this directory: a link, a FIFO.
pub fn write_inside(root: &Path, path: &str, bytes: &[u8]) -> Result<()> {
    let place = root.join(path);
    if !stays_inside(path) {
        return Err(Error::input(format!("{path:?} is not a place inside the output directory")));
    }
    if let Place::Blocked(what, is) = look(root, path) {
        return Err(blocked(&what, is));
    }
    let _writing = writing();
    if let Some(parent) = place.parent() {
        make_directory(parent)?;
    }
    write_beside(&place, bytes)
}

/// One that stands in the way.
pub(super) fn blocked(what: &Path, is: &str) -> Error {
    Error::input(format!(
        "{} is {is}, which nothing in an output directory may be that is to be written: move it away or choose another output directory",
        what.display()
    ))
}
