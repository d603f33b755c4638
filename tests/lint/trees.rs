//! Emitted trees beside each other and beside a user's own files: what differs ends elaboration by its name, what has another prefix doesn't
//! meet, lists of files hold from anywhere, and no directive leaks.
use super::configs::all;
use super::no_problems;
use super::tools::{Said, Tool, run};
use reliefrtl::config::Config;
use reliefrtl::emit::{self, Files};
use reliefrtl::ir::Module;
use reliefrtl::project;
use reliefrtl::units;
use reliefrtl::verilog::SPDX;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

fn config(sets: &[&str]) -> Config {
    let mut c = Config::default();
    sets.iter().for_each(|s| c.apply_set(s).unwrap_or_else(|e| panic!("{s}: {e}")));
    c.validate().unwrap_or_else(|e| panic!("{sets:?}: {e}"));
    c
}

fn text(sets: &[&str]) -> Files {
    project::text(&config(sets)).unwrap_or_else(|e| panic!("{sets:?}: {e}")).files
}

fn modules(sets: &[&str]) -> Vec<Arc<Module>> {
    emit::modules(&units::all(&config(sets).design())).expect("legal")
}

/// A directory of this test's own with these files.
fn tree(name: &str, files: &Files) -> PathBuf {
    let dir = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("trees").join(name);
    let _ = std::fs::remove_dir_all(&dir);
    for (path, text) in files {
        let place = dir.join(path);
        std::fs::create_dir_all(place.parent().expect("a folder")).expect("target is writable");
        std::fs::write(place, text).expect("target is writable");
    }
    dir
}

/// Elaborates `top` of the Verilog files given, at its default parameters.
fn elaborate(tool: Tool, dir: &Path, top: &str, files: &[&str]) -> Option<Said> {
    let mut c = tool.command()?;
    match tool {
        Tool::Icarus => drop(c.args(["-s", top]).args(files)),
        Tool::Verilator | Tool::VerilatorNew => drop(c.args(["-Wno-lint", "--top-module", top]).args(files)),
        Tool::Slang => drop(c.args(["--words", "--top", top]).args(files)),
        Tool::Yosys | Tool::YosysNew => {
            let script = format!("read_verilog -formal {}; hierarchy -check -top {top}", files.join(" "));
            c.args(["-p", &script]);
        }
        Tool::Verible | Tool::SlangInterfaces => panic!("{tool:?} elaborates nothing"),
    }
    Some(run(&mut c, dir))
}

const ELABORATE: [Tool; 5] = [Tool::Icarus, Tool::Verilator, Tool::VerilatorNew, Tool::Yosys, Tool::Slang];

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
        let was = |m: &Arc<Module>| old.iter().find(|o| o.name == m.name).and_then(|o| o.latency);
        let may: BTreeSet<String> = new
            .iter()
            .filter(|m| holds(m) || m.latency != was(m))
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

