//! The layers of `docs/architecture.md`: a module uses only what stands below it.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Lowest first. Modules of one layer don't see each other.
const LAYERS: &[&[&str]] = &[
    &["error", "bits", "measured"],
    &["format", "files", "process"],
    &["config"],
    &["golden", "oracle", "ir"],
    &["interp", "verilog"],
    &["units", "scene"],
    &["emit", "trace"],
    &["vectors", "bench", "proofs", "synth", "measure"],
    &["catalogue", "fit", "report"],
    &["project"],
    &["cli"],
];

/// Pairs that stay apart although one stands above the other: a helper in common would let one mistake pass on both sides.
const APART: &[(&str, &str)] = &[
    ("golden", "ir"),
    ("golden", "units"),
    ("golden", "interp"),
    ("golden", "verilog"),
    ("golden", "oracle"),
    ("oracle", "ir"),
    ("oracle", "units"),
    ("oracle", "interp"),
    ("oracle", "verilog"),
];

fn layer(module: &str) -> Option<usize> {
    LAYERS.iter().position(|l| l.contains(&module))
}

/// The rule that `user` breaks by seeing `used`, if it breaks one.
fn broken(user: &str, used: &str) -> Option<String> {
    if user == used {
        return None;
    }
    if APART.iter().any(|(a, b)| (user, used) == (*a, *b) || (user, used) == (*b, *a)) {
        return Some(format!("{user} and {used} must not see each other: they check each other"));
    }
    match (layer(user), layer(used)) {
        (None, _) => Some(format!("{user} has no layer: give it one in tests/repo/layers.rs and docs/architecture.md")),
        (_, None) => Some(format!("{used} has no layer: give it one in tests/repo/layers.rs and docs/architecture.md")),
        (Some(u), Some(l)) if l > u => Some(format!("{user} stands below {used} and must not use it")),
        (Some(u), Some(l)) if l == u => Some(format!("{user} and {used} stand side by side and don't see each other")),
        _ => None,
    }
}

fn rust_files(dir: &Path, out: &mut Vec<PathBuf>) {
    let entries = std::fs::read_dir(dir).unwrap_or_else(|e| panic!("{}: {e}", dir.display()));
    for path in entries.map(|e| e.expect("a directory entry").path()) {
        if path.is_dir() {
            rust_files(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

/// The modules named on a line by `crate::name` or `crate::{name, other::..}`; comments don't count.
fn named(line: &str) -> BTreeSet<String> {
    let code = line.split("//").next().unwrap_or_default();
    let word = |s: &str| -> String { s.chars().take_while(|c| c.is_ascii_lowercase() || *c == '_').collect() };
    let mut out = BTreeSet::new();
    for (at, _) in code.match_indices("crate::") {
        let rest = &code[at + "crate::".len()..];
        match rest.strip_prefix('{') {
            None => drop(out.insert(word(rest))),
            Some(list) => {
                let mut depth = 0;
                let mut item = String::new();
                for c in list.chars() {
                    match c {
                        '{' => depth += 1,
                        '}' if depth == 0 => break,
                        '}' => depth -= 1,
                        ',' if depth == 0 => drop(out.insert(word(std::mem::take(&mut item).trim()))),
                        c if depth == 0 => item.push(c),
                        _ => {}
                    }
                }
                out.insert(word(item.trim()));
            }
        }
    }
    // `crate::Thing` in capitals is a re-export of the root, of which there is none.
    out.retain(|m| !m.is_empty());
    out
}

/// A file's lines with every `use crate::{` that spans lines joined into one; the number is that of its first line.
fn statements(text: &str) -> Vec<(usize, String)> {
    let mut out: Vec<(usize, String)> = Vec::new();
    let mut open = false;
    for (i, line) in text.lines().enumerate() {
        if open {
            let last = out.last_mut().expect("something is open");
            last.1 += line.trim();
        } else {
            out.push((i + 1, line.to_owned()));
        }
        let last = &out[out.len() - 1].1;
        open = last.contains("use crate::{") && !last.contains(';');
    }
    out
}

#[test]
fn every_module_uses_only_what_stands_below_it() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&src, &mut files);
    files.sort();
    let (mut problems, mut uses) = (Vec::new(), 0);
    for file in &files {
        let path = file.strip_prefix(&src).expect("a file of src");
        let user = path.iter().next().expect("a name").to_string_lossy().trim_end_matches(".rs").to_owned();
        if ["lib", "main"].contains(&user.as_str()) {
            continue;
        }
        let text = std::fs::read_to_string(file).expect("source is text");
        for (number, line) in statements(&text) {
            for used in named(&line) {
                uses += 1;
                if let Some(rule) = broken(&user, &used) {
                    problems.push(format!("src/{}:{number}: {rule}\n    {}", path.display(), line.trim()));
                }
            }
        }
    }
    assert!(uses > 100, "only {uses} uses were found in {} files", files.len());
    assert!(problems.is_empty(), "{} uses break the layers:\n{}", problems.len(), problems.join("\n"));
}

#[test]
fn every_module_of_the_crate_has_one_layer() {
    let lib = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).expect("text");
    let modules: Vec<&str> = lib.lines().filter_map(|l| l.strip_prefix("pub mod ")?.strip_suffix(';')).collect();
    assert!(modules.len() >= 20, "{modules:?}");
    for m in modules {
        assert_eq!(LAYERS.iter().flat_map(|l| l.iter()).filter(|n| **n == m).count(), 1, "{m} has no layer, or two");
    }
}

#[test]
fn the_rules_find_what_they_are_for() {
    for (user, used) in [
        ("golden", "units"),
        ("ir", "golden"),
        ("interp", "golden"),
        ("oracle", "golden"),
        ("interp", "verilog"),
        ("bits", "ir"),
        ("vectors", "bench"),
        ("units", "cli"),
        ("unheard_of", "bits"),
    ] {
        assert!(broken(user, used).is_some(), "{user} uses {used}");
    }
    for (user, used) in [("golden", "config"), ("trace", "golden"), ("trace", "units"), ("measure", "oracle")] {
        assert_eq!(broken(user, used), None);
    }
    let names = |s: &str| named(s).into_iter().collect::<Vec<_>>().join(" ");
    assert_eq!(names("use crate::golden::float;"), "golden");
    assert_eq!(names("pub use crate::{bits, ir::{Module, Node}, units};"), "bits ir units");
    assert_eq!(names("let x = crate::bits::mask(3) + crate::format::ONE; // crate::cli"), "bits format");
    let joined = statements("use crate::{\n    bits,\n    ir::Module,\n};\nlet x = 1;\n");
    assert_eq!(joined.len(), 2);
    assert_eq!((joined[0].0, names(&joined[0].1)), (1, "bits ir".to_owned()));
}
