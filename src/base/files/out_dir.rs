//! A directory of generated files that appears whole or not at all.
use super::beside::write_beside;
use super::inside::{Place, blocked, look, stays_inside};
use super::listed::{Entry, Listed, MANIFEST};
use super::staging::{Staging, writing};
use crate::error::{Error, Result};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

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
/// Dropped without [`OutDir::commit`], nothing has changed. Inside the target only files are opened that an earlier run has listed there;
/// links are not followed.
#[derive(Debug)]
pub struct OutDir {
    target: PathBuf,
    staging: Staging,
    /// Whether the target can only be filled file by file: it is a mount point, or the directory that it stands in can't be written.
    fixed: bool,
    /// By relative path with `/`.
    files: BTreeMap<String, Entry>,
    config: Option<String>,
    /// Where files of earlier runs go, and where none may stand; everything goes from a tree that is written whole.
    replaces: Option<Vec<String>>,
    alone_in: Vec<String>,
}

impl OutDir {
    /// Starts a tree for `target`, which need not exist; its parent directories are created. To be called before the work: a place that can't be
    /// written is told here.
    ///
    /// # Errors
    /// [`Error::File`] if it can't be written, [`Error::Input`] if the target is a file or a link to nothing.
    pub fn new(target: impl AsRef<Path>) -> Result<Self> {
        let shown = target.as_ref();
        let target = std::path::absolute(shown).map_err(|error| Error::file("find", shown, error))?;
        let is_link = fs::symlink_metadata(&target).is_ok_and(|m| m.is_symlink());
        // Through a link or `.`, the directory itself is what is meant.
        let target = match fs::canonicalize(&target) {
            Ok(itself) => itself,
            Err(_) if is_link => {
                return Err(super::dangling("into ", shown, "directory"));
            }
            Err(_) => target,
        };
        if target.exists() && !target.is_dir() {
            return Err(Error::input(format!("cannot write into {}: it is a file, not a directory", shown.display())));
        }
        let parent = target.parent().unwrap_or(&target).to_owned();
        super::make_directory(&parent)?;
        let (staging, fixed) = match target.is_dir() {
            false => (Staging::new(&parent, false)?, false),
            true => {
                super::system::writable(&target).map_err(|error| Error::file("write into", shown, error))?;
                super::staging::sweep(&target);
                let beside = if is_mount_point(&target) { None } else { Staging::new(&parent, false).ok() };
                match beside {
                    Some(staging) => (staging, false),
                    None => (Staging::new(&target, false)?, true),
                }
            }
        };
        Ok(Self { target, staging, fixed, files: BTreeMap::new(), config: None, replaces: None, alone_in: Vec::new() })
    }

    /// Starts a part of the tree in `target`: what else was generated there from the same configuration stays.
    ///
    /// # Errors
    /// As [`OutDir::new`].
    pub fn part(target: impl AsRef<Path>, part: Part) -> Result<Self> {
        Ok(Self::new(target)?.only(part))
    }

    /// The same, of which only a part is written: what else was generated there from the same configuration stays.
    #[must_use]
    pub fn only(self, part: Part) -> Self {
        let own = |places: &[&str]| places.iter().map(|p| p.to_string()).collect::<Vec<_>>();
        let (replaces, alone_in) = (Some(own(part.replaces)), own(part.alone_in));
        Self { config: Some(part.config), replaces, alone_in, ..self }
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
        if !stays_inside(path) || path == MANIFEST {
            return Err(Error::input(format!("{path:?} is not a place inside the output directory")));
        }
        // An interrupt waits: a file written after the directory was cleaned away would bring it back.
        let _writing = writing();
        put(&self.staging.path().join(path), bytes)?;
        self.files.insert(path.to_owned(), Entry::of(bytes));
        Ok(())
    }

