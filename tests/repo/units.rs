//! The table of units: each module that a design has stands in it once, each entry is of some design, and a unit's name is a string nowhere
//! else but where its hardware is built.
use reliefrtl::catalogue::{RaySample, UNITS, Unit, entry, unit_entries};
use reliefrtl::config::keys::SECTIONS;
use reliefrtl::config::{
    Config, DatapathConfig, DatapathKind, Design, Divider, ExtraUnit, ExtraUnits, FetchConfig, LatencyConfig, LevelUp,
    ModeConfig, Trim,
};
use reliefrtl::ir::Module;
use reliefrtl::units::{all, arithmetic, available};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A design of every datapath and mode, each with one of the choices of latency that bring or leave out units.
fn designs() -> Vec<Design> {
    let mut list = Vec::new();
    for kind in DatapathKind::ALL {
        for level_up in LevelUp::ALL {
            for trim in Trim::ALL {
                for mode in 0..8u32 {
                    let [start_level, lod, bilinear] = [0, 1, 2].map(|k| mode >> k & 1 == 1);
                    let levels_down = if start_level { 3 } else { 1 };
                    let mut c = Config {
                        mode: ModeConfig {
                            start_level,
                            levels_down,
                            level_up,
                            trim,
                            lod,
                            bilinear,
                            ..ModeConfig::default()
                        },
                        ..Config::default()
                    };
                    c.datapath = DatapathConfig { kind, ..c.datapath };
                    if c.validate().is_ok() {
                        list.push(c.design());
                    }
                }
            }
        }
    }
    for kind in [DatapathKind::Watertight, DatapathKind::Fixed] {
        for trim in [Trim::None, Trim::Always] {
            let mut c = Config { fetch: FetchConfig::BLOCK, ..Config::default() };
            (c.datapath.kind, c.mode.trim, c.mode.lod) = (kind, trim, trim == Trim::Always);
            c.validate().unwrap();
            list.push(c.design());
        }
    }
    // A search by windows has none of the modes.
    let mut windows = Config::default();
    windows.datapath.kind = DatapathKind::Windows;
    windows.validate().unwrap();
    list.extend([windows.design(), windows.design()]);
    let choices = |k: usize, l: LatencyConfig| LatencyConfig {
        memory: (k % 3) as u32,
        handshake: (k % 4) as u32,
        delay_line: if k.is_multiple_of(5) { 3 } else { 0 },
        divider: if k.is_multiple_of(2) { Divider::Rows } else { Divider::Table },
        ..l
    };
    for (k, d) in list.iter_mut().enumerate() {
        d.latency = choices(k, d.latency);
        if k.is_multiple_of(7) {
            d.extra = ExtraUnits::ALL;
        }
    }
    list
}

/// The modules that a design has or may have, without those that stand only inside of others.
fn modules(d: &Design) -> Vec<Arc<Module>> {
    [all(d), available(d), arithmetic(d)].concat()
}

#[test]
fn every_module_has_one_entry_and_every_entry_a_module() {
    let designs = designs();
    let mut reached: BTreeSet<(&str, Option<&str>)> = BTreeSet::new();
    let key = |u: &'static Unit| (u.name, u.datapath.map(DatapathKind::word));
    let mut problems = BTreeSet::new();
    for d in &designs {
        let kind = d.datapath.kind;
        let mine = |u: &&Unit| u.datapath.is_none_or(|k| k == kind);
        for m in modules(d) {
            let n = unit_entries().filter(mine).filter(|u| u.name == m.name).count();
            if n != 1 {
                problems.insert(format!("{} has {n} entries in the {} datapath", m.name, kind.word()));
            }
            let stimulus = entry(d, &m.name).and_then(|u| u.stimulus);
            if stimulus.is_some_and(|f| m.data_inputs().all(|(_, p)| f(&RaySample::default(), &p.name).is_none())) {
                problems.insert(format!("the stimulus of {} decides none of its ports", m.name));
            }
            reached.extend(m.hierarchy().iter().filter_map(|m| entry(d, &m.name)).map(key));
        }
    }
    for u in unit_entries().filter(|u| !reached.contains(&key(u))) {
        problems.insert(format!(
            "no design has {} ({})",
            u.name,
            u.datapath.map_or("any datapath", DatapathKind::word)
        ));
    }
    assert!(problems.is_empty(), "{problems:#?}");
    assert!(designs.len() > 100 && unit_entries().count() > 55, "{} designs", designs.len());
    assert!(UNITS.iter().all(|area| !area.is_empty()));
}

#[test]
fn every_proof_is_of_units_of_the_table() {
    let mut names = BTreeSet::new();
    for (u, p) in unit_entries().flat_map(|u| u.proofs.iter().map(move |p| (u, p))) {
        assert!(names.insert(p.name), "two proofs are named {}", p.name);
        assert!(p.units.contains(&u.name), "{} stands with {}, of which it says nothing", p.name, u.name);
        assert!(p.units.iter().all(|n| unit_entries().any(|u| u.name == *n)), "{}: {:?}", p.name, p.units);
        assert!(!p.claim.is_empty() && p.text.contains("assert"), "{} claims or asserts nothing", p.name);
    }
    // The traversal's harness has two forms.
    let templates = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/proofs/templates")).unwrap();
    assert_eq!(templates.count(), names.len() + 1, "{names:?}");
}

