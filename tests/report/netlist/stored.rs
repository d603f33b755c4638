//! `data/netlists.json`: what was replayed of which text, an entry a line.
use super::replay::{Job, called, emitted, models};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};

/// What a netlist was made of, and what it was simulated with.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Digests {
    /// The emitted modules, without comments.
    pub text: String,
    /// The script, without comments.
    pub script: String,
    /// Our models of the target's cells, without comments.
    pub models: String,
}

/// One netlist that was replayed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Entry {
    pub target: String,
    /// Whether by the newest Yosys that is installed, not the first.
    pub newest: bool,
    /// Its version.
    pub yosys: String,
    pub unit: String,
    /// Whether there may be block memories and multipliers.
    pub mapped: bool,
    /// Rows of vectors that were compared.
    pub rows: usize,
    /// Rows of which the netlist gave something else.
    pub mismatched: usize,
    /// Block memories and multipliers in the netlist, by cell.
    pub hard: BTreeMap<String, usize>,
    pub digests: Digests,
}

impl Entry {
    pub fn is_of(&self, job: &Job) -> bool {
        let asked = (job.target.name, job.unit, job.newest, job.mapped);
        (self.target.as_str(), self.unit.as_str(), self.newest, self.mapped) == asked
    }
    pub fn name(&self) -> String {
        called(&self.unit, &self.target, self.newest, self.mapped)
    }
}

fn place() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/netlists.json")
}

pub fn read() -> Vec<Entry> {
    let text = std::fs::read_to_string(place()).unwrap_or_else(|_| "[]".into());
    serde_json::from_str(&text).expect("data/netlists.json is a list of results")
}

pub fn write(entries: &mut [Entry]) {
    entries.sort_by_key(Entry::name);
    let lines: Vec<String> = entries.iter().map(|e| serde_json::to_string(e).unwrap()).collect();
    std::fs::write(place(), format!("[\n{}\n]\n", lines.join(",\n"))).unwrap();
}

/// Digest of texts without what follows `comment` in a line, each run of white space as one space.
fn digest<'a>(texts: impl IntoIterator<Item = &'a str>, comment: &str) -> String {
    let code = |text: &str| {
        let lines = text.lines().map(|l| l.split_once(comment).map_or(l, |(code, _)| code));
        lines.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
    };
    let all: Vec<String> = texts.into_iter().map(code).collect();
    blake3::hash(all.join("\n").as_bytes()).to_hex()[..32].to_string()
}

/// The digests of what `job` replays, of the text that is emitted now.
pub fn digests_of(job: &Job) -> Digests {
    thread_local! {
        static TREES: RefCell<HashMap<&'static str, tempfile::TempDir>> = RefCell::default();
    }
    TREES.with_borrow_mut(|trees| {
        let dir = trees.entry(job.unit).or_insert_with(|| {
            let dir = tempfile::tempdir().unwrap();
            emitted(dir.path(), job.unit);
            dir
        });
        digests(job, &dir.path().join("out"))
    })
}

/// The same of a tree that is there.
pub fn digests(job: &Job, tree: &Path) -> Digests {
    let read = |path: &Path| std::fs::read_to_string(path).unwrap();
    let mut rtl: Vec<PathBuf> = std::fs::read_dir(tree.join("rtl")).unwrap().flatten().map(|e| e.path()).collect();
    rtl.sort();
    let rtl: Vec<String> = rtl.iter().map(|p| read(p)).collect();
    let models: Vec<String> = models(job.target).iter().map(|p| read(p)).collect();
    Digests {
        text: digest(rtl.iter().map(String::as_str), "//"),
        script: digest([job.script(tree).as_str()], "#"),
        models: digest(models.iter().map(String::as_str), "//"),
    }
}

#[test]
fn comments_are_not_counted() {
    assert_eq!(digest(["a b // c\n  d"], "//"), digest(["a\tb d // e"], "//"));
    assert_ne!(digest(["a b d"], "//"), digest(["a bd"], "//"));
    assert_ne!(digest(["a b", "c"], "//"), digest(["a", "b c"], "//"));
}
