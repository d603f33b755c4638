//! Modules, benches and proofs of one tree in another: what differs ends elaboration by its name.
use super::super::configs::all;
use super::super::no_problems;
use super::super::tools::Tool;
use super::{ELABORATE, config, elaborate, modules, text, tree};
use reliefrtl::config::Config;
use reliefrtl::emit::{self, Files};
use reliefrtl::ir::Module;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Units whose clocks a key sets.
const LATENCIES: [(&str, &[&str]); 6] = [
    ("latency.add", &["fp_add"]),
    ("latency.mul", &["fp_mul"]),
    ("latency.div", &["fp_div"]),
    ("latency.compare", &["fp_lt"]),
    ("latency.from_int", &["fp_from_int", "fp_from_fixed"]),
    ("latency.to_int", &["fp_to_int", "fp_to_fixed"]),
];

#[test]
fn a_latency_changes_only_the_files_that_hold_it() {
    let c = Config::default();
    let latencies = serde_json::to_value(&c).expect("plain data")["latency"].clone();
    let (before, old) = (emit::rtl(&c, &modules(&[])), modules(&[]));
    for (key, own) in LATENCIES {
        let clocks = latencies[key.trim_start_matches("latency.")].as_u64().expect("a number of clocks");
        let set = format!("{key}={}", clocks + 1);
        let new = modules(&[&set]);
        let after = emit::rtl(&config(&[&set]), &new);
        let holds = |m: &&Arc<Module>| m.hierarchy().iter().any(|h| own.contains(&h.name.as_str()));
        // What merely waits beside them is longer, too.
        let was = |m: &Arc<Module>| old.iter().find(|o| o.name == m.name).and_then(|o| o.latency());
        let may: BTreeSet<String> = new
            .iter()
            .filter(|m| holds(m) || m.latency() != was(m))
            .map(|m| format!("rtl/relief_{}.v", m.name))
            .collect();
        let changed: BTreeSet<String> = after
            .keys()
            .chain(before.keys())
            .filter(|p| p.ends_with(".v") && before.get(*p) != after.get(*p))
            .cloned()
            .collect();
        let more: Vec<&String> = changed.difference(&may).collect();
        assert!(more.is_empty(), "{set} changes {more:?}");
        for unit in own.iter().filter(|u| new.iter().any(|m| m.name == **u)) {
            assert!(changed.contains(&format!("rtl/relief_{unit}.v")), "{set} leaves {unit} as it is");
        }
        let total = before.keys().filter(|p| p.ends_with(".v")).count();
        assert!(changed.len() + 8 <= total, "{set} changes {} files of {total}", changed.len());
    }
}

/// The code of a file, without what a parameter, the prefix or a directive says, and without blanks: a prefix breaks lines elsewhere.
fn code(text: &str, prefix: &str) -> String {
    let lines = text.lines().map(|l| l.split("//").next().unwrap_or_default());
    let lines = lines.filter(|l| !l.starts_with('`') && !l.starts_with("  parameter integer "));
    let lines = lines.filter(|l| !l.contains("_not_the_one_asked_for"));
    let text: String = lines.flat_map(str::split_whitespace).collect();
    if prefix.is_empty() { text } else { text.replace(prefix, "") }
}

/// What is passed says everything: modules of one name and one contract have one text, whatever the configuration.
#[test]
fn an_equal_contract_is_an_equal_text() {
    let mut known: BTreeMap<(String, String), (String, &str)> = BTreeMap::new();
    let (mut problems, mut names, mut again) = (Vec::new(), BTreeSet::new(), 0);
    for e in all() {
        let prefix = &e.config.emit.prefix;
        for m in &e.modules {
            let text = code(&e.files[&format!("rtl/{prefix}{}.v", m.name)], prefix);
            names.insert(m.name.clone());
            match known.get(&(m.name.clone(), format!("{:?}", m.contract()))) {
                None => drop(known.insert((m.name.clone(), format!("{:?}", m.contract())), (text, &e.label))),
                Some((same, _)) if *same == text => again += 1,
                Some((_, label)) => problems.push(format!("{}: {} and {label} differ", m.name, e.label)),
            }
        }
    }
    no_problems(&problems);
    assert!(
        again > 500 && known.len() > 2 * names.len(),
        "{again} equal texts, {} contracts of {}",
        known.len(),
        names.len()
    );
}

