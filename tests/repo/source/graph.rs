//! Which file of `src` uses which: names are followed through re-exports to the file that defines them.
use super::modules::{Import, Module};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A use of something that another file defines.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Edge {
    pub user: PathBuf,
    pub used: PathBuf,
    pub line: usize,
    /// What is used.
    pub item: String,
}

enum Target {
    Module(usize),
    Item(usize),
}

/// All modules, by their paths.
struct Names<'a> {
    modules: &'a [Module],
    by_path: BTreeMap<&'a [String], usize>,
}

/// What a look-up has been through.
type Seen = BTreeSet<(usize, String, bool)>;

impl Names<'_> {
    /// What `path`, written in module `at`, names; `None` if it is of another crate.
    fn resolve(&self, at: usize, path: &[String], seen: &mut Seen) -> Option<Target> {
        let mut here = at;
        let mut k = 0;
        let found = |p: &[String]| self.by_path.get(p).copied();
        match path.first()?.as_str() {
            "crate" => (here, k) = (found(&self.modules[at].root)?, 1),
            "self" => k = 1,
            _ => {}
        }
        while path.get(k).is_some_and(|s| s == "super") {
            let own = &self.modules[here].path;
            (here, k) = (found(&own[..own.len().checked_sub(1)?])?, k + 1);
        }
        let rooted = k > 0;
        while let Some(name) = path.get(k) {
            let last = k + 1 == path.len();
            match self.look_up(here, name, !last, seen) {
                Some(Target::Module(m)) => here = m,
                Some(item) => return Some(item),
                // Another crate of ours.
                None if k == 0 && self.own(name).is_some() => here = self.own(name)?,
                // A macro may define it.
                None => return (rooted || k > 0).then_some(Target::Item(here)),
            }
            k += 1;
        }
        Some(Target::Module(here))
    }

    /// A name as module `at` knows it; `as_module`: more of the path follows, so that a module comes before an item.
    fn look_up(&self, at: usize, name: &str, as_module: bool, seen: &mut Seen) -> Option<Target> {
        if !seen.insert((at, name.to_owned(), as_module)) {
            return None;
        }
        let m = &self.modules[at];
        let child: Vec<String> = m.path.iter().cloned().chain([name.to_owned()]).collect();
        let child = self.by_path.get(child.as_slice()).map(|c| Target::Module(*c));
        if m.items.contains(name) && !(as_module && child.is_some()) {
            return Some(Target::Item(at));
        }
        if as_module && child.is_some() {
            return child;
        }
        let mut by_import = None;
        for import in m.imports.get(name).into_iter().flatten() {
            match self.resolve(at, &import.path, seen) {
                Some(Target::Item(i)) => return Some(Target::Item(i)),
                found => by_import = by_import.or(found),
            }
        }
        by_import.or(child).or_else(|| {
            m.globs.iter().find_map(|g| match self.resolve(at, &g.path, seen)? {
                Target::Module(inner) if inner != at => self.look_up(inner, name, as_module, seen),
                _ => None,
            })
        })
    }

    /// The module of a crate of ours, by the crate's name.
    fn own(&self, name: &str) -> Option<usize> {
        let folder = name.strip_prefix("reliefrtl_")?.to_owned();
        self.by_path.get([folder].as_slice()).copied()
    }

    fn item(&self, at: usize, path: &[String]) -> Option<&Path> {
        match self.resolve(at, path, &mut Seen::new())? {
            Target::Item(m) => Some(&self.modules[m].file),
            // A name space alone is no use of what stands in it.
            Target::Module(_) => None,
        }
    }
}

/// The paths in code: their segments and their line.
fn paths(m: &Module) -> Vec<(Vec<String>, usize)> {
    let code = &m.code;
    let mut out = Vec::new();
    let mut k = 0;
    while k < code.len() {
        let before = k.checked_sub(1).map_or("", |b| code[b].text.as_str());
        if !code[k].is_word() || [".", "::", "fn", "'"].contains(&before) {
            k += 1;
            continue;
        }
        let line = code[k].line;
        let mut path = vec![code[k].text.clone()];
        while code.get(k + 1).is_some_and(|t| t.is("::")) && code.get(k + 2).is_some_and(|t| t.is_word()) {
            path.push(code[k + 2].text.clone());
            k += 2;
        }
        let after = code.get(k + 1).map_or("", |t| t.text.as_str());
        let capital = path[0].starts_with(char::is_uppercase);
        // A small word alone may be a variable or a field, but where it is called.
        if path.len() > 1 || capital || ["(", "!", "::"].contains(&after) {
            out.push((path, line));
        }
        k += 1;
    }
    out
}

/// Every use of one file by another, once a pair and item.
pub fn edges(modules: &[Module]) -> Vec<Edge> {
    let by_path = modules.iter().enumerate().map(|(k, m)| (m.path.as_slice(), k)).collect();
    let names = Names { modules, by_path };
    let mut out: BTreeMap<(PathBuf, PathBuf, String), usize> = BTreeMap::new();
    for (at, m) in modules.iter().enumerate() {
        let imported = m.imports.values().flatten().filter(|i: &&Import| !i.passed_on);
        let imported = imported.map(|i| (i.path.clone(), i.line));
        for (path, line) in imported.chain(paths(m)) {
            let Some(file) = names.item(at, &path).filter(|file| **file != m.file) else { continue };
            let item = path.last().expect("a segment").clone();
            out.entry((m.file.clone(), file.to_owned(), item)).or_insert(line);
        }
    }
    out.into_iter().map(|((user, used, item), line)| Edge { user, used, line, item }).collect()
}

/// Groups of files that use each other in circles.
pub fn circles(edges: &[Edge]) -> Vec<BTreeSet<PathBuf>> {
    let mut next: BTreeMap<&Path, BTreeSet<&Path>> = BTreeMap::new();
    for e in edges {
        next.entry(&e.user).or_default().insert(&e.used);
        next.entry(&e.used).or_default();
    }
    let reach: BTreeMap<&Path, BTreeSet<&Path>> = next
        .keys()
        .map(|from| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![*from]);
            while let Some(f) = open.pop() {
                open.extend(next[f].iter().copied().filter(|t| seen.insert(*t)));
            }
            (*from, seen)
        })
        .collect();
    let mut out: BTreeSet<BTreeSet<PathBuf>> = BTreeSet::new();
    for (file, seen) in reach.iter().filter(|(file, seen)| seen.contains(*file)) {
        out.insert(seen.iter().filter(|other| reach[**other].contains(file)).map(|f| f.to_path_buf()).collect());
    }
    out.into_iter().collect()
}

/// The folder that holds all files of a circle.
pub fn folder(circle: &BTreeSet<PathBuf>) -> PathBuf {
    let first = circle.first().expect("a file");
    let holds = |dir: &&Path| circle.iter().all(|f| f.starts_with(dir));
    first.ancestors().skip(1).find(holds).expect("src holds all").to_owned()
}