/// Two configurations with prefixes of their own, benches and proofs included, in one elaboration.
#[test]
fn two_prefixes_elaborate_together() {
    let a = text(&["emit.prefix=a_"]);
    let b = text(&["emit.prefix=b_", "latency.add=7", "mode.level_up=always", "mode.trim=always", "mode.lod=true"]);
    let both: Files = a.iter().chain(&b).map(|(k, v)| (k.clone(), v.clone())).collect();
    let named = |files: &Files, start: &str, end: &str| -> Vec<String> {
        files.keys().filter(|f| f.starts_with(start) && f.ends_with(end)).cloned().collect()
    };
    let mut rtl = named(&both, "rtl/", ".v");
    assert_eq!(rtl.len(), named(&a, "rtl/", ".v").len() + named(&b, "rtl/", ".v").len(), "a name was taken twice");
    let stem = |f: &String| f.trim_start_matches("testbench/").trim_end_matches(".v").to_string();
    let benches: Vec<String> = named(&both, "testbench/", ".v").into_iter().filter(|f| f.contains("_tb_")).collect();
    let units: Vec<String> = benches.iter().map(stem).filter(|s| !s.ends_with("_top")).collect();
    let list: String = units.iter().enumerate().fold(String::new(), |s, (k, unit)| {
        s + &format!("  wire done_{k};\n  wire [7:0] code_{k};\n  {unit} bench_{k} (.clk(clk), .done(done_{k}), .exit_code(code_{k}));\n")
    });
    let mut files = both.clone();
    files.insert("both.v".into(), format!("module both (input wire clk);\n{list}endmodule\n"));
    let dir = tree("both", &files);
    let read: Vec<&str> = rtl.iter().chain(&benches).map(String::as_str).chain(["both.v"]).collect();
    for tool in [Tool::Icarus, Tool::Verilator, Tool::VerilatorNew, Tool::Slang] {
        let Some(said) = elaborate(tool, &dir, "both", &read) else { return };
        assert!(said.ok, "{}", said.problem("two prefixes"));
    }
    // Yosys takes proofs, too; of benches it reads what they test and with which parameters.
    let proofs: Vec<String> = named(&both, "testbench/", ".v").into_iter().filter(|f| f.contains("_fv_")).collect();
    rtl.extend(proofs.iter().chain(&benches).cloned());
    let tops: Vec<String> =
        proofs.iter().map(stem).chain(["a_tb_traverse_top", "b_tb_traverse_top", "both"].map(String::from)).collect();
    for (tool, tops) in [(Tool::Yosys, &tops[..]), (Tool::YosysNew, &tops[tops.len() - 1..])] {
        let mut script = format!("read_verilog -formal {} both.v\ndesign -save read\n", rtl.join(" "));
        for top in tops {
            script += &format!("design -load read\nhierarchy -check -top {top}\n");
        }
        std::fs::write(dir.join("both.ys"), script).expect("target is writable");
        let Some(mut c) = tool.command() else { return };
        let said = run(c.arg("both.ys"), &dir);
        assert!(said.ok, "{}", said.problem("two prefixes"));
    }
    // And a bench holds its unit to what it was written for there as well.
    let swapped = both["testbench/a_tb_fp_add.v"].replace(".LATENCY(3)", ".LATENCY(9)");
    assert_ne!(swapped, both["testbench/a_tb_fp_add.v"]);
    std::fs::write(dir.join("testbench/a_tb_fp_add.v"), swapped).expect("target is writable");
    let read = ["rtl/a_lzc.v", "rtl/a_fp_add.v", "testbench/a_tb_fp_add.v", "testbench/a_tb_fp_add_top.v"];
    for tool in [Tool::Yosys, Tool::YosysNew] {
        let Some(said) = elaborate(tool, &dir, "a_tb_fp_add_top", &read) else { return };
        assert!(
            !said.ok && said.text.contains("a_fp_add_has_LATENCY_3_not_the_one_asked_for"),
            "{}",
            said.problem("swapped")
        );
    }
}

/// The lists name files from where they stand themselves.
#[test]
fn lists_of_files_hold_from_another_directory() {
    let files = text(&[]);
    let dir = tree("lists", &files);
    let away = tree("lists-away", &Files::from([("here/nothing".into(), String::new())])).join("here");
    for (list, top) in [
        ("rtl/relief_all.f", "relief_traverse"),
        ("rtl/relief_fp_add.f", "relief_fp_add"),
        ("testbench/relief_tb_fp_add.f", "relief_tb_fp_add"),
        ("testbench/relief_tb_traverse.f", "relief_tb_traverse"),
    ] {
        let path = dir.join(list);
        for tool in [Tool::Verilator, Tool::VerilatorNew, Tool::Slang] {
            let Some(mut c) = tool.command() else { return };
            match tool {
                Tool::Slang => c.args(["--words", "--top", top, "-F"]),
                _ => c.args(["-Wno-lint", "--top-module", top, "-F"]),
            };
            let said = run(c.arg(&path), &away);
            assert!(said.ok, "{}", said.problem(list));
        }
        // Icarus reads a list's names from its own working directory.
        let Some(mut c) = Tool::Icarus.command() else { return };
        let folder = path.parent().expect("a folder");
        let said = run(c.args(["-s", top, "-c", path.file_name().and_then(|n| n.to_str()).expect("a name")]), folder);
        assert!(said.ok && said.text.is_empty(), "{}", said.problem(list));
    }
    // A list holds what its unit needs and no more.
    assert_eq!(files["rtl/relief_fp_add.f"], "relief_lzc.v\nrelief_fp_add.v\n");
    let all: BTreeSet<&str> = files["rtl/relief_all.f"].lines().collect();
    let verilog: BTreeSet<&str> =
        files.keys().filter_map(|f| f.strip_prefix("rtl/")).filter(|f| f.ends_with(".v")).collect();
    assert_eq!(all, verilog);
}

/// The C++ that clocks a bench takes the class by whatever name Verilator gave it.
#[test]
fn the_main_program_takes_any_class() {
    if Tool::Verilator.command().is_none() {
        return;
    }
    let dir = tree("main", &text(&[]));
    for (class, options) in
        [("Vrelief_tb_lzc", &["-CFLAGS", "-DVTOP=Vrelief_tb_lzc"][..]), ("Vtb", &["--prefix", "Vtb"])]
    {
        let mut c = Command::new("/usr/bin/verilator");
        c.env_remove("VERILATOR_ROOT").args(["--cc", "--exe", "--build", "-Wno-lint", "--Mdir", class]);
        c.args(["-MAKEFLAGS", "OPT_FAST=-O0 OPT_SLOW=-O0 OPT_GLOBAL=-O0"]);
        c.args(["--top-module", "relief_tb_lzc"]).args(options);
        c.args(["-F", "testbench/relief_tb_lzc.f", "testbench/verilator_main.cpp"]);
        let said = run(&mut c, &dir);
        assert!(said.ok, "{}", said.problem(class));
        let said = run(&mut Command::new(dir.join(class).join(class)), &dir);
        // Without vectors nothing runs, which the bench says itself.
        assert!(!said.ok && said.text.contains("FAIL tb_lzc: "), "{}", said.problem(class));
    }
}

