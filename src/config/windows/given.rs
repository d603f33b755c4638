//! Keys that mean nothing to a search by windows: refused where they are given, ignored where they are defaults.
use crate::keys::{KEYS, Key};
use crate::{Config, check};

/// The keys, or what they begin with, and what a search by windows does not have.
const IGNORED: &[(&str, &str)] = &[
    ("mode.start_level", "has no levels to start on"),
    ("mode.levels_down", "has no levels to descend"),
    ("mode.level_up", "has no levels to go up"),
    ("mode.trim", "has no nodes to trim"),
    ("mode.lod", "has no level of detail"),
    ("fetch.", "reads every window in one iteration"),
];

/// Whether a search by windows has no use for the key.
pub(crate) fn is_ignored(path: &str) -> bool {
    IGNORED.iter().any(|(what, _)| matches(what, path))
}

/// `what` is the key, or the section that it stands in.
fn matches(what: &str, path: &str) -> bool {
    path == what || what.ends_with('.') && path.starts_with(what)
}

/// Adds a sentence for each of them that was given, or that is not the default.
pub(crate) fn ignored(c: &Config, problems: &mut Vec<String>) {
    let (Ok(ours), Ok(usual)) = (c.table(), Config::default().table()) else {
        return;
    };
    let value = |table: &toml::Table, key: &Key| {
        let (section, name) = key.split();
        table.get(section)?.as_table()?.get(name).cloned()
    };
    for (what, why) in IGNORED {
        for key in KEYS.iter().filter(|k| matches(what, k.path)) {
            let now = value(&ours, key);
            if !c.given.has(key.path) && now == value(&usual, key) {
                continue;
            }
            let shown = now.map_or_else(String::new, |v| format!(" = {}", check::show(&v)));
            problems.push(format!(
                "{}{shown} and datapath.search = \"windows\" exclude each other: that search {why}, so leave the key out or set datapath.search = \"pyramid\"",
                key.path
            ));
        }
    }
}
