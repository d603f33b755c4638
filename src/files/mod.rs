//! Writing files so that a reader never meets half of one: beside the target first, then renamed.
mod inside;
mod listed;
mod out_dir;
mod read;
mod sink;
mod staging;
pub use inside::{digest_inside, read_inside, write_inside};
pub use listed::{Altered, MANIFEST, altered, tree_of};
pub use out_dir::{OutDir, Part};
pub use read::{
    MARK, SETTINGS, TABLE, only_files_in, open_named, read_named, read_named_text, read_of_tree, read_text_of_tree,
};
pub use sink::{STANDARD_OUTPUT, Sink, standard_failed};
pub use staging::{Scratch, abandon};

use crate::error::{Error, Result};
use std::io::Write;
use std::path::Path;

/// Writes what `path` names: a file appears whole beside its final place and is renamed, so that the old one stays until then; a device or FIFO is
/// written to; of a link, what it leads to; `-` is standard output.
///
/// # Errors
/// As [`Sink::new`] and [`Sink::write`].
pub fn write_atomic(path: impl AsRef<Path>, bytes: &[u8]) -> Result<()> {
    Sink::new(path)?.write(bytes)
}

/// A link to what is not there: neither is it replaced nor is what it names made.
fn dangling(into: &str, path: &Path, what: &str) -> Error {
    let target = std::fs::read_link(path).unwrap_or_default();
    Error::input(format!(
        "cannot write {into}{}: it is a link to {}, which is not there; links are followed and never replaced, so make that {what} or name another",
        path.display(),
        target.display()
    ))
}

/// Directory of a path.
fn directory_of(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Writes a file beside its place and renames it, for one who holds off interrupts; the permissions of one that it replaces stay.
fn write_beside(path: &Path, bytes: &[u8]) -> Result<()> {
    let directory = directory_of(path);
    let failed = |error: std::io::Error| Error::file("write", path, bare(error));
    let mut builder = tempfile::Builder::new();
    builder.prefix(staging::PREFIX).rand_bytes(staging::RANDOM);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // Temporary files are private by default; what is renamed from one must not stay so. The umask still applies.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    for _ in 0..100 {
        let mut file = builder.tempfile_in(directory).map_err(failed)?;
        // Who sweeps may meet it before it is locked.
        let Some(_lock) = staging::locked(file.path()) else { continue };
        if let Some(there) = std::fs::symlink_metadata(path).ok().filter(|m| m.is_file()) {
            file.as_file().set_permissions(there.permissions()).map_err(failed)?;
        }
        file.write_all(bytes).map_err(failed)?;
        file.persist(path).map_err(|error| failed(error.error))?;
        return Ok(());
    }
    Err(failed(std::io::ErrorKind::ResourceBusy.into()))
}

/// Makes a directory that files are written into one by one, where it is not there, removes what dead processes left there, and sees that it can be
/// written.
///
/// # Errors
/// If it is a file, a link to nothing, or can't be written.
pub fn open_directory(path: &Path) -> Result<()> {
    if !path.exists() && std::fs::symlink_metadata(path).is_ok_and(|m| m.is_symlink()) {
        return Err(dangling("into ", path, "directory"));
    }
    if path.exists() && !path.is_dir() {
        let path = path.display();
        return Err(Error::input(format!("cannot write into {path}: it is a file, not a directory")));
    }
    make_directory(path)?;
    staging::sweep(path);
    sink::writable(path).map_err(|error| Error::file("write into", path, error))
}

/// Makes a directory and those that it stands in, where they are not there.
fn make_directory(path: &Path) -> Result<()> {
    if let Some(file) = path.ancestors().find(|p| p.exists()).filter(|p| !p.is_dir()) {
        return Err(Error::input(format!("cannot create {}: {} is not a directory", path.display(), file.display())));
    }
    std::fs::create_dir_all(path).map_err(|error| Error::file("create", path, error))
}

/// What the system said, without the name of the temporary file that nobody asked for.
fn bare(error: std::io::Error) -> std::io::Error {
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
