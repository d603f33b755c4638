//! What the default configuration emits: the same bytes twice, and the bytes that are committed.
//! `RELIEFRTL_REFRESH=1 cargo test --release --test repo emission` writes them anew.
use crate::files::write;
use reliefrtl::config::Config;
use reliefrtl::project::{Scene, project};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

const REFRESH: &str = "RELIEFRTL_REFRESH=1 cargo test --release --test repo emission";

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn emitted() -> reliefrtl::emit::Files {
    let c = Config::default();
    project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files
}

fn committed(dir: &Path, found: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(dir).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            committed(&path, found);
        } else {
            found.insert(path.strip_prefix(root()).unwrap().to_string_lossy().replace('\\', "/"));
        }
    }
}

#[test]
fn the_same_bytes_twice() {
    let (a, b) = (emitted(), emitted());
    assert!(a.len() > 100, "only {} files", a.len());
    assert_eq!(a, b);
}

#[test]
fn committed_files_are_what_is_emitted() {
    let files = emitted();
    if std::env::var_os("RELIEFRTL_REFRESH").is_some() {
        for dir in ["rtl", "testbench", "golden", "flow"] {
            let _ = std::fs::remove_dir_all(root().join(dir));
        }
        write(&root(), &files);
        return;
    }
    let mut found = BTreeSet::new();
    ["rtl", "testbench", "golden", "flow"].iter().for_each(|d| committed(&root().join(d), &mut found));
    let mut bad: Vec<String> = Vec::new();
    for (path, text) in &files {
        match std::fs::read_to_string(root().join(path)) {
            Ok(old) if &old == text => {}
            Ok(_) => bad.push(format!("{path} differs")),
            Err(_) => bad.push(format!("{path} is missing")),
        }
    }
    bad.extend(found.iter().filter(|f| !files.contains_key(*f)).map(|f| format!("{f} is not emitted any more")));
    assert!(bad.is_empty(), "refresh with `{REFRESH}`:\n  {}", bad.join("\n  "));
}
