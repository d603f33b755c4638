//! The shape of `src`: short functions, and the command line in its place.
use crate::source::{closing, files, tokens};

/// Lines of a function, signature and body; of what stands in it, too.
const MOST: usize = 100;

/// Functions that still are longer, in the order of their files.
const LONG: &[&str] = &[
    "cli/hard.rs: run",
    "units/float/add.rs: fp_add",
    "units/traversal/plane_iteration.rs: plane_iteration",
    "units/traversal/published/iteration.rs: iteration",
    "units/traversal/traverse.rs: in_registers",
];

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