/// Configurations that share all names with the default and differ in what no parameter says.
const OTHERS: [&[&str]; 7] = [
    &["latency.add=7"],
    &["latency.mul=5", "latency.compare=4"],
    &["mode.level_up=always"],
    &["mode.levels_down=3"],
    &["mode.start_level=false"],
    &["latency.decision=5"],
    &["latency.divider=table"],
];

/// Each module of another tree, put into the default one, ends elaboration, and says of itself what it is.
#[test]
fn a_module_of_another_tree_ends_elaboration_by_its_name() {
    let mine = text(&[]);
    let old = modules(&[]);
    let used = |name: &str| old.iter().any(|m| m.insts.iter().any(|i| i.module.name == name));
    let (mut problems, mut refused) = (Vec::new(), 0);
    for (k, sets) in OTHERS.iter().enumerate() {
        let other = emit::rtl(&config(sets), &modules(sets));
        for m in modules(sets).iter().filter(|m| used(&m.name)) {
            let path = format!("rtl/relief_{}.v", m.name);
            if mine.get(&path).is_none_or(|text| *text == other[&path]) {
                continue;
            }
            let mut mixed = mine.clone();
            mixed.insert(path.clone(), other[&path].clone());
            let dir = tree("mixed", &mixed);
            let files: Vec<&str> =
                mixed.keys().filter(|f| f.starts_with("rtl/") && f.ends_with(".v")).map(|f| &**f).collect();
            // All tools for a latency, the fastest for the others.
            let tools = if k == 0 && m.name == "fp_add" { &ELABORATE[..] } else { &ELABORATE[..1] };
            for tool in tools {
                let Some(said) = elaborate(*tool, &dir, "relief_traverse", &files) else { return };
                let named = said.text.contains(&format!("relief_{}_has_", m.name))
                    && said.text.contains("_not_the_one_asked_for");
                // A port that is not there ends elaboration by itself.
                let port = said.text.contains("port") || said.text.contains("pin");
                if said.ok || !(named || port) {
                    problems.push(said.problem(&format!("{sets:?} {}", m.name)));
                }
                if k == 0
                    && m.name == "fp_add"
                    && !said.text.contains("relief_fp_add_has_LATENCY_7_not_the_one_asked_for")
                {
                    problems.push(said.problem("the latency is not said"));
                }
                refused += 1;
            }
        }
    }
    no_problems(&problems);
    assert!(refused > 20, "{refused} mixtures");
}

/// Benches and proofs hold their units to what they were written for.
#[test]
fn a_bench_or_a_proof_of_another_latency_ends_elaboration() {
    let (mine, other) = (text(&[]), text(&["latency.add=7"]));
    let mut mixed = mine.clone();
    let rtl = |files: &Files| -> Vec<String> {
        files.keys().filter(|f| f.starts_with("rtl/") && f.ends_with(".v")).cloned().collect()
    };
    mixed.extend(rtl(&other).into_iter().map(|f| (f.clone(), other[&f].clone())));
    let (dir, whole) = (tree("bench", &mixed), tree("bench-whole", &mine));
    let units = rtl(&mine);
    for (bench, tools, says) in [
        (
            "relief_tb_fp_add",
            &[Tool::Icarus, Tool::Verilator, Tool::VerilatorNew, Tool::Slang][..],
            "relief_fp_add_has_LATENCY_7",
        ),
        (
            "relief_tb_traverse",
            &[Tool::Icarus, Tool::Verilator, Tool::VerilatorNew, Tool::Slang],
            "relief_traverse_has_VARIANT_",
        ),
        ("relief_fv_fp_add", &[Tool::Yosys], "relief_fp_add_has_LATENCY_7"),
        ("relief_fv_traverse", &[Tool::Yosys], "relief_traverse_has_VARIANT_"),
    ] {
        let file = format!("testbench/{bench}.v");
        let files: Vec<&str> = units.iter().map(String::as_str).chain([file.as_str()]).collect();
        for tool in tools {
            let Some(said) = elaborate(*tool, &whole, bench, &files) else { return };
            assert!(said.ok, "{}", said.problem(bench));
            let Some(said) = elaborate(*tool, &dir, bench, &files) else { return };
            assert!(!said.ok && said.text.contains(says), "{}", said.problem(bench));
        }
    }
}