const USER: &str = "`timescale 1ns/1ps\nmodule user (input wire clk, output wire [7:0] count);\n  wire [3:0] n;\n  \
    relief_lzc #(.W(8)) u_lzc (.bits({7'd0, clk}), .count(n));\n  assign count = {4'd0, n};\nendmodule\n";

/// A user whose files have a time scale sets the same for ours, and no tool has anything to say.
#[test]
fn a_users_timescale_is_taken_up() {
    for (sets, clean) in [(&["emit.timescale=1ns/1ps"][..], true), (&["emit.timescale=10ns/100ps"], true), (&[], false)]
    {
        let mut files = text(sets);
        files.insert("user.v".into(), USER.into());
        let dir = tree("timescale", &files);
        for tool in [Tool::Icarus, Tool::Verilator, Tool::VerilatorNew] {
            let Some(mut c) = tool.command() else { return };
            match tool {
                Tool::Icarus => c.args(["-s", "user"]),
                _ => c.args(["-Wno-DECLFILENAME", "--top-module", "user"]),
            };
            let said = run(c.args(["user.v", "-y", "rtl"]), &dir);
            assert_eq!(said.ok && said.text.is_empty(), clean, "{}", said.problem(&format!("{sets:?}")));
        }
    }
}

/// `count` is misspelt in ours; the user's own file leaves a net undeclared.
#[test]
fn a_misspelt_net_of_ours_is_an_error_and_a_users_default_stays() {
    const IMPLICIT: &str =
        "module implicit (input wire a, output wire y);\n  assign q = a;\n  assign y = q;\nendmodule\n";
    for (nets, before, found, user) in [
        ("wire", "", true, true),
        ("none", "", true, false),
        // What the user said before our file still holds behind it.
        ("keep", "`default_nettype none\n", true, false),
        ("keep", "", false, true),
    ] {
        let files = text(&[&format!("emit.default_nettype={nets}")]);
        let ours = files["rtl/relief_lzc.v"].clone();
        let spoiled = ours.replacen("assign count =", "assign cuont =", 1);
        assert_ne!(ours, spoiled);
        let files = Files::from([
            ("before.v".to_string(), before.to_string()),
            ("relief_lzc.v".into(), ours),
            ("implicit.v".into(), IMPLICIT.into()),
            ("spoiled.v".into(), spoiled),
        ]);
        let dir = tree("nettype", &files);
        let read = |tool: Tool, top: &str, file: &str| {
            elaborate(
                tool,
                &dir,
                top,
                &if file == "implicit.v" { vec!["before.v", "relief_lzc.v", file] } else { vec!["before.v", file] },
            )
        };
        for tool in [Tool::Icarus, Tool::Yosys] {
            let Some(said) = read(tool, "relief_lzc", "spoiled.v") else { return };
            // Yosys forgets at the end of each file what the one before said.
            let expected = found && !(tool == Tool::Yosys && nets == "keep");
            let noticed = !said.ok;
            assert_eq!(noticed, expected, "{nets}: {}", said.problem("ours"));
            let Some(said) = read(tool, "implicit", "implicit.v") else { return };
            let accepted = said.ok && !said.text.contains("error");
            assert_eq!(accepted, user || tool == Tool::Yosys, "{nets}: {}", said.problem("the user's"));
        }
    }
}

#[test]
fn every_emitted_file_names_its_licence() {
    let files = text(&[]);
    let kinds = ["v", "cpp", "sh", "ys", "tcl", "sdc", "xdc", "lpf", "sby"];
    let of = |f: &str| f.rsplit('.').next().unwrap_or_default().to_string();
    let seen: BTreeSet<String> = files.keys().map(|f| of(f)).filter(|k| kinds.contains(&k.as_str())).collect();
    assert_eq!(seen.len(), kinds.len(), "{seen:?}");
    for (path, text) in files.iter().filter(|(f, _)| kinds.contains(&of(f).as_str())) {
        assert!(text.lines().take(2).any(|l| l.contains(SPDX)), "{path} does not name its licence");
        assert_eq!(text.matches("SPDX-").count(), 1, "{path}");
    }
}
