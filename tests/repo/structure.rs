//! The shape of `src`: short functions, and the command line in its place.
use crate::source::{closing, edges, files, modules, tokens};
use std::path::Path;

/// Lines of a function, signature and body; of what stands in it, too.
const MOST: usize = 100;

/// Functions that still are longer, in the order of their files.
const LONG: &[&str] = &[];

/// The functions of a text that are longer, with their first line and how many they have.
fn long_functions(text: &str) -> Vec<(String, usize, usize)> {
    let tokens = tokens(text);
    let mut out = Vec::new();
    for k in (0..tokens.len()).filter(|k| tokens[*k].is("fn") && tokens.get(k + 1).is_some_and(|t| t.is_word())) {
        let mut at = k;
        let body = loop {
            match tokens.get(at).map(|t| t.text.as_str()) {
                Some("(" | "[") => at = closing(&tokens, at),
                Some("{") => break Some(at),
                Some(";") | None => break None,
                Some(_) => {}
            }
            at += 1;
        };
        let Some(body) = body else { continue };
        let (first, last) = (tokens[k].line, tokens[closing(&tokens, body)].line);
        if last - first + 1 > MOST {
            out.push((tokens[k + 1].text.clone(), first, last - first + 1));
        }
    }
    out
}

#[test]
fn no_function_is_longer_than_a_hundred_lines() {
    let mut found = Vec::new();
    for (file, text) in files() {
        for (name, line, lines) in long_functions(&text) {
            println!("src/{}:{line}: {name} has {lines} lines", file.display());
            found.push(format!("{}: {name}", file.display()));
        }
    }
    assert_eq!(found, LONG, "functions of more than {MOST} lines, printed above, and those that are listed");
}

#[test]
fn long_functions_are_found() {
    let body = "    let x = \"{\"; // {\n".repeat(MOST - 2);
    let text = format!("fn short() {{\n{body}}}\n\nimpl X {{\n    fn long(&self) -> [u8; 3] {{\n\n{body}    }}\n}}\n");
    assert_eq!(long_functions(&text), [("long".to_owned(), MOST + 3, MOST + 1)]);
}

/// What verbs share; every other file or folder of `src/cli` is a verb.
const SHARED: &[&str] = &["args", "checked", "interrupt", "load", "lost", "mod", "output", "print", "shell", "views"];

/// The file or folder of `src/cli` that a file belongs to.
fn part_of_cli(file: &Path) -> Option<String> {
    let part = file.strip_prefix("cli").ok()?.iter().next()?;
    Some(part.to_string_lossy().trim_end_matches(".rs").to_owned())
}

#[test]
fn verbs_do_not_use_each_other() {
    let files = files();
    let parts: Vec<String> = files.iter().filter_map(|(file, _)| part_of_cli(file)).collect();
    for shared in SHARED {
        assert!(parts.iter().any(|part| part == shared), "src/cli has no {shared}: take it out of SHARED");
    }
    let verbs = parts.iter().filter(|part| !SHARED.contains(&part.as_str())).count();
    assert!(verbs >= 16, "only {verbs} files of verbs were found");
    let crossing = |e: &crate::source::Edge| {
        let (user, used) = (part_of_cli(&e.user).unwrap_or_default(), part_of_cli(&e.used)?);
        let free = user == used || user == "mod" || SHARED.contains(&used.as_str());
        (!free).then(|| format!("src/{}:{} uses {} of {}", e.user.display(), e.line, e.item, e.used.display()))
    };
    let crossing: Vec<String> = edges(&modules(&files)).iter().filter_map(crossing).collect();
    assert!(
        crossing.is_empty(),
        "verbs parse, call and print; what two of them need goes below:\n{}",
        crossing.join("\n")
    );
}

#[test]
fn the_command_line_is_known_to_cli_alone() {
    let mut found = Vec::new();
    for (file, text) in files().iter().filter(|(file, _)| !file.starts_with("cli") && file != Path::new("main.rs")) {
        let clap = tokens(text).into_iter().find(|t| ["clap", "clap_complete"].contains(&t.text.as_str()));
        found.extend(clap.map(|t| format!("src/{}:{}", file.display(), t.line)));
    }
    assert!(found.is_empty(), "clap stands outside of src/cli: {}", found.join(", "));
}
