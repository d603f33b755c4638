//! The list of what was generated into an output directory.
use super::inside::{Place, digest, look, stays_inside, text as read};
use crate::error::{Error, Result};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The file in an output directory that lists what was generated: one line a file, its blake3 digest, its size in bytes and its path; before them
/// `config` and the hash of the configuration, where there is one.
///
/// A later run opens, removes or replaces a file only if it stands here, and the last two only if it still has this size and digest.
pub const MANIFEST: &str = ".reliefrtl-files";

/// Bytes of the longest list that is read: a hundred thousand files.
const MOST: u64 = 1 << 24;

/// What the list says of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    digest: String,
    /// Bytes; lists of earlier versions say none.
    size: Option<u64>,
}

impl Entry {
    /// That of a content.
    pub(super) fn of(bytes: &[u8]) -> Self {
        Self { digest: blake3::hash(bytes).to_hex().to_string(), size: Some(bytes.len() as u64) }
    }

    /// Whether a regular file is this one; one of another size is not read.
    pub(super) fn is_at(&self, path: &Path) -> bool {
        let size = self.size.or_else(|| std::fs::symlink_metadata(path).ok().map(|m| m.len()));
        size.and_then(|size| digest(path, size)).is_some_and(|there| there == self.digest)
    }
}

/// What a target's list says.
#[derive(Default)]
pub(super) struct Listed {
    pub(super) config: Option<String>,
    pub(super) files: BTreeMap<String, Entry>,
}

impl Listed {
    /// The list of `target`; an empty one, if there is none.
    ///
    /// # Errors
    /// If something else stands in its place, or it is no list.
    pub(super) fn read(target: &Path) -> Result<Self> {
        let path = target.join(MANIFEST);
        match look(target, MANIFEST) {
            Place::Free => return Ok(Self::default()),
            Place::Blocked(what, is) => return Err(super::inside::blocked(&what, is)),
            Place::File => {}
        }
        let no = || Error::input(format!("{} is not the list of a generated tree: move it away", path.display()));
        let text = read(&path, MOST).ok_or_else(no)?;
        let mut found = Self::default();
        for (digest, rest) in text.lines().filter_map(|line| line.split_once(' ')) {
            if digest == "config" {
                found.config = Some(rest.to_owned());
                continue;
            }
            let sized = rest.split_once(' ').and_then(|(size, path)| Some((Some(size.parse().ok()?), path)));
            let (size, path) = sized.unwrap_or((None, rest));
            // A path that leaves the directory is none that was written here.
            if stays_inside(path) {
                found.files.insert(path.to_owned(), Entry { digest: digest.to_owned(), size });
            }
        }
        Ok(found)
    }
}

/// Text of a list.
pub(super) fn text<'a>(config: Option<&str>, files: impl Iterator<Item = (&'a str, &'a Entry)>) -> String {
    let head = config.iter().map(|hash| format!("config {hash}\n")).collect::<String>();
    let all: BTreeMap<&str, &Entry> = files.collect();
    let line = |(path, e): (&&str, &&Entry)| match e.size {
        Some(size) => format!("{} {size} {path}\n", e.digest),
        None => format!("{} {path}\n", e.digest),
    };
    head + &all.iter().map(line).collect::<String>()
}

/// Files of a generated tree that are no longer what was generated, by their paths; of a tree without a list, none.
///
/// # Errors
/// If what stands in the list's place is none.
pub fn altered(tree: &Path) -> Result<Vec<Altered>> {
    let differs = |(path, entry): (&String, &Entry)| match look(tree, path) {
        Place::Free => Some(Altered { path: path.clone(), is: "is gone" }),
        Place::File if entry.is_at(&tree.join(path)) => None,
        Place::File => Some(Altered { path: path.clone(), is: "was edited since it was generated" }),
        Place::Blocked(..) => Some(Altered { path: path.clone(), is: "is no file any more" }),
    };
    Ok(Listed::read(tree)?.files.iter().filter_map(differs).collect())
}

/// The emitted tree that an existing file is a part of: a directory above it has it on its list, or, where the list was not copied with it,
/// has a manifest of ours beside the directory of the file.
pub fn tree_of(file: &Path) -> Option<PathBuf> {
    let place = file.canonicalize().ok()?;
    let part = |tree: &&Path| {
        let Some(path) = place.strip_prefix(tree).ok().and_then(Path::to_str) else { return false };
        match Listed::read(tree) {
            Ok(listed) if !listed.files.is_empty() => path == MANIFEST || listed.files.contains_key(path),
            _ => {
                let places = ["rtl/", "testbench/", "golden/", "flow/"];
                (path == "manifest.json" || places.iter().any(|place| path.starts_with(place)))
                    && super::read_inside(tree, "manifest.json", MOST)
                        .and_then(|text| serde_json::from_str::<serde_json::Value>(&text).ok())
                        .is_some_and(|manifest| manifest["generator"] == "reliefrtl")
            }
        }
    };
    place.ancestors().skip(1).find(part).map(Path::to_path_buf)
}

/// A file that is not what was generated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Altered {
    /// Its path in the tree, with `/`.
    pub path: String,
    /// What became of it.
    pub is: &'static str,
}
