//! Branches and bits that the shipped vectors reach: `data/coverage.json`, counted by Verilator on the committed tree.
//! `RELIEFRTL_REFRESH=1 cargo test --release --test report coverage -- --ignored` counts them anew (two minutes).
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

const REFRESH: &str = "RELIEFRTL_REFRESH=1 cargo test --release --test repo emission && \
                       RELIEFRTL_REFRESH=1 cargo test --release --test report coverage -- --ignored";
const STORED: &str = "data/coverage.json";
const LIST: &str = "src/units/unreached.toml";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

fn digest(text: &str) -> String {
    blake3::hash(text.as_bytes()).to_hex()[..32].to_owned()
}

/// Verilog without comments and blank lines: what is counted does not depend on them.
fn code(text: &str) -> String {
    let lines = text.lines().map(|l| l.split("//").next().unwrap_or_default().trim()).filter(|l| !l.is_empty());
    lines.collect::<Vec<_>>().join("\n")
}

/// Digests of the text of every emitted file by its module's bare name.
fn texts() -> BTreeMap<String, String> {
    let paths = std::fs::read_dir(root().join("rtl")).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    let names = paths.filter_map(|p| p.strip_suffix(".v").map(str::to_string));
    let of = |name: String| {
        let bare = name.strip_prefix("relief_").unwrap_or(&name).to_string();
        (bare, digest(&code(&read(&format!("rtl/{name}.v")))))
    };
    names.map(of).collect()
}

/// Digest of all that the benches replay, and of the bench of `traverse`, which decides when a ray is sent and a result taken.
fn replayed() -> String {
    let sets = std::fs::read_dir(root().join("golden")).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    let mut files: Vec<String> = sets.map(|s| format!("golden/{s}/stimulus.hex")).collect();
    files.retain(|f| root().join(f).exists());
    files.extend(["golden/traverse/limit/stimulus.hex", "golden/traverse/limit_1/stimulus.hex"].map(String::from));
    files.push("golden/traverse/memory.hex".into());
    files.sort();
    let bench = code(&read("testbench/relief_tb_traverse.v"));
    digest(&files.iter().map(|f| read(f)).chain([bench]).collect::<Vec<_>>().concat())
}

fn stored() -> Value {
    serde_json::from_str(&read(STORED)).unwrap()
}

/// Fails when the text, the vectors or the list of reasons changed and the count did not.
#[test]
fn the_stored_coverage_is_of_the_committed_tree_and_whole() {
    let s = stored();
    assert_eq!(s["replayed"], replayed().as_str(), "other vectors: `{REFRESH}`");
    assert_eq!(s["list"], digest(&read(LIST)).as_str(), "another {LIST}: `{REFRESH}`");
    let files = s["files"].as_array().unwrap();
    let found: BTreeMap<String, String> = files
        .iter()
        .map(|f| (f["unit"].as_str().unwrap().to_string(), f["text"].as_str().unwrap().to_string()))
        .collect();
    assert_eq!(found, texts(), "other text: `{REFRESH}`");
    for f in files {
        let n = |key: &str| f[key].as_u64().unwrap_or_else(|| panic!("{f} has no {key}"));
        let left = n("branches") + n("toggles") - n("branches_reached") - n("toggles_reached");
        assert_eq!(left, n("with_a_reason"), "{f}: not reached, and without a reason");
    }
    let toggles: u64 = files.iter().map(|f| f["toggles"].as_u64().unwrap()).sum();
    assert!(toggles > 5000, "only {toggles} bits were counted");
}

#[test]
#[ignore = "builds every bench with counters in Verilator; part of sh tools/test.sh --full"]
fn every_point_of_the_emitted_files_is_reached_or_has_a_reason() {
    let mut c = Command::new(env!("CARGO_BIN_EXE_reliefrtl"));
    let out = c.args(["check", "--engine", "verilator", "--coverage", "--json", "--dir", "."]).current_dir(root());
    let out = out.output().expect("the program runs");
    let said = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(0), "{said}");
    let counted: Value = serde_json::from_slice(&out.stdout).unwrap();
    let texts = texts();
    let line = |f: &Value| {
        let mut f = f.clone();
        f["text"] = json!(texts[f["unit"].as_str().unwrap()]);
        f.to_string()
    };
    let lines: Vec<String> = counted["files"].as_array().unwrap().iter().map(line).collect();
    let text = format!(
        "{{\"command\":\"reliefrtl check --engine verilator --coverage --json\",\n\"replayed\":\"{}\",\n\"list\":\"{}\",\n\"files\":[\n{}\n]}}\n",
        replayed(),
        digest(&read(LIST)),
        lines.join(",\n")
    );
    if std::env::var("RELIEFRTL_REFRESH").is_ok_and(|v| v == "1") {
        std::fs::write(root().join(STORED), text).unwrap();
        return;
    }
    assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), stored(), "`{REFRESH}`");
}
