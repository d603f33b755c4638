//! `vectors` and `check` at levels 1 to 3, in parts and until stopped.
use super::{refused, said};
use std::process::Command;

/// Parts of a campaign are written and replayed one by one; their counts add up.
#[test]
fn corners_are_crossed_in_parts() {
    let dir = tempfile::tempdir().unwrap();
    let counted = |args: &[&str]| {
        let (code, text) = said(
            dir.path(),
            &[&["vectors", "--unit", "fp_mul", "--level", "1", "--set", "vectors.arithmetic=100"][..], args].concat(),
        );
        assert_eq!(code, Some(0), "{text}");
        let text = std::fs::read_to_string(dir.path().join("out/golden/fp_mul/vectors.json")).unwrap();
        let d: serde_json::Value = serde_json::from_str(&text).unwrap();
        (d["rows"].as_u64().unwrap(), d["events"]["tie"].as_u64().unwrap())
    };
    let whole = counted(&[]);
    let (one, two) = (counted(&["--shard", "1/2"]), counted(&["--shard", "2/2"]));
    assert_eq!((one.0 + two.0, one.1 + two.1), whole);
    let part = ["check", "--unit", "fp_mul", "--level", "1", "--shard", "2/9"];
    let (code, text) = said(dir.path(), &part);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("1 unit, 0 of"), "{text}");
    refused(&["vectors", "--unit", "fp_mul", "--level", "1", "--shard", "3/2"], "3/16 is the third of 16 parts");
    refused(&["vectors", "--unit", "level_up", "--level", "1"], "name its units, as --unit fp_add");
    refused(&["check", "--unit", "fp_mul", "--shard", "1/2"], "--level");
}

/// Level 3 goes from seed to seed, a part takes every n-th of them, and few inputs end it.
#[test]
fn random_rows_until_stopped() {
    let dir = tempfile::tempdir().unwrap();
    let lines = |more: &[&str]| -> Vec<String> {
        let line = [&["check", "--unit", "fp_lt", "--level", "3", "--set", "vectors.arithmetic=50"][..], more].concat();
        let out = Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(line).current_dir(dir.path()).output().unwrap();
        assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
        String::from_utf8_lossy(&out.stdout).lines().map(str::to_string).collect()
    };
    let whole = lines(&["--batches", "4"]);
    assert_eq!(whole.len(), 4);
    assert!(whole[3].ends_with("seed 4: 0 of 50 mismatched; 0 of 200 so far"), "{whole:?}");
    let part = lines(&["--batches", "2", "--shard", "2/3"]);
    assert!(part[0].contains("seed 2:") && part[1].contains("seed 5:"), "{part:?}");
    let few = lines(&["--set", "format.exp=4", "--set", "format.man=3"]);
    assert!(few.len() == 2 && few[0].contains("0 of 65536") && few[1].contains("all inputs"), "{few:?}");
    for (line, says) in [
        (["--level", "1", "--batches", "2"], "--batches ends --level 3"),
        (["--level", "3", "--canary", "flip"], "no --wave and no --canary"),
    ] {
        let line = [&["check", "--unit", "fp_lt"][..], &line].concat();
        let out = Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(line).current_dir(dir.path()).output().unwrap();
        assert!(out.status.code() == Some(2) && String::from_utf8_lossy(&out.stderr).contains(says));
    }
}
