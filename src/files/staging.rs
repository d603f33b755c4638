//! Directories beside a target that must not outlive the process, even one that is interrupted.
use super::bare;
use crate::error::{Error, Result};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

static LIVE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// A hidden directory that goes when it is dropped, or when the process is abandoned.
#[derive(Debug)]
pub(super) struct Staging(Option<tempfile::TempDir>);

impl Staging {
    /// A new one in `parent`.
    pub(super) fn new(parent: &Path) -> Result<Self> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(".reliefrtl-");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            builder.permissions(std::fs::Permissions::from_mode(0o777));
        }
        let mut live = live();
        let dir =
            builder.tempdir_in(parent).map_err(|error| Error::file("create a directory in", parent, bare(error)))?;
        live.insert(dir.path().to_owned());
        Ok(Self(Some(dir)))
    }

    pub(super) fn path(&self) -> &Path {
        self.0.as_ref().expect("it is there until it is dropped").path()
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        // Held until the directory is gone, or an interrupt would leave what is left of it.
        let mut live = live();
        live.remove(self.path());
        drop(self.0.take());
    }
}

/// While this is held, [`abandon`] waits: a file is being written, or a tree is on its way into its place.
pub(super) fn live() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    LIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the process, without what an unfinished run would leave behind; waits for a file that is being written and for a tree that is being put
/// into its place.
pub fn abandon(code: i32) -> ! {
    // Held to the end: nothing is written or put into its place any more.
    let live = live();
    for path in live.iter() {
        let _ = std::fs::remove_dir_all(path);
    }
    std::process::exit(code)
}
