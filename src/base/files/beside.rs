//! A file that appears whole: beside its place first, then renamed.
use super::staging::{PREFIX, RANDOM, locked};
use super::system::{bare, directory_of};
use crate::error::{Error, Result};
use std::io::Write;
use std::path::Path;

/// Writes a file beside its place and renames it, for a caller that holds off interrupts; the permissions of one that it replaces stay.
pub(super) fn write_beside(path: &Path, bytes: &[u8]) -> Result<()> {
    let directory = directory_of(path);
    let failed = |error: std::io::Error| Error::file("write", path, bare(error));
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).rand_bytes(RANDOM);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // Temporary files are private by default; what is renamed from one must not stay so. The umask still applies.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    for _ in 0..100 {
        let mut file = builder.tempfile_in(directory).map_err(failed)?;
        // A sweep may meet it before it is locked.
        let Some(_lock) = locked(file.path()) else { continue };
        if let Some(there) = std::fs::symlink_metadata(path).ok().filter(|m| m.is_file()) {
            file.as_file().set_permissions(there.permissions()).map_err(failed)?;
        }
        file.write_all(bytes).map_err(failed)?;
        file.persist(path).map_err(|error| failed(error.error))?;
        return Ok(());
    }
    Err(failed(std::io::ErrorKind::ResourceBusy.into()))
}
