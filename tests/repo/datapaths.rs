//! A datapath is named in one table a layer, and the modes are listed in one place: what differs is asked there.
use crate::source::files;
use std::path::{Path, PathBuf};

/// Files of `src` that name a kind of datapath, at most: the tables of `config`, `golden`, `units` and `catalogue`, and one to spare.
const MOST: usize = 5;

/// The files with `word` in their code; comments don't count.
fn naming(word: &str, files: &[(PathBuf, String)]) -> Vec<PathBuf> {
    let code = |text: &str| text.lines().any(|l| l.split("//").next().is_some_and(|code| code.contains(word)));
    files.iter().filter(|(_, text)| code(text)).map(|(file, _)| file.clone()).collect()
}

#[test]
fn few_files_name_a_kind_of_datapath() {
    let found = naming("DatapathKind::", &files());
    let list: Vec<_> = found.iter().map(|f| format!("src/{}", f.display())).collect();
    println!("{} files name a kind of datapath: {}", list.len(), list.join(", "));
    assert!(!found.is_empty() && found.len() <= MOST, "{} files, at most {MOST}:\n{}", list.len(), list.join("\n"));
}

#[test]
fn modes_are_listed_in_one_file() {
    assert_eq!(naming("LevelUp::ALL", &files()), [Path::new("config/modes.rs")]);
}

/// The files that CONTRIBUTING lists for a choice.
fn said_of(choice: &str) -> Vec<PathBuf> {
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("CONTRIBUTING.md")).expect("text");
    let row = page.lines().find(|l| l.starts_with(&format!("| {choice} |"))).expect("a row of the table");
    row.split('`').skip(1).step_by(2).map(PathBuf::from).collect()
}

/// What names the search by windows is what CONTRIBUTING says that a datapath takes.
#[test]
fn a_datapath_stands_where_contributing_says() {
    let said = said_of("a datapath");
    let found = naming("DatapathKind::Windows", &files());
    assert!(found.len() > 3, "{found:?}");
    assert!(found.iter().all(|f| said.contains(f)), "{found:?} beside {said:?}");
}

/// `coherent` is a rule that asks for more than the crossing: what names it is what CONTRIBUTING says that such a rule takes.
#[test]
fn a_level_up_rule_stands_where_contributing_says() {
    let mut found = naming("LevelUp::Coherent", &files());
    // The enumeration itself says `Self::Coherent`.
    found.push("config/design.rs".into());
    found.sort();
    let mut said = said_of("a level-up rule");
    said.sort();
    assert_eq!(found, said);
}

#[test]
fn a_comment_names_nothing() {
    let file = |name: &str, text: &str| (PathBuf::from(name), text.to_owned());
    let all = [file("a.rs", "// A::B\nfn f() {}\n"), file("b.rs", "let x = A::B; // why\n"), file("c.rs", "A::C")];
    assert_eq!(naming("A::B", &all), [Path::new("b.rs")]);
}
