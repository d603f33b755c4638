//! The table of units in `docs/units.md` is what the catalogue says: names, clocks, parameters and summaries of every unit of each datapath, and
//! `docs/bilinear.md` adds clocks up right. `RELIEFRTL_REFRESH=1 cargo test --release --test repo unit_table` writes it anew.
use reliefrtl::catalogue::SETTINGS;
use reliefrtl::config::Config;
use reliefrtl::emit;
use reliefrtl::ir::Module;
use reliefrtl::units::traversal::{Traverse, traverse};
use reliefrtl::units::{all, available};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

const REFRESH: &str = "RELIEFRTL_REFRESH=1 cargo test --release --test repo unit_table";
const BEGIN: &str = "<!-- units: written by `RELIEFRTL_REFRESH=1 cargo test --release --test repo unit_table` -->\n";
const END: &str = "<!-- end of units -->\n";

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn config(sets: &str) -> Config {
    let mut c = Config::default();
    sets.split(' ').filter(|set| set.contains('=')).for_each(|set| c.apply_set(set).unwrap());
    c.validate().unwrap();
    c
}

/// A row of the table.
fn row(m: &Module, t: &Traverse, with: &str) -> String {
    let clocks = match m.latency() {
        Some(0) => "-".to_owned(),
        Some(_) if m.name == "delay_line" => "CLOCKS".to_owned(),
        Some(k) => k.to_string(),
        None if m.name == "traverse" => format!("{} + {}n + {}", t.setup, t.slots, t.finish),
        // A handshake takes as long as it is held.
        None => "-".to_owned(),
    };
    let params: Vec<&str> = m.params.iter().map(|p| p.name.as_str()).collect();
    let with = if with.is_empty() { String::new() } else { format!("`{with}`") };
    format!(
        "| `{}` | {clocks} | {} | {} | {with} |\n",
        m.name,
        params.join(" "),
        m.summary.trim_end_matches('.').replace('|', "\\|")
    )
}

/// The units that a setting brings, those of `seen` left out.
fn units(set: &str, seen: &mut BTreeSet<String>) -> Vec<Arc<Module>> {
    let d = config(set).design();
    let list = if set == "emit.units" { available(&d) } else { emit::modules(&all(&d)).unwrap() };
    list.into_iter().filter(|m| seen.insert(m.name.clone())).collect()
}

const HEAD: &str = "| unit | clocks | parameters | what it does | only with |\n| --- | --- | --- | --- | --- |\n";

/// The other datapaths, by what asks for them.
const OTHERS: [&str; 4] = [
    "datapath.kind=published",
    "datapath.kind=fixed",
    "datapath.kind=fixed fetch.cells=4",
    "datapath.kind=fixed datapath.search=windows",
];

/// The watertight units with what settings add, and for each other datapath the units that are not the same there.
fn table() -> String {
    let mut out = watertight();
    for sets in OTHERS {
        let d = config(sets).design();
        let t = traverse(&d);
        let rows = emit::modules(&all(&d)).unwrap().into_iter().map(|m| row(&m, &t, ""));
        let own: String = rows.filter(|row| !out.contains(row)).collect();
        out += &format!("\nWith `{}`, these besides or instead:\n\n{HEAD}{own}", sets.replace(' ', "` and `"));
    }
    out
}

fn watertight() -> String {
    let t = traverse(&Config::default().design());
    let mut out = HEAD.to_owned();
    let mut seen = BTreeSet::new();
    for with in [""].into_iter().chain(SETTINGS) {
        let list = units(with, &mut seen);
        list.iter().for_each(|m| out += &row(m, &t, with));
    }
    out
}

#[test]
fn the_page_of_units_lists_them() {
    let file = path("docs/units.md");
    let text = std::fs::read_to_string(&file).unwrap();
    let (before, rest) = text.split_once(BEGIN).expect("docs/units.md marks where the table begins");
    let (there, after) = rest.split_once(END).expect("docs/units.md marks where the table ends");
    let table = table();
    if std::env::var_os("RELIEFRTL_REFRESH").is_some() {
        std::fs::write(&file, format!("{before}{BEGIN}{table}{END}{after}")).unwrap();
        return;
    }
    let differs = table.lines().zip(there.lines()).find(|(a, b)| a != b);
    assert!(table == there, "the table of docs/units.md has drifted: refresh it with `{REFRESH}`; first: {differs:?}");
    // The rows come from the modules: what `level_decision` has is there to the last parameter.
    let decision = all(&Config::default().design()).into_iter().find(|m| m.name == "level_decision").unwrap();
    let row = there.lines().find(|l| l.starts_with("| `level_decision`")).unwrap();
    assert!(decision.params.len() > 2 && decision.params.iter().all(|p| row.contains(&p.name)), "{row}");
}

/// A sum of latencies, as "2 mul + from_int + 1".
fn clocks(sum: &str) -> u32 {
    let latency = serde_json::to_value(Config::default().latency).unwrap();
    let term = |text: &str| match text.trim().split_once(' ') {
        Some((n, key)) => n.parse::<u32>().unwrap() * latency[key].as_u64().unwrap() as u32,
        None => text.trim().parse().unwrap_or_else(|_| latency[text.trim()].as_u64().unwrap() as u32),
    };
    sum.split('+').map(term).sum()
}

#[test]
fn the_refinement_takes_the_clocks_that_its_page_says() {
    let text = std::fs::read_to_string(path("docs/bilinear.md")).unwrap();
    let modules = all(&config("mode.bilinear=true").design());
    let plain: BTreeSet<String> = all(&Config::default().design()).iter().map(|m| m.name.clone()).collect();
    let rows =
        text.lines().skip_while(|l| !l.starts_with("| unit | clocks |")).skip(2).take_while(|l| l.starts_with('|'));
    let mut listed = BTreeSet::new();
    for line in rows {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let name = cells[1].trim_matches('`');
        let m =
            modules.iter().find(|m| m.name == name).unwrap_or_else(|| panic!("{name} is no unit of the refinement"));
        let said = match cells[2] {
            "-" => 0,
            // The whole: its number alone.
            all if all.contains(':') => all.rsplit(' ').next().unwrap().parse().unwrap(),
            sum => clocks(sum),
        };
        assert_eq!(Some(said), m.latency(), "docs/bilinear.md, {name}: {}", cells[2]);
        listed.insert(name.to_owned());
    }
    let mine: BTreeSet<String> = modules.iter().map(|m| m.name.clone()).filter(|n| !plain.contains(n)).collect();
    assert_eq!(listed, mine, "docs/bilinear.md lists other units than the refinement has");
}
