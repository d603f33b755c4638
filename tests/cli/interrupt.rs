//! An interrupted run leaves nothing behind: neither half a tree nor what it was made in.
#![cfg(unix)]
use std::path::Path;
use std::process::{Command, Stdio};

fn hidden(dir: &Path) -> usize {
    let entries = std::fs::read_dir(dir).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    entries.filter(|name| name.starts_with('.')).count()
}

#[test]
fn an_interrupted_build_leaves_nothing() {
    let mut caught = 0;
    // Where the files are written is a short part of a build: it is met by watching for it, and not every time.
    for _ in 0..20 {
        let dir = tempfile::tempdir().unwrap();
        let mut build = Command::new(assert_cmd::cargo::cargo_bin!("reliefrtl"))
            .args(["build", "--set", "view.stride=32", "--set", "vectors.arithmetic=4000"])
            .current_dir(dir.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        while hidden(dir.path()) == 0 && build.try_wait().unwrap().is_none() {}
        let sent = Command::new("kill").args(["-INT", &build.id().to_string()]).status();
        let ended = build.wait().unwrap();
        assert_eq!(hidden(dir.path()), 0, "{sent:?} {ended}");
        if ended.code() == Some(130) {
            caught += 1;
            let out = dir.path().join("out");
            assert!(!out.exists() || out.join("manifest.json").exists() && out.join("preview.png").exists());
        }
        if caught == 3 {
            return;
        }
    }
    panic!("caught {caught} of 20 builds, 3 are needed");
}
