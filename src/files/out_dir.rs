//! A directory of generated files that appears whole or not at all.
use super::{bare, write_atomic};
use crate::error::{Error, Result};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path, PathBuf};

/// The file in an output directory that lists what was generated: one line a file, its blake3 digest and its path.
///
/// A later run removes a file only if it stands here and still has this digest.
pub const MANIFEST: &str = ".reliefrtl-files";

/// Collects generated files in a hidden directory beside the target, and puts them in place in one go.
///
/// Dropped without [`OutDir::commit`], nothing has changed.
#[derive(Debug)]
pub struct OutDir {
    target: PathBuf,
    staging: tempfile::TempDir,
    /// Relative path with `/`, and the digest of its content.
    files: BTreeMap<String, String>,
}

impl OutDir {
    /// Starts a tree for `target`, which need not exist; its parent directories are created.
    ///
    /// # Errors
    /// [`Error::File`] if the parent can't be written, [`Error::Input`] if the target is a file.
    pub fn new(target: impl AsRef<Path>) -> Result<Self> {
        let shown = target.as_ref();
        let target = std::path::absolute(shown).map_err(|error| Error::file("find", shown, error))?;
        // Through a link or `.`, the directory itself is what is meant.
        let target = fs::canonicalize(&target).unwrap_or(target);
        if target.exists() && !target.is_dir() {
            return Err(Error::input(format!("cannot write into {}: it is a file, not a directory", shown.display())));
        }
        let parent = target.parent().unwrap_or(&target);
        fs::create_dir_all(parent).map_err(|error| Error::file("create", parent, error))?;
        let mut builder = tempfile::Builder::new();
        builder.prefix(".reliefrtl-");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            builder.permissions(fs::Permissions::from_mode(0o777));
        }
        let staging = builder.tempdir_in(parent).map_err(|error| Error::file("write", parent, bare(error)))?;
        Ok(Self { target, staging, files: BTreeMap::new() })
    }

    /// Adds one file; `path` is relative to the target, with `/` between its parts. A second one of the same path replaces the first.
    ///
    /// # Errors
    /// [`Error::File`] if it can't be written, [`Error::Input`] if the path would leave the target.
    pub fn add(&mut self, path: &str, bytes: &[u8]) -> Result<()> {
        let parts: Vec<_> = Path::new(path).components().collect();
        if parts.is_empty() || !parts.iter().all(|part| matches!(part, Component::Normal(_))) || path == MANIFEST {
            return Err(Error::input(format!("{path:?} is not a place inside the output directory")));
        }
        put(&self.staging.path().join(path), bytes)?;
        self.files.insert(path.to_owned(), digest(bytes));
        Ok(())
    }

    /// Puts the tree in place, removes what an earlier run generated and this one did not, and returns the paths written.
    ///
    /// If everything in the target came from an earlier run, the directory is swapped as a whole; files of other
    /// origin stay, and then the new files are renamed into place one by one.
    ///
    /// # Errors
    /// [`Error::Input`] if a file of other origin stands where one is to go, [`Error::File`] if the system refuses.
    pub fn commit(self) -> Result<Vec<PathBuf>> {
        let manifest: String = self.files.iter().map(|(path, digest)| format!("{digest} {path}\n")).collect();
        put(&self.staging.path().join(MANIFEST), manifest.as_bytes())?;
        let written = self.files.keys().map(|path| self.target.join(path)).collect();
        if !self.target.exists() {
            fs::rename(self.staging.path(), &self.target)
                .map_err(|error| Error::file("create", &self.target, error))?;
            let _ = self.staging.keep();
            return Ok(written);
        }
        let old = read_manifest(&self.target);
        let mut present = Vec::new();
        list(&self.target, &self.target, &mut present)?;
        let mut stale = Vec::new();
        let mut foreign = false;
        for path in present.iter().filter(|path| *path != MANIFEST) {
            let content = || fs::read(self.target.join(path)).map(|bytes| digest(&bytes)).unwrap_or_default();
            match (self.files.get(path), old.get(path)) {
                (Some(_), Some(_)) => {}
                (Some(new), None) if *new == content() => {}
                (Some(_), None) => {
                    let place = self.target.join(path);
                    return Err(Error::input(format!(
                        "{} was not generated here and would be overwritten: move it away or choose another output directory",
                        place.display()
                    )));
                }
                (None, Some(digest)) if *digest == content() => stale.push(path),
                (None, _) => foreign = true,
            }
        }
        // Who stands in the directory would stay behind in the old one.
        let inside = std::env::current_dir().is_ok_and(|current| current.starts_with(&self.target));
        if foreign || inside {
            self.merge(&stale)?
        } else {
            self.swap()?
        }
        Ok(written)
    }

    fn swap(&self) -> Result<()> {
        let failed = |error| Error::file("replace", &self.target, error);
        let parent = self.target.parent().unwrap_or(&self.target);
        let old = tempfile::Builder::new().prefix(".reliefrtl-old-").tempdir_in(parent).map_err(failed)?;
        let aside = old.path().join("old");
        fs::rename(&self.target, &aside).map_err(failed)?;
        if let Err(error) = fs::rename(self.staging.path(), &self.target) {
            // Back as it was; if even that fails, the old files must at least not be cleaned away.
            if fs::rename(&aside, &self.target).is_err() {
                let _ = old.keep();
            }
            return Err(failed(error));
        }
        Ok(())
    }

    fn merge(&self, stale: &[&String]) -> Result<()> {
        for path in self.files.keys().map(String::as_str).chain([MANIFEST]) {
            let place = self.target.join(path);
            if let Some(parent) = place.parent() {
                fs::create_dir_all(parent).map_err(|error| Error::file("create", parent, error))?;
            }
            fs::rename(self.staging.path().join(path), &place).map_err(|error| Error::file("write", &place, error))?;
        }
        for path in stale {
            let place = self.target.join(path);
            fs::remove_file(&place).map_err(|error| Error::file("remove", &place, error))?;
            // A directory that this leaves empty goes too; one that is not empty refuses, and stays.
            let mut directory = place.parent();
            while let Some(empty) = directory.filter(|directory| *directory != self.target) {
                if fs::remove_dir(empty).is_err() {
                    break;
                }
                directory = empty.parent();
            }
        }
        Ok(())
    }
}

fn put(path: &Path, bytes: &[u8]) -> Result<()> {
    if let Some(parent) = path.parent() {
        fs::create_dir_all(parent).map_err(|error| Error::file("create", parent, error))?;
    }
    write_atomic(path, bytes)
}

fn digest(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

fn read_manifest(target: &Path) -> BTreeMap<String, String> {
    let text = fs::read_to_string(target.join(MANIFEST)).unwrap_or_default();
    text.lines()
        .filter_map(|line| line.split_once(' '))
        .map(|(digest, path)| (path.to_owned(), digest.to_owned()))
        .collect()
}

/// All files below `directory`, relative to `root`, with `/`.
fn list(root: &Path, directory: &Path, into: &mut Vec<String>) -> Result<()> {
    let failed = |error| Error::file("read", directory, error);
    for entry in fs::read_dir(directory).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let path = entry.path();
        if entry.file_type().map_err(failed)?.is_dir() {
            list(root, &path, into)?;
        } else if let Ok(relative) = path.strip_prefix(root) {
            let parts: Vec<_> = relative.components().map(|part| part.as_os_str().to_string_lossy()).collect();
            into.push(parts.join("/"));
        }
    }
    Ok(())
}
