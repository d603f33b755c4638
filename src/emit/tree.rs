//! Names in a tree that was emitted before: the prefix is the tree's, whatever the configuration at hand says.
use super::Files;
use crate::config::EmitConfig;
use crate::config::check::is_prefix;
use crate::error::{Error, Result};
use crate::files::{OutDir, read_text_of_tree};
use serde_json::Value;
use std::path::Path;

/// What the files of the tree `dir` look like, as its manifest says; `None` without a manifest, or where its prefix is no legal one.
pub fn manifest_emit(dir: &Path) -> Option<EmitConfig> {
    let text = read_text_of_tree(dir.join("manifest.json")).ok()?;
    let mut manifest: Value = serde_json::from_str(&text).ok()?;
    let emit: EmitConfig = serde_json::from_value(manifest["config"]["emit"].take()).ok()?;
    is_prefix(&emit.prefix).then_some(emit)
}

/// Name of the emitted file `<prefix><bare><end>` in `folder` of the tree `dir`, without `end`: an identifier. The manifest's prefix counts;
/// a tree without one is read by its file names.
///
/// # Errors
/// No such file, or files of several prefixes and no manifest that says which.
pub fn emitted_name(dir: &Path, folder: &str, bare: &str, end: &str) -> Result<String> {
    let place = dir.join(folder);
    let listed = std::fs::read_dir(&place).map_err(|e| Error::file("read", &place, e))?;
    let stem = |name: String| {
        let prefix = name.strip_suffix(end)?.strip_suffix(bare)?;
        is_prefix(prefix).then(|| format!("{prefix}{bare}"))
    };
    let mut found: Vec<String> =
        listed.flatten().filter_map(|e| e.file_name().into_string().ok()).filter_map(stem).collect();
    found.sort();
    if let Some(named) = manifest_emit(dir).map(|e| e.prefix + bare).filter(|n| found.contains(n)) {
        return Ok(named);
    }
    match &found[..] {
        [] => Err(Error::input(format!("{} holds no {bare}{end}, with whatever prefix", place.display()))),
        [one] => Ok(one.clone()),
        several => Err(Error::input(format!(
            "{} holds {}, and no manifest.json says which prefix is this tree's",
            place.display(),
            several.iter().map(|s| format!("{s}{end}")).collect::<Vec<_>>().join(" and ")
        ))),
    }
}

/// Writes `files` into a tree that was started: all of them, or none.
///
/// # Errors
/// If the directory can't be written, or holds what does not go with them.
pub fn fill(mut dir: OutDir, files: &Files) -> Result<()> {
    files.iter().try_for_each(|(path, text)| dir.add(path, text.as_bytes()))?;
    dir.commit().map(|_| ())
}

/// Writes `files` under `out`: all of them, or none.
///
/// # Errors
/// If the directory can't be written.
pub fn write_tree(out: &Path, files: &Files) -> Result<()> {
    fill(OutDir::new(out)?, files)
}

#[cfg(test)]
mod tests {
    use super::emitted_name;

    #[test]
    fn the_manifest_decides_between_prefixes() {
        let dir = tempfile::tempdir().unwrap();
        let bench = dir.path().join("testbench");
        std::fs::create_dir(&bench).unwrap();
        let name = || emitted_name(dir.path(), "testbench", "tb_lzc", ".v").map_err(|e| e.to_string());
        assert!(name().unwrap_err().contains("holds no tb_lzc.v"));
        // A name with a shell's words in it is no prefix.
        std::fs::write(bench.join("$(x)tb_lzc.v"), "").unwrap();
        assert!(name().unwrap_err().contains("holds no tb_lzc.v"));
        std::fs::write(bench.join("a_tb_lzc.v"), "").unwrap();
        assert_eq!(name().unwrap(), "a_tb_lzc");
        std::fs::write(bench.join("tb_lzc.v"), "").unwrap();
        assert!(name().unwrap_err().contains("holds a_tb_lzc.v and tb_lzc.v"));
        std::fs::write(dir.path().join("manifest.json"), r#"{"config": {"emit": {"prefix": "a_"}}}"#).unwrap();
        assert_eq!(name().unwrap(), "a_tb_lzc");
    }
}
