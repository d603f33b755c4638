//! Files and directories that must not outlive the process, even one that is interrupted or killed.
use super::system::{bare, open, writable};
use crate::error::{Error, Result};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::{Duration, Instant};

/// How the names of all of these begin; then come [`RANDOM`] letters and digits.
pub(super) const PREFIX: &str = ".reliefrtl-tmp-";
pub(super) const RANDOM: usize = 10;

/// How long [`abandon`] waits for a file that is being written.
const PATIENCE: Duration = Duration::from_secs(2);

static LIVE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
static WRITING: Mutex<()> = Mutex::new(());

/// A hidden directory that goes when it is dropped, when the process is abandoned, or else when the next run finds it: it is locked as long as
/// its process lives.
#[derive(Debug)]
pub(super) struct Staging {
    dir: Option<tempfile::TempDir>,
    _lock: Option<File>,
}

impl Staging {
    /// A new one in `parent`, from which what dead processes left is removed first.
    pub(super) fn new(parent: &Path, private: bool) -> Result<Self> {
        sweep(parent);
        let failed = |error| Error::file("create a directory in", parent, bare(error));
        // A sweep may meet a directory before it is locked; then it is gone, and another one is made.
        for _ in 0..100 {
            let mut live = live();
            let mut builder = tempfile::Builder::new();
            builder.prefix(PREFIX).rand_bytes(RANDOM);
            #[cfg(unix)]
            {
                use std::os::unix::fs::PermissionsExt;
                builder.permissions(fs::Permissions::from_mode(if private { 0o700 } else { 0o777 }));
            }
            let dir = builder.tempdir_in(parent).map_err(failed)?;
            let Some(lock) = locked(dir.path()) else { continue };
            live.insert(dir.path().to_owned());
            return Ok(Self { dir: Some(dir), _lock: lock });
        }
        Err(failed(std::io::ErrorKind::ResourceBusy.into()))
    }

    /// Leaves it where it is, for good.
    pub(super) fn keep(mut self) {
        if let Some(dir) = self.dir.take() {
            live().remove(dir.path());
            let _ = dir.keep();
        }
    }

    pub(super) fn path(&self) -> &Path {
        self.dir.as_ref().expect("it is there until it is dropped").path()
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        let Some(dir) = self.dir.take() else { return };
        let path = dir.path().to_owned();
        drop(dir);
        live().remove(&path);
    }
}

/// A private directory for the files of a run, below the system's directory for temporary files (TMPDIR). Its path is absolute.
#[derive(Debug)]
pub struct Scratch(Staging);

impl Scratch {
    /// A new one.
    ///
    /// # Errors
    /// If it can't be created.
    pub fn new() -> Result<Self> {
        let parent = std::env::temp_dir();
        let named = std::env::var_os("TMPDIR").is_some();
        let no = |why: String| {
            let (name, or) =
                if named { ("TMPDIR", " (or unset it)") } else { ("the directory for temporary files", "") };
            let right = if named { "let it" } else { "let TMPDIR" };
            Error::input(format!("{name} {why}: {right} name a directory that can be written{or}"))
        };
        if parent.as_os_str().is_empty() {
            return Err(no("is empty".into()));
        }
        let shown = parent.display();
        match fs::metadata(&parent) {
            Ok(there) if there.is_dir() => {}
            Ok(_) => return Err(no(format!("is {shown}, which is no directory"))),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => {
                return Err(no(format!("is {shown}, which is not there")));
            }
            Err(e) => return Err(no(format!("is {shown}, which can't be opened ({})", bare(e)))),
        }
        writable(&parent).map_err(|e| no(format!("is {shown}, where no file can be made ({e})")))?;
        let parent = std::path::absolute(&parent).map_err(|e| Error::file("find", parent, e))?;
        Staging::new(&parent, true).map(Self)
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        self.0.path()
    }
}

/// The lock of a new file or directory, which ends with the process; `Some(None)` where the file system has no locks, `None` if another process has
/// removed it.
pub(super) fn locked(path: &Path) -> Option<Option<File>> {
    let file = File::open(path).ok()?;
    match file.try_lock() {
        Ok(()) => path.exists().then_some(Some(file)),
        Err(fs::TryLockError::WouldBlock) => None,
        Err(fs::TryLockError::Error(_)) => Some(None),
    }
}

/// Removes from a directory what dead processes of this user left there, once a run: what bears our name and is locked by no process.
pub(super) fn sweep(directory: &Path) {
    static SWEPT: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    if !SWEPT.lock().unwrap_or_else(PoisonError::into_inner).insert(directory.to_owned()) {
        return;
    }
    let Ok(entries) = fs::read_dir(directory) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let is_ours = name.to_str().and_then(|n| n.strip_prefix(PREFIX)).is_some_and(|rest| rest.len() == RANDOM);
        if is_ours {
            remove_if_left(&entry.path());
        }
    }
}

fn remove_if_left(path: &Path) {
    let Ok(there) = fs::symlink_metadata(path) else { return };
    if !(there.is_dir() || there.is_file()) || !own(&there) {
        return;
    }
    let Ok(file) = open(path) else { return };
    // Held until it is gone.
    if file.try_lock().is_ok() {
        let _ = if there.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
    }
}

#[cfg(unix)]
fn own(there: &fs::Metadata) -> bool {
    std::os::unix::fs::MetadataExt::uid(there) == nix::unistd::geteuid().as_raw()
}

#[cfg(not(unix))]
fn own(_: &fs::Metadata) -> bool {
    true
}

fn live() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    LIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// While this is held, [`abandon`] waits for a moment: a file is being written beside its place, or a tree is on its way into its place. Never held
/// while something is written that can block.
pub(super) fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the process, without what an unfinished run would leave; waits for a file that is being written and for a tree that is being put
/// into its place, but not for long.
pub fn abandon(code: i32) -> ! {
    let start = Instant::now();
    // Held to the end: nothing is written or put into its place any more.
    let _writing = loop {
        match WRITING.try_lock() {
            Ok(held) => break Some(held),
            Err(TryLockError::Poisoned(held)) => break Some(held.into_inner()),
            Err(TryLockError::WouldBlock) if start.elapsed() > PATIENCE => break None,
            Err(TryLockError::WouldBlock) => std::thread::sleep(Duration::from_millis(2)),
        }
    };
    let live = live();
    for path in live.iter() {
        // A program that is just ending may put something there once more.
        for _ in 0..20 {
            if fs::remove_dir_all(path).is_ok() || !path.exists() {
                break;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
    }
    std::process::exit(code)
}
