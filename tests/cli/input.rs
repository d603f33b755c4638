//! Bad input: one sentence, exit code 2, nothing left behind.
use super::{refused, said};
use std::process::Command;

#[test]
fn bad_input_gets_one_sentence() {
    refused(&["build", "--map", "broken.png"], "broken.png: not a readable PNG");
    refused(&["build", "--set", "format.expp=3"], "unknown key format.expp (--set): did you mean format.exp?");
    refused(&["build", "--set", "format.exp=1"], "format.exp = 1 is too small: 2 to 8 are legal");
    refused(&["build", "--set", "traverse.levels=13"], "traverse.levels = 13 is too large: 2 to 12 are legal");
    refused(&["trace", "--rays", "miss.csv", "--out", "h.csv"], "no column dv");
    refused(&["trace", "--rays", "let.csv", "--out", "h.csv"], "column v: \"x\" is not a number");
    refused(&["emit", "--unit", "traverze"], "did you mean traverse?");
    refused(&["render", "--view", "side"], "none of front, oblique, grazing");
}

#[test]
fn an_output_never_replaces_an_input() {
    let dir = tempfile::tempdir().unwrap();
    let rays = "u,v,du,dv\n0.5,0.5,0.1,0.2\n";
    std::fs::write(dir.path().join("r.csv"), rays).unwrap();
    let (code, text) = said(dir.path(), &["trace", "--engine", "golden", "--rays", "r.csv", "--out", "./r.csv"]);
    assert_eq!(code, Some(2), "{text}");
    assert!(text.contains("would replace the input"), "{text}");
    assert_eq!(std::fs::read_to_string(dir.path().join("r.csv")).unwrap(), rays);
    let (code, _) = said(dir.path(), &["render", "--engine", "golden", "--out", "m.png", "--set", "view.stride=16"]);
    assert_eq!(code, Some(0));
    let before = std::fs::read(dir.path().join("m.png")).unwrap();
    let again = ["render", "--engine", "golden", "--map", "m.png", "--resample", "--out", "m.png"];
    assert_eq!(said(dir.path(), &again).0, Some(2));
    assert_eq!(std::fs::read(dir.path().join("m.png")).unwrap(), before);
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let dir = tempfile::tempdir().unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
        .args(["config", "--print"])
        .current_dir(dir.path())
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let out = child.wait_with_output().unwrap();
    assert_eq!(out.status.code(), Some(0));
    assert!(out.stderr.is_empty(), "{}", String::from_utf8_lossy(&out.stderr));
}
