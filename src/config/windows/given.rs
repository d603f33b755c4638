//! Keys that mean nothing to a search by windows: refused where they are given, ignored where they are defaults.
use crate::keys::{KEYS, Key, stands_in};
use crate::{Config, check};

/// Adds a sentence for each of them that was given, or that is not the default.
pub(crate) fn ignored(c: &Config, problems: &mut Vec<String>) {
    let (Ok(ours), Ok(usual)) = (c.table(), Config::default().table()) else {
        return;
    };
    let value = |table: &toml::Table, key: &Key| {
        let (section, name) = key.split();
        table.get(section)?.as_table()?.get(name).cloned()
    };
    for (what, why) in c.datapath.kind.facts().ignores {
        for key in KEYS.iter().filter(|k| stands_in(k.path, what)) {
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
