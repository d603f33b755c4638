//! What is committed is what the default configuration emits, and emission has no memory.
use reliefrtl::config::Config;
use reliefrtl::emit::{self, Files};
use reliefrtl::units;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// Everything that `reliefrtl build` writes and the repository keeps, from the library alone.
fn emitted(c: &Config) -> Files {
    let modules = emit::modules(&units::all(&c.design())).expect("the default configuration is legal");
    let mut files = emit::rtl(c, &modules);
    let manifest = emit::manifest(c, &modules, &files);
    files.insert("manifest.json".into(), serde_json::to_string_pretty(&manifest).expect("plain data") + "\n");
    files
}

/// The files under the emitted directories of the repository, and the manifest.
fn committed(directories: &[&str]) -> BTreeMap<String, Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut out = BTreeMap::new();
    for directory in directories {
        let entries = std::fs::read_dir(root.join(directory)).into_iter().flatten().flatten();
        for path in entries.map(|e| e.path()).filter(|p| p.is_file()) {
            let name = path.file_name().expect("a file has a name").to_string_lossy().into_owned();
            out.insert(format!("{directory}/{name}"), std::fs::read(&path).expect("readable"));
        }
    }
    if let Ok(bytes) = std::fs::read(root.join("manifest.json")) {
        out.insert("manifest.json".into(), bytes);
    }
    out
}

/// What differs, one line a file.
fn differences(emitted: &BTreeMap<String, Vec<u8>>, committed: &BTreeMap<String, Vec<u8>>) -> Vec<String> {
    let mut out = Vec::new();
    for (path, bytes) in emitted {
        match committed.get(path) {
            None => out.push(format!("missing    {path}")),
            Some(old) if old != bytes => {
                let lines = |b: &[u8]| String::from_utf8_lossy(b).lines().map(str::to_owned).collect::<Vec<_>>();
                let (old, new) = (lines(old), lines(bytes));
                let at = old.iter().zip(&new).position(|(a, b)| a != b).unwrap_or(old.len().min(new.len()));
                let show = |l: &[String]| l.get(at).cloned().unwrap_or_else(|| "(the file ends)".into());
                out.push(format!("differs    {path}:{}\n    - {}\n    + {}", at + 1, show(&old), show(&new)));
            }
            Some(_) => {}
        }
    }
    out.extend(committed.keys().filter(|p| !emitted.contains_key(*p)).map(|p| format!("surplus    {p}")));
    out
}

#[test]
fn the_committed_files_are_what_the_default_configuration_emits() {
    let new: BTreeMap<String, Vec<u8>> =
        emitted(&Config::default()).into_iter().map(|(path, text)| (path, text.into_bytes())).collect();
    let old = committed(&["rtl"]);
    let found = differences(&new, &old);
    assert!(
        found.is_empty(),
        "{} of {} emitted files are not as committed; `cargo run --release -- build --refresh` writes them anew:\n{}",
        found.len(),
        new.len(),
        found.join("\n")
    );
    assert!(new.len() > 25, "only {} files were compared", new.len());
}

#[test]
fn the_same_configuration_gives_the_same_bytes() {
    let start = Instant::now();
    let first = emitted(&Config::default());
    let took = start.elapsed();
    assert_eq!(first, emitted(&Config::default()));
    let bytes: usize = first.values().map(String::len).sum();
    println!("{} files, {bytes} bytes in {:.1} ms", first.len(), took.as_secs_f64() * 1e3);
    let mut deeper = Config::default();
    deeper.apply_set("latency.div=7").expect("legal");
    assert_ne!(emitted(&deeper)["rtl/fp_div.v"], first["rtl/fp_div.v"]);
    assert_ne!(emitted(&deeper)["manifest.json"], first["manifest.json"]);
}

#[test]
fn differences_are_named() {
    let files = |list: &[(&str, &str)]| -> BTreeMap<String, Vec<u8>> {
        list.iter().map(|(p, t)| ((*p).to_owned(), t.as_bytes().to_vec())).collect()
    };
    let new = files(&[("rtl/a.v", "1\n2\n"), ("rtl/b.v", "1\n"), ("rtl/c.v", "1\n")]);
    let old = files(&[("rtl/a.v", "1\n3\n"), ("rtl/c.v", "1\n"), ("rtl/d.v", "1\n")]);
    let expected = ["differs    rtl/a.v:2\n    - 3\n    + 2", "missing    rtl/b.v", "surplus    rtl/d.v"];
    assert_eq!(differences(&new, &old), expected);
    assert_eq!(differences(&new, &new), [""; 0]);
}
