//! The layers of `docs/architecture.md`: a module uses only what stands below it, and no files use each other in a circle.
use crate::source::{self, Edge};
use std::collections::BTreeMap;
use std::path::Path;

/// Lowest first. Modules of one layer don't see each other.
const LAYERS: &[&[&str]] = &[
    &["alike", "error", "bits", "measured"],
    &["format", "files", "process"],
    &["config"],
    &["golden", "oracle", "ir"],
    &["interp", "verilog"],
    &["units", "scene"],
    &["emit", "trace"],
    &["vectors", "bench", "proofs", "synth", "measure"],
    &["catalogue", "fit", "report"],
    &["engine"],
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

/// The module of a layer that a file of `src` belongs to: what stands below `base` are several.
fn module(file: &Path) -> String {
    let mut parts = file.iter().map(|part| part.to_string_lossy().trim_end_matches(".rs").to_owned());
    let first = parts.next().expect("a name");
    if first == "base" { parts.next().expect("a module of base") } else { first }
}

fn uses() -> Vec<Edge> {
    source::edges(&source::modules(&source::files()))
}

#[test]
fn every_module_uses_only_what_stands_below_it() {
    let uses = uses();
    assert!(uses.len() > 1000, "only {} uses were found", uses.len());
    let broken = |e: &Edge| {
        let rule = broken(&module(&e.user), &module(&e.used))?;
        Some(format!("src/{}:{}: {rule}: {}", e.user.display(), e.line, e.item))
    };
    let problems: Vec<String> = uses.iter().filter_map(broken).collect();
    assert!(problems.is_empty(), "{} uses break the layers:\n{}", problems.len(), problems.join("\n"));
}

/// Folders that hold a group of files that still use each other in circles, a line a group.
const CIRCLES: &[&str] = &[];

#[test]
fn no_files_use_each_other_in_circles() {
    let uses = uses();
    let circles = source::circles(&uses);
    for circle in &circles {
        println!("{} files of src/{} use each other:", circle.len(), source::folder(circle).display());
        let closing = uses.iter().filter(|e| circle.contains(&e.user) && circle.contains(&e.used));
        let mut pairs: BTreeMap<_, Vec<String>> = BTreeMap::new();
        closing.for_each(|e| pairs.entry((&e.user, &e.used)).or_default().push(format!("{} ({})", e.item, e.line)));
        for ((user, used), items) in pairs {
            println!("    {} uses of {}: {}", user.display(), used.display(), items.join(", "));
        }
    }
    let mut found: Vec<String> = circles.iter().map(|c| source::folder(c).display().to_string()).collect();
    found.sort();
    assert_eq!(found, CIRCLES, "the groups of files that use each other, printed above, and those that are listed");
}

#[test]
fn every_module_has_one_layer() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let of = |lib: &str| -> Vec<String> {
        let text = std::fs::read_to_string(src.join(lib)).expect("text");
        text.lines().filter_map(|l| Some(l.strip_prefix("pub mod ")?.strip_suffix(';')?.to_owned())).collect()
    };
    let crates =
        std::fs::read_dir(&src).expect("src").map(|e| e.expect("an entry").file_name().into_string().expect("text"));
    let crates = crates.filter(|c| c != "base" && src.join(c).join("Cargo.toml").exists());
    let modules: Vec<String> = of("lib.rs").into_iter().chain(of("base/lib.rs")).chain(crates).collect();
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
}

/// The uses in texts given as files, as `user>used:item`.
fn uses_of(files: &[(&str, &str)]) -> Vec<String> {
    let files: Vec<_> = files.iter().map(|(f, text)| (f.into(), (*text).to_owned())).collect();
    let name = |e: &Edge| format!("{}>{}:{}", e.user.display(), e.used.display(), e.item);
    source::edges(&source::modules(&files)).iter().map(name).collect()
}

#[test]
fn a_use_is_of_the_file_that_defines_the_name() {
    let lib = ("lib.rs", "pub mod a; pub mod b;");
    let passed_on = ("a/mod.rs", "mod deep; pub use deep::{Thing, make as build}; pub mod open;");
    let deep = ("a/deep.rs", "pub struct Thing; pub fn make() {}");
    let open = ("a/open.rs", "pub fn f() {} words!(Made);");
    let seen = |text| uses_of(&[lib, passed_on, deep, open, ("b.rs", text)]);
    assert_eq!(
        seen("use crate::a::{self, Thing}; fn f() { a::build() }"),
        ["b.rs>a/deep.rs:Thing", "b.rs>a/deep.rs:build"]
    );
    assert_eq!(seen("use crate::a::open as o; fn f() { o::f(); x.build() } // crate::a::Thing"), ["b.rs>a/open.rs:f"]);
    assert_eq!(
        seen("use super::a::*; fn f(t: Thing) -> open::Made {}"),
        ["b.rs>a/deep.rs:Thing", "b.rs>a/open.rs:Made"]
    );
    assert_eq!(
        seen("pub use crate::a::Thing; use std::fmt; #[cfg(test)] mod tests { use crate::a::open::f; }"),
        [""; 0]
    );
    let own = ("a/mod.rs", "mod deep; pub use deep::Thing; pub fn f(t: Thing) {}");
    let back = ("a/deep.rs", "use super::f; pub struct Thing; fn g() { f() }");
    let (member, inner) = (("c/lib.rs", "pub mod d; pub fn f() {}"), ("c/d.rs", "use crate::f; pub struct Deep;"));
    let user = ("b.rs", "use reliefrtl_c::d::Deep; fn g() { reliefrtl_c::f(); other::f() }");
    assert_eq!(uses_of(&[lib, member, inner, user]), ["b.rs>c/d.rs:Deep", "b.rs>c/lib.rs:f", "c/d.rs>c/lib.rs:f"]);
    assert_eq!(uses_of(&[lib, own, back]), ["a/deep.rs>a/mod.rs:f", "a/mod.rs>a/deep.rs:Thing"]);
}

#[test]
fn circles_are_found() {
    let edge = |user: &str, used: &str| Edge { user: user.into(), used: used.into(), line: 1, item: "x".into() };
    let found = source::circles(&[
        edge("a/b", "a/c"),
        edge("a/c", "a/d/e"),
        edge("a/d/e", "a/b"),
        edge("a/f", "a/b"),
        edge("a/b", "z"),
    ]);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].iter().collect::<Vec<_>>(), [Path::new("a/b"), Path::new("a/c"), Path::new("a/d/e")]);
    assert_eq!(source::folder(&found[0]), Path::new("a"));
}