    /// Puts the tree in place, removes what an earlier run generated and this one replaces, and returns the paths written.
    ///
    /// If everything in the target came from an earlier run, the directory is swapped as a whole; files of other
    /// origin stay, and then the new files are renamed into place one by one.
    ///
    /// # Errors
    /// [`Error::Input`] if a file of other origin, an edited one, a link or a FIFO stands where one is to go, or if what would stay does not go
    /// with what is written; [`Error::File`] if the system refuses.
    pub fn commit(self) -> Result<Vec<PathBuf>> {
        let written = self.files.keys().map(|path| self.target.join(path)).collect();
        // From here on an interrupt waits: no reader shall find a tree that is neither the old nor the new one.
        let _moving = writing();
        if !self.target.exists() {
            self.write_list(&[])?;
            fs::rename(self.staging.path(), &self.target)
                .map_err(|error| Error::file("create", &self.target, error))?;
            return Ok(written);
        }
        let old = Listed::read(&self.target)?;
        for path in self.files.keys() {
            match (look(&self.target, path), old.files.get(path)) {
                (Place::Free, _) => {}
                (Place::Blocked(what, is), _) => return Err(blocked(&what, is)),
                (Place::File, Some(entry)) if entry.is_at(&self.target.join(path)) => {}
                (Place::File, Some(_)) if self.files[path].is_at(&self.target.join(path)) => {}
                (Place::File, of) => return Err(self.in_the_way(path, of.is_some())),
            }
        }
        let (mut stale, mut kept) = (Vec::new(), Vec::new());
        for (path, entry) in old.files.iter().filter(|(path, _)| !self.files.contains_key(*path)) {
            let is_ours = matches!(look(&self.target, path), Place::File) && entry.is_at(&self.target.join(path));
            match (is_ours, self.may_go(path)) {
                (true, true) => stale.push(path),
                (true, false) => kept.push((path.as_str(), entry)),
                // Edited, or gone: it is no longer ours.
                (false, _) => {}
            }
        }
        self.goes_with(&kept, old.config.as_deref())?;
        self.write_list(&kept)?;
        // A process that stands in the directory would stay in the old one.
        let stands_inside = std::env::current_dir().is_ok_and(|current| current.starts_with(&self.target));
        let ours = self.files.keys().chain(stale.iter().copied()).map(String::as_str).chain([MANIFEST]);
        if self.fixed
            || stands_inside
            || !kept.is_empty()
            || holds_others(&self.target, &ours.collect())
            || !self.swap()?
        {
            self.merge(&stale)?;
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
    fn goes_with(&self, kept: &[(&str, &Entry)], config: Option<&str>) -> Result<()> {
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

    fn write_list(&self, kept: &[(&str, &Entry)]) -> Result<()> {
        let own = self.files.iter().map(|(path, entry)| (path.as_str(), entry));
        let text = super::listed::text(self.config.as_deref(), own.chain(kept.iter().copied()));
        put(&self.staging.path().join(MANIFEST), text.as_bytes())
    }

    /// Puts the new directory in the place of the old one; `false` if that can't be done here, and nothing has changed.
    fn swap(&self) -> Result<bool> {
        // In one step, where the system can: then the old one is what goes with the staging directory.
        #[cfg(all(target_os = "linux", target_env = "gnu"))]
        {
            use nix::fcntl::{AT_FDCWD, RenameFlags, renameat2};
            let (new, how) = (self.staging.path(), RenameFlags::RENAME_EXCHANGE);
            if renameat2(AT_FDCWD, new, AT_FDCWD, &self.target, how).is_ok() {
                return Ok(true);
            }
        }
        let parent = self.target.parent().unwrap_or(&self.target);
        let Ok(old) = Staging::new(parent, false) else { return Ok(false) };
        let aside = old.path().join("old");
        if fs::rename(&self.target, &aside).is_err() {
            return Ok(false);
        }
        if let Err(error) = fs::rename(self.staging.path(), &self.target) {
            // Back as it was; if even that fails, the old files must at least not be cleaned away.
            if fs::rename(&aside, &self.target).is_err() {
                old.keep();
            }
            return Err(Error::file("replace", &self.target, error));
        }
        Ok(true)
    }

    fn merge(&self, stale: &[&String]) -> Result<()> {
        for path in self.files.keys().map(String::as_str).chain([MANIFEST]) {
            let (from, place) = (self.staging.path().join(path), self.target.join(path));
            if let Some(parent) = place.parent() {
                super::make_directory(parent)?;
            }
            match fs::rename(&from, &place) {
                Err(error) if error.kind() == ErrorKind::CrossesDevices => {
                    let bytes = fs::read(&from).map_err(|error| Error::file("read", &from, error))?;
                    write_beside(&place, &bytes)?;
                }
                moved => moved.map_err(|error| Error::file("write", &place, error))?,
            }
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

/// Whether `path` is `place`, or below it if that ends with `/`.
fn within(path: &str, place: &str) -> bool {
    path == place || place.ends_with('/') && path.starts_with(place)
}

/// Whether anything stands in `target` but the files `ours` and the directories above them. Looks at names only, and at no others' directories.
fn holds_others(target: &Path, ours: &BTreeSet<&str>) -> bool {
    let above = ours.iter().flat_map(|path| path.match_indices('/').map(|(end, _)| &path[..end]));
    let above: BTreeSet<&str> = above.chain([""]).collect();
    let other = |directory: &&str| {
        let Ok(entries) = fs::read_dir(target.join(directory)) else { return false };
        entries.flatten().any(|entry| {
            let Ok(name) = entry.file_name().into_string() else { return true };
            let path = if directory.is_empty() { name } else { format!("{directory}/{name}") };
            let is_directory = entry.file_type().is_ok_and(|kind| kind.is_dir());
            !(if is_directory { above.contains(path.as_str()) } else { ours.contains(path.as_str()) })
        })
    };
    above.iter().any(other)
}

/// Whether a directory is where a file system is mounted: it can't be renamed.
#[cfg(unix)]
fn is_mount_point(directory: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let device = |path: &Path| fs::metadata(path).map(|m| m.dev()).ok();
    let Some(parent) = directory.parent() else { return true };
    // A directory that is bound to a place of its own file system has its device; Linux tells of those in a list.
    let mounts = fs::read_to_string("/proc/self/mountinfo").unwrap_or_default();
    let named = directory
        .to_str()
        .map(|d| d.replace('\\', "\\134").replace(' ', "\\040").replace('\t', "\\011").replace('\n', "\\012"));
    device(parent) != device(directory) || mounts.lines().any(|line| line.split(' ').nth(4) == named.as_deref())
}

#[cfg(not(unix))]
fn is_mount_point(_: &Path) -> bool {
    false
}
