//! A directory of generated files that appears whole or not at all.
use super::staging::{Staging, live};
use super::write_beside;
use crate::error::{Error, Result};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path, PathBuf};

/// The file in an output directory that lists what was generated: one line a file, its blake3 digest and its path; before them `config` and the
/// hash of the configuration, where there is one.
///
/// A later run removes or replaces a file only if it stands here and still has this digest.
pub const MANIFEST: &str = ".reliefrtl-files";

/// What a run that writes a part of a tree may do to the rest of it.
#[derive(Clone, Debug)]
pub struct Part<'a> {
    /// Hash of the configuration: what stays must come from the same.
    pub config: String,
    /// Where files of earlier runs go, even if this one doesn't write them: paths or, with `/` at the end, directories.
    pub replaces: &'a [&'a str],
    /// Where no file of an earlier run may stand that this one doesn't write.
    pub alone_in: &'a [&'a str],
}

/// Collects generated files in a hidden directory beside the target, and puts them in place in one go.
///
/// Dropped without [`OutDir::commit`], nothing has changed.
#[derive(Debug)]
pub struct OutDir {
    target: PathBuf,
    staging: Staging,
    /// Relative path with `/`, and the digest of its content.
    files: BTreeMap<String, String>,
    config: Option<String>,
    /// Where files of earlier runs go, and where none may stand; everything goes from a tree that is written whole.
    replaces: Option<Vec<String>>,
    alone_in: Vec<String>,
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
        super::make_directory(parent)?;
        let staging = Staging::new(parent)?;
        Ok(Self { target, staging, files: BTreeMap::new(), config: None, replaces: None, alone_in: Vec::new() })
    }

    /// Starts a part of the tree in `target`: what else was generated there from the same configuration stays.
    ///
    /// # Errors
    /// As [`OutDir::new`].
    pub fn part(target: impl AsRef<Path>, part: Part) -> Result<Self> {
        let own = |places: &[&str]| places.iter().map(|p| p.to_string()).collect::<Vec<_>>();
        let (replaces, alone_in) = (Some(own(part.replaces)), own(part.alone_in));
        Ok(Self { config: Some(part.config), replaces, alone_in, ..Self::new(target)? })
    }

    /// Notes the hash of the configuration that the tree comes from.
    #[must_use]
    pub fn of(mut self, config: String) -> Self {
        self.config = Some(config);
        self
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
        // An interrupt waits: a file written after the directory was cleaned away would bring it back.
        let _writing = live();
        put(&self.staging.path().join(path), bytes)?;
        self.files.insert(path.to_owned(), digest(bytes));
        Ok(())
    }

    /// Puts the tree in place, removes what an earlier run generated and this one replaces, and returns the paths written.
    ///
    /// If everything in the target came from an earlier run, the directory is swapped as a whole; files of other
    /// origin stay, and then the new files are renamed into place one by one.
    ///
    /// # Errors
    /// [`Error::Input`] if a file of other origin, or an edited one, stands where one is to go, or if what would stay does not go with what
    /// is written; [`Error::File`] if the system refuses.
    pub fn commit(self) -> Result<Vec<PathBuf>> {
        let written = self.files.keys().map(|path| self.target.join(path)).collect();
        // From here on an interrupt waits: nobody shall find a tree that is neither the old nor the new one.
        let _moving = live();
        if !self.target.exists() {
            self.write_manifest(&[])?;
            fs::rename(self.staging.path(), &self.target)
                .map_err(|error| Error::file("create", &self.target, error))?;
            return Ok(written);
        }
        let old = Listed::read(&self.target);
        let mut present = Vec::new();
        list(&self.target, &self.target, &mut present)?;
        let (mut stale, mut kept) = (Vec::new(), Vec::new());
        let mut foreign = false;
        for path in present.iter().filter(|path| *path != MANIFEST) {
            let content = fs::read(self.target.join(path)).map(|bytes| digest(&bytes)).unwrap_or_default();
            match (self.files.get(path), old.files.get(path)) {
                (Some(new), _) if *new == content => {}
                (Some(_), Some(digest)) if *digest == content => {}
                (Some(_), of) => return Err(self.in_the_way(path, of.is_some())),
                (None, Some(digest)) if *digest == content && self.may_go(path) => stale.push(path),
                (None, Some(digest)) if *digest == content => kept.push((path.as_str(), digest.as_str())),
                (None, _) => foreign = true,
            }
        }
        self.goes_with(&kept, old.config.as_deref())?;
        self.write_manifest(&kept)?;
        // Who stands in the directory would stay behind in the old one.
        let inside = std::env::current_dir().is_ok_and(|current| current.starts_with(&self.target));
        if foreign || inside || !kept.is_empty() {
            self.merge(&stale)?
        } else {
            self.swap()?
        }
        Ok(written)
    }

    fn may_go(&self, path: &str) -> bool {
        self.replaces.as_ref().is_none_or(|places| places.iter().any(|place| within(path, place)))
    }

    fn in_the_way(&self, path: &str, edited: bool) -> Error {
        let what = if edited { "was edited since it was generated" } else { "was not generated here" };
        let place = self.target.join(path);
        Error::input(format!(
            "{} {what} and would be overwritten: move it away or choose another output directory",
            place.display()
        ))
    }

    /// Whether what stays in the target goes with what is written.
    fn goes_with(&self, kept: &[(&str, &str)], config: Option<&str>) -> Result<()> {
        let place = self.target.display();
        if let Some((path, _)) = kept.iter().find(|(path, _)| self.alone_in.iter().any(|place| within(path, place))) {
            return Err(Error::input(format!(
                "{place} holds {path} of another run, which the new manifest would not list: choose another output directory"
            )));
        }
        match kept.first() {
            Some((path, _)) if config != self.config.as_deref() => Err(Error::input(format!(
                "{place} holds {path} of another configuration: choose another output directory, or `build` all of it"
            ))),
            _ => Ok(()),
        }
    }

    fn write_manifest(&self, kept: &[(&str, &str)]) -> Result<()> {
        let own = self.files.iter().map(|(path, digest)| (path.as_str(), digest.as_str()));
        let all: BTreeMap<&str, &str> = own.chain(kept.iter().copied()).collect();
        let head = self.config.iter().map(|hash| format!("config {hash}\n"));
        let text: String = head.chain(all.iter().map(|(path, digest)| format!("{digest} {path}\n"))).collect();
        put(&self.staging.path().join(MANIFEST), text.as_bytes())
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
                super::make_directory(parent)?;
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
        super::make_directory(parent)?;
    }
    write_beside(path, bytes)
}

fn digest(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

/// What a target's list says.
struct Listed {
    config: Option<String>,
    /// Digests by path.
    files: BTreeMap<String, String>,
}

impl Listed {
    fn read(target: &Path) -> Self {
        let text = fs::read_to_string(target.join(MANIFEST)).unwrap_or_default();
        let mut found = Self { config: None, files: BTreeMap::new() };
        for (digest, path) in text.lines().filter_map(|line| line.split_once(' ')) {
            if digest == "config" {
                found.config = Some(path.to_owned());
            } else {
                found.files.insert(path.to_owned(), digest.to_owned());
            }
        }
        found
    }
}

/// Whether `path` is `place`, or below it if that ends with `/`.
fn within(path: &str, place: &str) -> bool {
    path == place || place.ends_with('/') && path.starts_with(place)
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