/// Where what looks like the name of a unit is something else in the hardware, and what.
const OTHERS: &[(&str, &[&str], &str)] = &[
    ("src/units/float/div_table.rs", &["reciprocal"], "a section and a step of its schedule"),
    ("src/units/traversal/node_planes.rs", &["exit_plane"], "a signal"),
    ("src/units/traversal/search.rs", &["level_up"], "a key of the configuration, whose value the text states"),
];

/// Words of the configuration that are also names of units, and the one file that lists them.
fn is_of_configuration(path: &str, name: &str) -> bool {
    match path {
        // Values of the key emit.units.
        "src/config/extra.rs" => ExtraUnit::WORDS.contains(&name),
        "src/config/keys.rs" => SECTIONS.iter().any(|section| section.0 == name),
        _ => false,
    }
}

fn rust_files(dir: &Path, out: &mut Vec<PathBuf>) {
    for path in std::fs::read_dir(dir).unwrap().map(|e| e.unwrap().path()) {
        if path.is_dir() {
            rust_files(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

/// The names that stand as strings on a line; comments don't count.
fn named<'a>(line: &str, names: &BTreeSet<&'a str>) -> Vec<&'a str> {
    let code = line.split("//").next().unwrap_or_default();
    names.iter().copied().filter(|n| code.contains(&format!("\"{n}\""))).collect()
}

/// Names in a file that have no business there, with the number of their line.
fn strangers<'a>(path: &str, text: &str, names: &BTreeSet<&'a str>) -> Vec<(usize, &'a str)> {
    // The entry in which a line stands: the name after `name:`, until the entry ends.
    let (mut own, mut out) = (None, Vec::new());
    for (k, line) in text.lines().enumerate() {
        let found = named(line, names);
        if path.starts_with("src/catalogue/entries/") {
            if line.starts_with("static ") || line.starts_with("pub(super) static ") {
                own = None;
            }
            if own.is_none() && line.contains("name: \"") {
                own = found.first().copied();
            }
            out.extend(found.into_iter().filter(|n| Some(*n) != own).map(|n| (k + 1, n)));
            if line.starts_with('}') {
                own = None;
            }
        } else if path.starts_with("src/units/") {
            // A builder names its module in the first line of the call, or takes the name that the file defines or chooses before.
            let builds = |l: &str| {
                l.contains("Builder::new(")
                    || l.contains("=> (\"fp_")
                    || l.contains("pub const ") && l.contains(": &str = ")
            };
            let before = text.lines().nth(k.wrapping_sub(1)).unwrap_or_default();
            if !builds(line) && !builds(before) {
                out.extend(found.into_iter().map(|n| (k + 1, n)));
            }
        } else {
            out.extend(found.into_iter().map(|n| (k + 1, n)));
        }
    }
    out
}

#[test]
fn no_unit_is_named_outside_of_its_entry_and_its_builder() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let names: BTreeSet<&str> = unit_entries().map(|u| u.name).collect();
    let mut files = Vec::new();
    rust_files(&root.join("src"), &mut files);
    let mut problems = Vec::new();
    let mut used: BTreeSet<(&str, &str)> = BTreeSet::new();
    for file in &files {
        let path = file.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/");
        for (line, name) in strangers(&path, &std::fs::read_to_string(file).unwrap(), &names) {
            if is_of_configuration(&path, name) {
                continue;
            }
            match OTHERS.iter().find(|o| o.0 == path && o.1.contains(&name)) {
                Some(o) => drop(used.insert((o.0, name))),
                None => problems.push(format!("{path}:{line}: {name}")),
            }
        }
    }
    for (path, list, _) in OTHERS {
        problems
            .extend(list.iter().filter(|n| !used.contains(&(*path, **n))).map(|n| format!("{path} names {n} no more")));
    }
    assert!(problems.is_empty(), "{} of them:\n{}", problems.len(), problems.join("\n"));
}

#[test]
fn the_scan_finds_what_it_is_for() {
    let names = BTreeSet::from(["fp_add", "lzc"]);
    let entry = "static LZC: Unit = Unit {\n    name: \"lzc\",\n    units: &[\"lzc\", \"fp_add\"],\n};\nconst X: &str = \"lzc\";\n";
    assert_eq!(strangers("src/catalogue/entries/integer.rs", entry, &names), [(3, "fp_add"), (5, "lzc")]);
    let builder = "Builder::new(\n    \"lzc\",\n);\nif m.name == \"lzc\" {} // \"fp_add\"\n";
    assert_eq!(strangers("src/units/lzc.rs", builder, &names), [(4, "lzc")]);
    assert_eq!(strangers("src/project/mod.rs", "of(\"fp_add\")", &names), [(1, "fp_add")]);
}
