//! Built benches that are kept for the next run of the same text: RELIEFRTL_BUILDS names a directory for them.
//!
//! A test run builds the same benches over and over, for other vectors, traffic or faults; what is built depends on the text, the parameters and the
//! simulator alone. Without the variable nothing is kept.
use super::simulator::Simulator;
use crate::error::Result;
use crate::ir::Binding;
use std::path::{Path, PathBuf};

/// What a simulator makes of a bench.
pub(super) struct Build<'a> {
    pub sim: Simulator,
    /// Name of the program that builds.
    pub program: String,
    /// The emitted tree.
    pub tree: &'a Path,
    /// Its bench.
    pub top: &'a str,
    pub params: &'a Binding,
    /// Whatever else is asked for.
    pub more: String,
    /// The file that comes out, in the working directory.
    pub product: PathBuf,
}

impl Build<'_> {
    /// Digest of everything that the product depends on; none, if the tree can't be read.
    fn key(&self) -> Option<String> {
        let mut hash = blake3::Hasher::new();
        let mut add = |bytes: &[u8]| {
            hash.update(&(bytes.len() as u64).to_le_bytes());
            hash.update(bytes);
        };
        add(self.sim.name().as_bytes());
        add(self.program.as_bytes());
        add(self.top.as_bytes());
        add(format!("{:?} {}", self.params, self.more).as_bytes());
        let mut files = Vec::new();
        for entry in std::fs::read_dir(self.tree.join("rtl")).ok()? {
            files.push(entry.ok()?.path());
        }
        let bench = |name: String| self.tree.join("testbench").join(name);
        files
            .extend([format!("{}.v", self.top), format!("{}_top.v", self.top), "verilator_main.cpp".into()].map(bench));
        files.sort();
        for file in files.iter().filter(|f| f.is_file()) {
            add(file.file_name()?.as_encoded_bytes());
            add(&std::fs::read(file).ok()?);
        }
        Some(hash.finalize().to_hex().to_string())
    }

    /// Takes the product from the kept ones, or makes it and keeps it.
    ///
    /// # Errors
    /// Those of `make`. What can't be kept is not an error.
    pub(super) fn once(&self, make: impl FnOnce() -> Result<()>) -> Result<()> {
        let kept = std::env::var_os("RELIEFRTL_BUILDS").filter(|v| !v.is_empty()).map(PathBuf::from);
        let place = kept.and_then(|dir| Some((dir.join(self.key()?), dir)));
        let Some((place, dir)) = place else { return make() };
        if place.is_file() {
            if let Some(parent) = self.product.parent() {
                let _ = std::fs::create_dir_all(parent);
            }
            if std::fs::copy(&place, &self.product).is_ok() {
                return Ok(());
            }
        }
        make()?;
        // Under a name of its own first: another process may be doing the same.
        let keep = || {
            std::fs::create_dir_all(&dir)?;
            let own = tempfile::Builder::new().prefix(".building-").tempfile_in(&dir)?.into_temp_path();
            std::fs::copy(&self.product, &own)?;
            own.persist(&place).map_err(|e| e.error)
        };
        let _: std::io::Result<()> = keep();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::Build;
    use crate::bench::Simulator;
    use crate::ir::Binding;
    use std::path::{Path, PathBuf};

    /// Whatever the product depends on is in its key, and where it stands is not.
    #[test]
    fn a_build_is_known_by_its_text_parameters_and_simulator() {
        let tree = |text: &str| {
            let dir = tempfile::tempdir().unwrap();
            for (path, text) in [("rtl/a.v", text), ("testbench/tb_a.v", "bench"), ("testbench/other.v", text)] {
                std::fs::create_dir_all(dir.path().join(path).parent().unwrap()).unwrap();
                std::fs::write(dir.path().join(path), text).unwrap();
            }
            dir
        };
        let key = |tree: &Path, sim: Simulator, params: &Binding, more: &str| {
            let (program, more, product) = ("sim".to_string(), more.to_string(), PathBuf::new());
            Build { sim, program, tree, top: "tb_a", params, more, product }.key().unwrap()
        };
        let (one, same, other) = (tree("module a;"), tree("module a;"), tree("module a ;"));
        let none = Binding::new();
        let first = key(one.path(), Simulator::Icarus, &none, "");
        assert_eq!(first, key(same.path(), Simulator::Icarus, &none, ""));
        for different in [
            key(other.path(), Simulator::Icarus, &none, ""),
            key(one.path(), Simulator::Verilator, &none, ""),
            key(one.path(), Simulator::Icarus, &Binding::from([("W".into(), 3)]), ""),
            key(one.path(), Simulator::Icarus, &none, "-DITERATIONS"),
        ] {
            assert_ne!(first, different);
        }
    }
}
