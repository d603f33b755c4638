//! Writing files so that a reader never meets half of one: beside the target first, then renamed.
mod out_dir;
mod staging;
pub use out_dir::{MANIFEST, OutDir, Part};
pub use staging::abandon;

use crate::error::{Error, Result};
use std::io::Write;
use std::path::Path;

/// Writes a file beside its final place and renames it, so that the old file stays whole until the new one is.
///
/// # Errors
/// [`Error::File`] if the directory does not exist or can't be written, or the path is a directory.
pub fn write_atomic(path: impl AsRef<Path>, bytes: &[u8]) -> Result<()> {
    // An interrupt waits, or the file beside would stay.
    let _writing = staging::live();
    write_beside(path.as_ref(), bytes)
}

/// [`write_atomic`] for one who holds off interrupts.
fn write_beside(path: &Path, bytes: &[u8]) -> Result<()> {
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    if path.is_dir() {
        return Err(Error::input(format!("cannot write {}: it is a directory", path.display())));
    }
    if !directory.is_dir() {
        return Err(Error::input(format!(
            "cannot write {}: {} is not a directory",
            path.display(),
            directory.display()
        )));
    }
    let failed = |error: std::io::Error| Error::file("write", path, bare(error));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".reliefrtl-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // Temporary files are private by default; what is renamed from one must not stay so. The umask still applies.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(directory).map_err(failed)?;
    file.write_all(bytes).map_err(failed)?;
    file.persist(path).map_err(|error| failed(error.error))?;
    Ok(())
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
