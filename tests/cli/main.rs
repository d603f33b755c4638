//! The command line as a user meets it: sentences, exit codes, nothing half-written, equal bytes from the engines. A file a verb.
mod bench;
mod bounds;
mod build;
mod cells;
mod check;
mod clocks;
mod config;
mod counters;
mod emit;
mod files;
mod input;
mod interrupt;
mod levels;
mod names;
mod outputs;
mod scene;
mod steps;
mod trace;
mod vectors;
mod views;
mod windows;

#[path = "../support/budget.rs"]
mod budget;
#[path = "../support/program.rs"]
mod program;
#[path = "../support/simulators.rs"]
mod simulators;

use program::run;
use simulators::skip;
use std::path::Path;

const SMALL: [&str; 8] = [
    "--set",
    "vectors.arithmetic=100",
    "--set",
    "vectors.rays=20",
    "--set",
    "vectors.planned=false",
    "--set",
    "view.stride=16",
];

/// Runs and returns exit code and both outputs.
fn said(dir: &Path, args: &[&str]) -> (Option<i32>, String) {
    let out = run(dir, args);
    (out.status.code(), String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr))
}

/// The engines that are there.
fn engines() -> Vec<&'static str> {
    let mut engines = vec!["golden", "interp"];
    if !skip() {
        engines.extend(["icarus", "verilator"]);
    }
    engines
}

/// Runs in a directory with a few broken files: refused with this sentence, and nothing is left.
fn refused(args: &[&str], sentence: &str) {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("broken.png"), b"\x89PNG\r\n\x1a\nnot a png").unwrap();
    std::fs::write(dir.path().join("miss.csv"), "u,v,du\n0,0,0\n").unwrap();
    std::fs::write(dir.path().join("let.csv"), "u,v,du,dv\n0,x,0,0\n").unwrap();
    let out = run(dir.path(), args);
    let text = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(2), "{args:?}: {text}");
    assert!(text.contains(sentence), "{args:?}: {text}");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 3, "{args:?} left files");
}
