//! Modules that are not ours, measured beside ours.
use super::check_module_name;
use crate::error::{Error, Result};
use std::path::PathBuf;

/// A module that is not ours.
pub struct Foreign {
    /// Name of its module.
    pub top: String,
    /// By name, in its order.
    pub files: Vec<(String, Vec<u8>)>,
}

impl Foreign {
    /// Digest of all files and their names.
    pub fn digest(&self) -> String {
        let mut hash = blake3::Hasher::new();
        for (name, text) in &self.files {
            hash.update(format!("{name}\0{}\0", text.len()).as_bytes());
            hash.update(text);
        }
        hash.finalize().to_hex()[..32].to_string()
    }
}

/// Name and files of a module that is not ours, from `TOP=DIR`.
///
/// # Errors
/// Another text, no module name, a directory that can't be read or holds no Verilog.
pub fn foreign(asked: &str) -> Result<Foreign> {
    let Some((top, dir)) = asked.split_once('=').filter(|(_, dir)| !dir.is_empty()) else {
        return Err(Error::input(format!("--beside {asked}: write TOP=DIR, a module and the directory of its files")));
    };
    check_module_name(top).map_err(|e| Error::input(format!("--beside {asked:?}: {e}")))?;
    let read = |path: &std::path::Path, e| Error::file("read", path, e);
    let dir = std::path::Path::new(dir);
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(dir).map_err(|e| read(dir, e))? {
        let path = entry.map_err(|e| read(dir, e))?.path();
        paths.extend(path.is_file().then_some(path));
    }
    paths.sort();
    let file = |p: &PathBuf| {
        let name = p.file_name().unwrap_or_default().to_string_lossy().into_owned();
        std::fs::read(p).map(|text| (name, text)).map_err(|e| read(p, e))
    };
    let files = paths.iter().map(file).collect::<Result<Vec<_>>>()?;
    if !files.iter().any(|f| f.0.ends_with(".v") || f.0.ends_with(".sv")) {
        return Err(Error::input(format!("--beside {asked}: {} holds no .v or .sv file", dir.display())));
    }
    Ok(Foreign { top: top.to_owned(), files })
}
