//! What is read has a bound, and nothing in a tree is waited for.
#![cfg(unix)]
use super::SMALL;
use std::path::Path;
use std::process::{Command, Output};

/// Runs a line of the program with 4 GB of memory and ten seconds of a processor.
fn bounded(dir: &Path, line: &str) -> Output {
    let shell = format!("ulimit -v 4000000; ulimit -t 10; exec \"$RELIEFRTL\" {line}");
    let mut c = Command::new("sh");
    c.args(["-c", &shell]).env("RELIEFRTL", env!("CARGO_BIN_EXE_reliefrtl")).current_dir(dir).output().unwrap()
}

fn refused(dir: &Path, line: &str, words: &[&str]) {
    let out = bounded(dir, line);
    let said = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(2), "{line}: {said}");
    assert!(words.iter().all(|w| said.contains(w)), "{line}: {said}");
    assert!(!said.contains("out of memory"), "{line}: {said}");
}

#[test]
fn endless_files_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    std::os::unix::fs::symlink("/dev/zero", dir.path().join("z.toml")).unwrap();
    let sparse = std::fs::File::create(dir.path().join("sparse.csv")).unwrap();
    sparse.set_len(6 << 30).unwrap();
    let most = |bytes: u64| format!("has more than {bytes} bytes, the most that are read of it");
    let (table, settings) = (most(1 << 30), most(1 << 24));
    let device = "it is a device, name a regular file";
    for (line, words) in [
        ("trace --rays /dev/zero --out -", ["/dev/zero", device]),
        ("trace --rays /dev/stdin --out - < /dev/zero", ["/dev/stdin", &table]),
        ("trace --rays sparse.csv --out -", ["sparse.csv", &table]),
        ("config --print --config /dev/stdin < /dev/zero", ["/dev/stdin", &settings]),
        ("config --print --config z.toml", ["z.toml", device]),
        ("render --view z.toml --out v.png", ["z.toml", device]),
    ] {
        refused(dir.path(), line, &words);
    }
}

/// Each kind of file that `check` reads of a tree, as a FIFO and as a device.
#[test]
fn a_tree_has_regular_files() {
    let dir = tempfile::tempdir().unwrap();
    assert_eq!(super::run(dir.path(), &[&["build", "--out", "o"][..], &SMALL].concat()).status.code(), Some(0));
    let engines: Vec<&str> = super::engines().into_iter().filter(|e| *e != "golden").collect();
    for file in ["golden/fp_lt/stimulus.hex", "golden/fp_lt/vectors.json", "rtl/relief_fp_lt.v", "manifest.json"] {
        let place = dir.path().join("o").join(file);
        let kept = std::fs::read(&place).unwrap();
        for (kind, sentence) in [("mkfifo", "is a FIFO"), ("ln -s /dev/zero", "is a device")] {
            std::fs::remove_file(&place).unwrap();
            let make = Command::new("sh").arg("-c").arg(format!("{kind} \"$PLACE\"")).env("PLACE", &place).status();
            assert!(make.unwrap().success());
            for engine in &engines {
                let line = format!("check --dir o --unit fp_lt --engine {engine} {}", SMALL.join(" "));
                refused(dir.path(), &line, &[file, sentence, "in an emitted tree there are regular files"]);
            }
        }
        std::fs::remove_file(&place).unwrap();
        std::fs::write(&place, kept).unwrap();
    }
}

#[test]
fn two_outputs_are_two_files() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.csv"), "u,v,du,dv\n0.1,0.2,0.5,0.25\n").unwrap();
    let line = "trace --rays r.csv --set traverse.levels=4 --out same.vcd --wave ./same.vcd";
    refused(dir.path(), line, &["--out and --wave both name ./same.vcd: give each a file"]);
    assert!(!dir.path().join("same.vcd").exists());
}
