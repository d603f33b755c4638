//! A datapath is named in one table a layer, and the modes are listed in one place: what differs is asked there.
use crate::source::files;
use reliefrtl::config::DatapathKind;
use std::path::{Path, PathBuf};

/// Files of `src` that name a kind of datapath beside the entries of `config`, at most: the tables of `golden`, `units` and `catalogue`.
const MOST: usize = 3;

/// Files outside of the entries that ask for a property which only one datapath has, or only one lacks, at most: else it is a name of that datapath.
const ASKED: usize = 3;

/// Properties that more files ask for, with their number, and what they are instead of a datapath's name.
const PROMISES: &[(&str, usize, &str)] = &[
    ("modes_agree", 5, "what a hit is judged by: each comparison of hits has to know it"),
    ("reads.nudge_bits", 4, "a key of the configuration, which plan and page leave out where it is not read"),
];

/// The files with `word` in their code; comments don't count.
fn naming(word: &str, files: &[(PathBuf, String)]) -> Vec<PathBuf> {
    let code = |text: &str| text.lines().any(|l| l.split("//").next().is_some_and(|code| code.contains(word)));
    files.iter().filter(|(_, text)| code(text)).map(|(file, _)| file.clone()).collect()
}

#[test]
fn few_files_name_a_kind_of_datapath() {
    let found = naming("DatapathKind::", &outside());
    let list: Vec<_> = found.iter().map(|f| format!("src/{}", f.display())).collect();
    println!("{} files name a kind of datapath: {}", list.len(), list.join(", "));
    assert!(!found.is_empty() && found.len() <= MOST, "{} files, at most {MOST}:\n{}", list.len(), list.join("\n"));
}

/// The files of `src` outside of the entries of `config`.
fn outside() -> Vec<(PathBuf, String)> {
    files().into_iter().filter(|(file, _)| !file.starts_with("config/datapath")).collect()
}

/// The properties of a datapath that are yes or no, as its facts are written out; those of a part with its name.
fn properties(kind: DatapathKind) -> Vec<(String, bool)> {
    let mut out = Vec::new();
    let mut part = String::new();
    let text = format!("{:?}", kind.facts());
    for one in text.split_once('{').expect("fields").1.split(", ") {
        // `reads: Reads { format: true`: the first field of a part.
        let (head, field) = one.split_once(" { ").unwrap_or(("", one));
        if let Some((name, _)) = head.split_once(": ") {
            part = format!("{}.", name.trim());
        }
        if let Some((name, value)) = field.trim_end_matches([' ', '}']).split_once(": ")
            && let Ok(value) = value.trim_end_matches([' ', '}']).parse()
        {
            out.push((format!("{part}{}", name.trim()), value));
        }
        if field.ends_with('}') {
            part.clear();
        }
    }
    out
}

/// Whether the code of a text asks for a property: its name after a point, and whole.
fn asks(text: &str, property: &str) -> bool {
    let spelling = format!(".{property}");
    text.lines().filter_map(|l| l.split("//").next()).any(|code| {
        let word = |rest: &str| rest.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_');
        // A part may have a name of its own: `let reads = kind.facts().reads;`.
        let own = property.contains('.') && code.contains(property);
        own || code.match_indices(&spelling).any(|(at, _)| !word(&code[at + spelling.len()..]))
    })
}

/// A property is what differs, not a name: one that singles out a datapath is asked for in few files, and is not called as a datapath is.
#[test]
fn no_property_is_a_name_of_a_datapath() {
    let all: Vec<_> = DatapathKind::WITH_SEARCHES.map(properties).into();
    assert!(all[0].len() >= 12 && all.iter().all(|p| p.len() == all[0].len()), "{all:?}");
    let (files, mut problems) = (outside(), Vec::new());
    for (k, (name, _)) in all[0].iter().enumerate() {
        if DatapathKind::WITH_SEARCHES.iter().any(|kind| kind.word() == name) {
            problems.push(format!("{name} is the name of a datapath"));
        }
        let having = all.iter().filter(|p| p[k].1).count();
        if having != 1 && having + 1 != all.len() {
            continue;
        }
        let asking: Vec<_> = files.iter().filter(|(_, text)| asks(text, name)).map(|f| f.0.display()).collect();
        let most = PROMISES.iter().find(|p| p.0 == name).map_or(ASKED, |p| p.1);
        println!("{name}: {having} of {} datapaths, asked for in {} files, at most {most}", all.len(), asking.len());
        if asking.len() > most {
            problems.push(format!("{name} is asked for in {} files, at most {most}: {asking:?}", asking.len()));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn a_property_is_asked_for_by_its_whole_name() {
    assert!(asks("if k.facts().wide {", "wide") && asks("let r = k.facts().reads;\nr.x && reads.wide", "reads.wide"));
    assert!(!asks("if k.facts().wide_open { // .wide\n", "wide") && !asks("wide: true,", "wide"));
    let kind = DatapathKind::Published;
    let found = properties(kind);
    for (name, value) in [("reads.nudge_bits", true), ("reads.window_set", false), ("divides_in_loop", true)] {
        assert!(found.contains(&(name.to_owned(), value)), "{name} in {found:?}");
    }
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
    // A folder that is listed without a name in it holds a file of each datapath.
    let stands = |f: &PathBuf| said.contains(f) || f.parent().is_some_and(|folder| said.iter().any(|s| s == folder));
    assert!(found.iter().all(stands), "{found:?} beside {said:?}");
}

/// `coherent` is a rule that asks for more than the crossing: what names it is what CONTRIBUTING says that such a rule takes.
#[test]
fn a_level_up_rule_stands_where_contributing_says() {
    let mut found = naming("LevelUp::Coherent", &files());
    // The enumeration itself says `Self::Coherent`.
    found.push("config/design.rs".into());
    // A proof of a rule that its harness does not name has no claim, and does not compile.
    let harness = "proofs/templates/fv_level_up.v";
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(harness)).expect("text");
    assert!(text.contains("rule == \"coherent\"") && !text.contains("{%- else %}\n  wire want"), "{text}");
    found.push(harness.into());
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
