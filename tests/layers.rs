//! Dependencies point down: which folder of `src` may use which.
use std::path::{Path, PathBuf};

/// Folder and what it may use besides itself.
const RULES: &[(&str, &[&str])] = &[
    ("error", &[]),
    ("bits", &[]),
    ("format", &[]),
    ("config", &["error", "format"]),
    ("golden", &["error", "format", "config"]),
    ("oracle", &["error", "format"]),
    ("ir", &["error", "bits"]),
    ("interp", &["error", "bits", "files", "ir"]),
    ("verilog", &["error", "bits", "ir"]),
    ("units", &["error", "bits", "format", "config", "ir"]),
    ("files", &["error"]),
    ("scene", &["error", "config", "files"]),
    ("emit", &["error", "config", "ir", "verilog"]),
    ("vectors", &["error", "bits", "format", "ir", "emit"]),
    ("trace", &["error", "bits", "format", "config", "golden", "ir", "interp", "units"]),
    ("bench", &["error", "ir", "emit", "trace"]),
    ("catalogue", &["error", "bits", "format", "config", "golden", "ir", "interp", "units", "vectors", "trace"]),
    ("report", &["error", "config", "golden", "oracle"]),
];

fn rust_files(dir: &Path, out: &mut Vec<PathBuf>) {
    for e in std::fs::read_dir(dir).unwrap().flatten() {
        if e.path().is_dir() { rust_files(&e.path(), out) } else { out.push(e.path()) }
    }
}

#[test]
fn dependencies_point_down() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut bad, mut seen) = (Vec::new(), 0);
    for (folder, allowed) in RULES {
        let mut files = Vec::new();
        rust_files(&src.join(folder), &mut files);
        for file in files.iter().filter(|f| f.extension().is_some_and(|e| e == "rs")) {
            let text = std::fs::read_to_string(file).unwrap();
            for (i, line) in text.lines().enumerate() {
                let code = line.split("//").next().unwrap();
                for part in code.split("crate::").skip(1) {
                    let used: String = part.chars().take_while(|c| c.is_ascii_lowercase() || *c == '_').collect();
                    seen += 1;
                    if used != *folder && !allowed.contains(&used.as_str()) {
                        bad.push(format!("{}:{}: {folder} may not use {used}", file.display(), i + 1));
                    }
                }
            }
        }
    }
    assert!(seen > 100, "only {seen} uses were read");
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}
