//! What all that read and write files share: directories, what the system says, opening without following links.
use crate::error::{Error, Result};
use std::fs::{File, OpenOptions};
use std::io;
use std::path::Path;

/// A link to what is not there: neither is it replaced nor is what it names made.
pub(super) fn dangling(into: &str, path: &Path, what: &str) -> Error {
    let target = std::fs::read_link(path).unwrap_or_default();
    Error::input(format!(
        "cannot write {into}{}: it is a link to {}, which is not there; links are followed and never replaced, so make that {what} or name another",
        path.display(),
        target.display()
    ))
}

/// Directory of a path.
pub(super) fn directory_of(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Makes a directory and those that it stands in, where they are not there.
pub(super) fn make_directory(path: &Path) -> Result<()> {
    if let Some(file) = path.ancestors().find(|p| p.exists()).filter(|p| !p.is_dir()) {
        return Err(Error::input(format!("cannot create {}: {} is not a directory", path.display(), file.display())));
    }
    std::fs::create_dir_all(path).map_err(|error| Error::file("create", path, error))
}

/// Opens for reading what is there itself, never what a link names, without waiting for whoever is at the other end of a FIFO.
pub(super) fn open(path: &Path) -> io::Result<File> {
    let mut how = OpenOptions::new();
    how.read(true);
    #[cfg(unix)]
    {
        use nix::libc::{O_NOCTTY, O_NOFOLLOW, O_NONBLOCK};
        use std::os::unix::fs::OpenOptionsExt;
        how.custom_flags(O_NOFOLLOW | O_NONBLOCK | O_NOCTTY);
    }
    how.open(path)
}

/// Whether files can be made in a directory.
#[cfg(unix)]
pub(super) fn writable(directory: &Path) -> io::Result<()> {
    use nix::unistd::AccessFlags;
    Ok(nix::unistd::access(directory, AccessFlags::W_OK | AccessFlags::X_OK)?)
}

#[cfg(not(unix))]
pub(super) fn writable(_: &Path) -> io::Result<()> {
    Ok(())
}

/// What the system said, without the name of the temporary file that the user never named.
pub(super) fn bare(error: std::io::Error) -> std::io::Error {
    match error.raw_os_error() {
        Some(code) => std::io::Error::from_raw_os_error(code),
        None => match error
            .get_ref()
            .and_then(|inner| inner.source())
            .and_then(|source| source.downcast_ref::<std::io::Error>())
        {
            Some(source) => source.raw_os_error().map_or(error.kind().into(), std::io::Error::from_raw_os_error),
            None => error.kind().into(),
        },
    }
}
