//! Digests beside the vectors of a unit: what was edited since it was generated is named.
use crate::emit::Files;
use crate::error::{Error, Result};
use crate::files::{digest_inside, read_inside};
use std::collections::BTreeMap;
use std::path::Path;

/// The file that holds them: a line a file of its directory, blake3 and name, as `b3sum` writes and checks them.
const NAME: &str = "digests.txt";
/// Bytes of the longest that is read.
const MOST: u64 = 1 << 16;

/// The digests of every directory of `files`, by the paths of the files that hold them.
pub(super) fn digests(files: &Files) -> Files {
    let mut out = BTreeMap::<String, String>::new();
    for (path, text) in files {
        let (place, name) = path.rsplit_once('/').unwrap_or(("", path));
        let line = format!("{}  {name}\n", blake3::hash(text.as_bytes()).to_hex());
        *out.entry(format!("{place}/{NAME}")).or_default() += &line;
    }
    out.into_iter().collect()
}

/// What is not as it was generated in a directory of vectors and those below it, each in a sentence.
///
/// # Errors
/// If the directory can't be read.
pub(super) fn altered(place: &Path) -> Result<Vec<String>> {
    let shown = |name: &str| place.join(name).display().to_string();
    let Some(text) = read_inside(place, NAME, MOST) else {
        return Ok(vec![format!(
            "{} is not there: nothing says that its neighbours are what was generated",
            shown(NAME)
        )]);
    };
    let mut found = Vec::new();
    let mut listed = Vec::new();
    for line in text.lines() {
        let Some((digest, name)) = line.split_once("  ").filter(|(_, name)| !name.contains('/')) else {
            found.push(format!("{} was edited since it was generated", shown(NAME)));
            continue;
        };
        listed.push(name.to_owned());
        if digest_inside(place, name).as_deref() != Some(digest) {
            found.push(format!("{} was edited since it was generated (its blake3 is not that in {NAME})", shown(name)));
        }
    }
    for name in ["vectors.json", "stimulus.hex", "expected.hex", "vectors.csv", "rows.json", "memory.hex", "trace.csv"]
    {
        if !listed.iter().any(|l| l == name) && place.join(name).exists() {
            found.push(format!("{} does not stand in {NAME}", shown(name)));
        }
    }
    for entry in std::fs::read_dir(place).map_err(|e| Error::file("read", place, e))?.flatten() {
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) && entry.path().join(NAME).exists() {
            found.extend(altered(&entry.path())?);
        }
    }
    Ok(found)
}
