//! What the modules of `src` define and import.
use super::tokens::{Token, closing, tokens};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A name that a `use` brings in.
pub struct Import {
    /// Segments, as they are written.
    pub path: Vec<String>,
    pub line: usize,
    /// Re-exported: its users are charged, not the file that passes it on.
    pub passed_on: bool,
}

/// A module: a file, or an inline one of its file.
#[derive(Default)]
pub struct Module {
    /// Segments below `src`.
    pub path: Vec<String>,
    /// What `crate` stands for in it: segments below `src`.
    pub root: Vec<String>,
    /// Its file, relative to `src`.
    pub file: PathBuf,
    /// Names defined here, child modules not among them.
    pub items: BTreeSet<String>,
    /// Names by `use`; a function and a module may have the same.
    pub imports: BTreeMap<String, Vec<Import>>,
    /// `use path::*`.
    pub globs: Vec<Import>,
    /// What is left of the text without `use`, attributes and inline modules.
    pub code: Vec<Token>,
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

/// The files of `src`, relative to it, and their text.
pub fn files() -> Vec<(PathBuf, String)> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&src, &mut files);
    files.sort();
    let read = |f: &PathBuf| std::fs::read_to_string(f).expect("source is text");
    files.iter().map(|f| (f.strip_prefix(&src).expect("a file of src").to_owned(), read(f))).collect()
}

/// Segments of the module that a file holds.
fn module_path(file: &Path) -> Vec<String> {
    let mut path: Vec<String> = file.iter().map(|s| s.to_string_lossy().into_owned()).collect();
    let last = path.pop().expect("a name");
    match last.as_str() {
        "mod.rs" | "lib.rs" | "main.rs" => {}
        name => path.push(name.trim_end_matches(".rs").to_owned()),
    }
    path
}

/// All modules of the libraries; of texts given as files with their paths. A folder of `src` with a `lib.rs` is a crate.
pub fn modules(files: &[(PathBuf, String)]) -> Vec<Module> {
    let mut out = Vec::new();
    for (file, text) in files.iter().filter(|(file, _)| file != Path::new("main.rs")) {
        let path = module_path(file);
        let folder = path.first().filter(|f| files.iter().any(|(other, _)| *other == Path::new(f).join("lib.rs")));
        read_module(file, folder.into_iter().cloned().collect(), path, &tokens(text), &mut out);
    }
    out
}

fn read_module(file: &Path, root: Vec<String>, path: Vec<String>, tokens: &[Token], out: &mut Vec<Module>) {
    let mut m = Module { file: file.to_owned(), root, path, ..Module::default() };
    let (mut k, mut depth, mut of_tests) = (0, 0, false);
    while k < tokens.len() {
        let next = |n: usize| tokens.get(k + n).map_or("", |t| t.text.as_str());
        match next(0) {
            "#" if next(1) == "[" || (next(1) == "!" && next(2) == "[") => {
                let open = if next(1) == "[" { k + 1 } else { k + 2 };
                let close = closing(tokens, open);
                of_tests |= tokens[open..close].iter().map(|t| t.text.as_str()).eq(["[", "cfg", "(", "test", ")"]);
                k = close + 1;
                continue;
            }
            "use" => {
                let end = (k..tokens.len()).find(|e| tokens[*e].is(";")).expect("a use ends");
                let passed_on = k > 0 && (tokens[k - 1].is("pub") || tokens[k - 1].is(")"));
                read_tree(&tokens[k + 1..end], &[], passed_on, &mut m);
                k = end + 1;
                continue;
            }
            "mod" if next(2) == "{" => {
                let close = closing(tokens, k + 2);
                if !of_tests {
                    let path = m.path.iter().cloned().chain([next(1).to_owned()]).collect();
                    read_module(file, m.root.clone(), path, &tokens[k + 3..close], out);
                }
                of_tests = false;
                k = close + 1;
                continue;
            }
            "macro_rules" => drop(m.items.insert(next(2).to_owned())),
            "fn" | "struct" | "enum" | "trait" | "const" | "static" | "type" | "union"
                if depth == 0 && tokens.get(k + 1).is_some_and(Token::is_word) =>
            {
                m.items.insert(next(1).to_owned());
            }
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => depth -= 1,
            _ => {}
        }
        if depth == 0 && [";", "}"].contains(&next(0)) {
            of_tests = false;
        }
        m.code.push(tokens[k].clone());
        k += 1;
    }
    out.push(m);
}

/// Reads the tree of a `use` below `prefix`.
fn read_tree(tree: &[Token], prefix: &[String], passed_on: bool, m: &mut Module) {
    let mut path = prefix.to_vec();
    let mut k = 0;
    while k < tree.len() {
        match tree[k].text.as_str() {
            "{" => {
                let (mut from, mut depth) = (k + 1, 0);
                for e in k + 1..tree.len() {
                    match tree[e].text.as_str() {
                        "{" => depth += 1,
                        "}" if depth > 0 => depth -= 1,
                        "," | "}" if depth == 0 => {
                            read_tree(&tree[from..e], &path, passed_on, m);
                            from = e + 1;
                        }
                        _ => {}
                    }
                }
                return;
            }
            "*" => return m.globs.push(Import { path, line: tree[k].line, passed_on }),
            "::" => {}
            "as" => break,
            "self" if !path.is_empty() => {}
            word => path.push(word.to_owned()),
        }
        k += 1;
    }
    let (Some(first), Some(last)) = (tree.first(), path.last()) else { return };
    let name = if k < tree.len() { tree[k + 1].text.clone() } else { last.clone() };
    m.imports.entry(name).or_default().push(Import { line: first.line, path, passed_on });
}
