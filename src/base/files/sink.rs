//! Where one file goes that a user names: a file, a device or FIFO, or standard output.
use super::beside::write_beside;
use super::inside::kind;
use super::staging::writing;
use super::system::{dangling, directory_of, writable};
use crate::error::{Error, Result};
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What one result is written to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sink {
    /// `-`, or what standard output is connected to (`/dev/stdout`).
    Standard,
    /// A device, a FIFO: written to as it is.
    Stream(PathBuf),
    /// A file, replaced as a whole; the place itself, where the path named is a link to it.
    File(PathBuf),
}

impl Sink {
    /// What `path` names. Nothing is opened, so that a wrong one is told before the work.
    ///
    /// # Errors
    /// One sentence: a directory, a link to nothing, a directory above it that is not there or can't be written.
    pub fn new(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        if path.as_os_str() == "-" {
            return Ok(Self::Standard);
        }
        let no = |why: &str| Error::input(format!("cannot write {}: {why}", path.display()));
        let link = fs::symlink_metadata(path).is_ok_and(|m| m.is_symlink());
        let place = match fs::metadata(path) {
            Ok(there) if there.is_dir() => {
                return Err(no(if link { "it is a link to a directory" } else { "it is a directory" }));
            }
            Ok(there) if is_standard(&there) => return Ok(Self::Standard),
            Ok(there) if kind(&there) == "a socket" => return Err(no("it is a socket")),
            Ok(there) if !there.is_file() => return Ok(Self::Stream(path.to_owned())),
            Ok(_) if link => fs::canonicalize(path).map_err(|e| Error::file("find", path, e))?,
            Err(e) if link && e.kind() == io::ErrorKind::NotFound => {
                return Err(dangling("", path, "file"));
            }
            Err(_) if link => return Err(no("it is a link that leads nowhere")),
            // A path that ends with a slash, or goes through a file.
            Err(e) if e.kind() == io::ErrorKind::NotFound => path.to_owned(),
            Err(e) if e.kind() == io::ErrorKind::NotADirectory => path.to_owned(),
            Err(e) => return Err(Error::file("write", path, e)),
            Ok(_) => path.to_owned(),
        };
        let directory = directory_of(&place);
        if !directory.is_dir() {
            return Err(no(&format!("{} is not a directory", directory.display())));
        }
        if path.as_os_str().as_encoded_bytes().ends_with(b"/") || place.file_name().is_none() {
            return Err(no("it names a directory"));
        }
        writable(directory).map_err(|e| Error::file("write", path, e))?;
        Ok(Self::File(place))
    }

    /// Writes all of it.
    ///
    /// # Errors
    /// If the system refuses; of standard output, the error names it so.
    pub fn write(&self, bytes: &[u8]) -> Result<()> {
        match self {
            Self::Standard => {
                let mut out = io::stdout().lock();
                out.write_all(bytes).and_then(|()| out.flush()).map_err(standard_failed)
            }
            // Whoever holds the other end may let us wait: no lock is held here.
            Self::Stream(path) => {
                let mut how = OpenOptions::new();
                how.write(true);
                #[cfg(unix)]
                std::os::unix::fs::OpenOptionsExt::custom_flags(&mut how, nix::libc::O_NOCTTY);
                let written = how.open(path).and_then(|mut to| to.write_all(bytes));
                written.map_err(|e| Error::file("write", path, e))
            }
            Self::File(place) => {
                // An interrupt waits, or the file beside would stay.
                let _writing = writing();
                write_beside(place, bytes)
            }
        }
    }
}

/// What errors call standard output, where a path would stand.
pub const STANDARD_OUTPUT: &str = "standard output";

/// The error of a write to standard output.
pub fn standard_failed(e: io::Error) -> Error {
    Error::file("write to", STANDARD_OUTPUT, e)
}

/// Whether this is the file that standard output goes to: replaced, it would lose what else is said there.
#[cfg(unix)]
fn is_standard(there: &fs::Metadata) -> bool {
    use std::os::fd::AsFd;
    use std::os::unix::fs::{FileTypeExt, MetadataExt};
    let kind = there.file_type();
    // The null device or a terminal may stand there twice; that is no harm.
    if !(kind.is_file() || kind.is_fifo()) {
        return false;
    }
    let own = io::stdout().as_fd().try_clone_to_owned().and_then(|fd| fs::File::from(fd).metadata());
    own.is_ok_and(|own| (own.dev(), own.ino()) == (there.dev(), there.ino()))
}

#[cfg(not(unix))]
fn is_standard(_: &fs::Metadata) -> bool {
    false
}
