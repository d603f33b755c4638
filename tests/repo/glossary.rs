//! The words of `docs/glossary.md`: what its last tables refuse stands nowhere, each finding with its place and the word that is right.
use std::path::{Path, PathBuf};

/// A word or phrase that is not used, and what is right instead.
type Rule = (String, String);

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).into()
}

fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The rows of the table that comes after a line that starts with `head`.
fn rules(head: &str) -> Vec<Rule> {
    let text = read("docs/glossary.md");
    let rows = text.lines().skip_while(|l| !l.starts_with(head)).skip_while(|l| !l.starts_with("| not")).skip(2);
    let plain = |cell: &str| cell.trim().trim_matches('`').to_owned();
    let rule = |row: &str| {
        let cells: Vec<&str> = row.trim_matches('|').split(" | ").collect();
        assert_eq!(cells.len(), 2, "{row}");
        (plain(cells[0]), plain(cells[1]))
    };
    rows.take_while(|l| l.starts_with('|')).map(rule).collect()
}

/// A net's base name: without the stage before it.
fn base(word: &str) -> &str {
    let rest = word.strip_prefix('s').map(|r| r.trim_start_matches(|c: char| c.is_ascii_digit()));
    match rest.and_then(|r| r.strip_prefix('_')) {
        Some(name) if word.as_bytes()[1].is_ascii_digit() => name,
        _ => word,
    }
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The rules that a line breaks as a list of names.
fn names_in<'r>(line: &str, rules: &'r [Rule]) -> Vec<&'r Rule> {
    let words: Vec<&str> = line.split(|c| !is_word(c)).map(base).collect();
    rules.iter().filter(|r| words.contains(&r.0.as_str())).collect()
}

/// The rules that a line breaks by one of its words, alone or in a name.
fn words_in<'r>(line: &str, rules: &'r [Rule]) -> Vec<&'r Rule> {
    let lower = line.to_ascii_lowercase();
    let words: Vec<&str> = lower.split(|c: char| !c.is_ascii_alphanumeric()).collect();
    rules.iter().filter(|r| words.contains(&r.0.as_str())).collect()
}

/// The rules that a line breaks as text.
fn phrases_in<'r>(line: &str, rules: &'r [Rule]) -> Vec<&'r Rule> {
    let whole = |phrase: &str| {
        let edge = |c: Option<char>| !c.is_some_and(is_word);
        let mut found = line.match_indices(phrase);
        found.any(|(at, _)| edge(line[..at].chars().last()) && edge(line[at + phrase.len()..].chars().next()))
    };
    rules.iter().filter(|r| whole(&r.0)).collect()
}

/// Text files below a folder, or the file itself, as paths from the root.
fn texts(of: &str, out: &mut Vec<String>) {
    let place = root().join(of);
    if place.is_dir() {
        let entries = std::fs::read_dir(&place).unwrap_or_else(|e| panic!("{of}: {e}"));
        let mut names: Vec<String> =
            entries.map(|e| e.expect("a directory entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names.iter().for_each(|n| texts(&format!("{of}/{n}"), out));
    } else if !of.ends_with(".png") {
        out.push(of.to_owned());
    }
}

fn findings(places: &[&str], rules: &[Rule], find: for<'r> fn(&str, &'r [Rule]) -> Vec<&'r Rule>) -> Vec<String> {
    let mut files = Vec::new();
    places.iter().for_each(|p| texts(p, &mut files));
    // The glossary lists them; a configuration of an earlier version is kept as it was.
    files.retain(|f| f != "docs/glossary.md" && f != "tests/data/default-8b845fe.toml");
    assert!(files.len() >= 10, "{files:?}");
    let mut out = Vec::new();
    for file in &files {
        let Ok(text) = std::fs::read_to_string(root().join(file)) else { continue };
        for (k, line) in text.lines().enumerate() {
            let say = |r: &&Rule| format!("{file}:{}: not \"{}\" but \"{}\"", k + 1, r.0, r.1);
            out.extend(find(line, rules).iter().map(say));
        }
    }
    out
}

#[test]
fn no_retired_name_is_left() {
    let rules = rules("Names (");
    assert!(rules.len() >= 30, "{rules:?}");
    let places =
        ["src", "tests", "benches", "examples", "docs", "README.md", "rtl", "testbench", "flow", "manifest.json"];
    let found = findings(&places, &rules, names_in);
    assert!(found.is_empty(), "{} words of no use:\n{}", found.len(), found.join("\n"));
}

#[test]
fn documents_use_the_fields_phrases() {
    let rules = rules("Phrases (");
    assert!(rules.len() >= 6, "{rules:?}");
    let found = findings(&["docs", "README.md"], &rules, phrases_in);
    assert!(found.is_empty(), "{} phrases:\n{}", found.len(), found.join("\n"));
}

#[test]
fn comments_and_messages_name_things() {
    let rules = rules("Words (");
    assert!(rules.len() >= 5, "{rules:?}");
    let places = ["src", "rtl", "testbench", "tests", "benches", "examples", "docs", "README.md", "CONTRIBUTING.md"];
    let found = findings(&places, &rules, words_in);
    assert!(found.is_empty(), "{} words:\n{}", found.len(), found.join("\n"));
}

#[test]
fn the_rules_find_what_they_are_for() {
    let words = rules("Words (");
    for (word, _) in &words {
        for line in [format!("/// {word}, or so"), format!("let {word} = 1;"), format!("named(\"t_{word}\")")] {
            assert_eq!(words_in(&line, &words).len(), 1, "{line}");
        }
        assert!(words_in(&format!("{word}ever"), &words).is_empty());
    }
    let (names, phrases) = (rules("Names ("), rules("Phrases ("));
    for (word, right) in &names {
        let lines = [format!("  wire {word};"), format!("  assign s12_{word} = a;"), format!("see `{word}`.")];
        assert!(lines.iter().all(|l| names_in(l, &names).iter().any(|r| r.1 == *right)), "{word}");
        assert!(names_in(&format!("wire {word}x; wire x{word};"), &names).is_empty(), "{word}");
    }
    for (phrase, _) in &phrases {
        assert!(!phrases_in(&format!("It stands {phrase}, or so."), &phrases).is_empty(), "{phrase}");
    }
    assert_eq!(
        (base("s0_retire"), base("s_0"), base("setup_valid"), base("s12_x")),
        ("retire", "s_0", "setup_valid", "x")
    );
}
