//! The emitted benches are read and linted as the modules are.
use super::configs::{EXTRA, Emitted, all};
use super::no_problems;
use super::tools::{Tool, run};
use crate::budget::share;
use rayon::prelude::*;
use reliefrtl::bench::bench_files;
use reliefrtl::catalogue;
use reliefrtl::units::traversal::traverse;
use std::collections::BTreeSet;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Configurations whose benches differ in more than widths.
const CHOSEN: [&str; 9] = [
    "default",
    "emit.prefix=pdm_",
    "emit.timescale=1ns/1ps emit.default_nettype=none",
    "format.exp=8 format.man=23",
    "mode.trim=always mode.lod=true",
    "mode.bilinear=true",
    "datapath.kind=published",
    "datapath.kind=fixed",
    "emit.counters=none",
];

/// Writes the benches of a configuration beside its modules; returns the benches and their tops.
fn benches(e: &Emitted) -> (Vec<String>, Vec<String>) {
    let d = e.config.design();
    let t = traverse(&d);
    let files = bench_files(&catalogue::units(&d), Some((&d, &t)), &e.config.emit);
    // Tests of one program that run side by side share the trees: a file that a tool may be reading is not written again.
    static WRITING: Mutex<()> = Mutex::new(());
    let writing = WRITING.lock().expect("files were written");
    std::fs::create_dir_all(e.dir.join("testbench")).expect("target is writable");
    for (path, text) in &files {
        let place = e.dir.join(path);
        if std::fs::read_to_string(&place).is_ok_and(|there| there == *text) {
            continue;
        }
        std::fs::write(place, text).expect("target is writable");
    }
    drop(writing);
    let all: Vec<String> = files.into_keys().filter(|f| f.ends_with(".v")).collect();
    assert!(all.len() > 30, "{} files", all.len());
    all.into_iter().partition(|f| !f.ends_with("_top.v"))
}

/// Digest of a bench, of its unit, and of all that stands below that.
fn reads(e: &Emitted, top: &str) -> blake3::Hash {
    let (bench, own_clock) = top.strip_suffix("_top").map_or((top, false), |bench| (bench, true));
    let unit = bench.strip_prefix(&format!("{}tb_", e.config.emit.prefix)).expect("a bench's name");
    let m = e.modules.iter().find(|m| m.name == unit).expect("the bench of a module");
    let mut hash = blake3::Hasher::new();
    for name in [bench, top].iter().take(1 + usize::from(own_clock)) {
        hash.update(&std::fs::read(e.dir.join(format!("testbench/{name}.v"))).expect("a bench"));
    }
    hash.update(e.closure(m).as_bytes());
    hash.finalize()
}

/// What `problems` finds in the benches of each chosen configuration must be nothing.
fn none_of(problems: impl Fn(&Emitted, &[String], &[String]) -> Vec<String>) {
    let extra = EXTRA.join(" ");
    let is_chosen = |e: &&Emitted| e.label == extra || CHOSEN.contains(&e.label.as_str());
    let chosen: Vec<&Emitted> = all().iter().filter(is_chosen).collect();
    assert_eq!(chosen.len(), CHOSEN.len() + 1, "a configuration was renamed");
    let found: Vec<String> = chosen
        .into_iter()
        .flat_map(|e| {
            let (benches, tops) = benches(e);
            problems(e, &benches, &tops)
        })
        .collect();
    no_problems(&found);
}

/// The commands must have nothing to say.
fn silent(arguments: impl Fn(&Emitted, &[String], &[String]) -> Vec<Command>) {
    none_of(|e, benches, tops| {
        let commands = arguments(e, benches, tops);
        commands.into_par_iter().filter_map(|mut c| run(&mut c, &e.dir).unless_silent(&e.label)).collect()
    });
}

/// Each bench as the top, with the look into the loop; and each with its own clock; a text that an earlier configuration has, with the same unit,
/// once. (One at a time: 5.006 mixes up the widths of a module that several tops have at several parameter values.)
fn verilate(tool: Tool) {
    let (seen, turn) = (Mutex::new(BTreeSet::new()), AtomicUsize::new(0));
    silent(|e, benches, tops| {
        let each = |flag: &'static str| {
            let seen = &seen;
            move |file: &String| {
                let mut c = tool.command()?;
                let top = file.strip_prefix("testbench/").and_then(|f| f.strip_suffix(".v")).expect("a bench's path");
                if !seen.lock().expect("a list").insert((*reads(e, top).as_bytes(), flag)) {
                    return None;
                }
                c.args([flag, "--top-module", top, "-y", "rtl", "-y", "testbench", file]);
                Some(c)
            }
        };
        // Both are asked about some, of each configuration about others; Debian's Verilator, which knows less, about fewer.
        let step = if tool == Tool::Verilator { share(6) } else { share(2) };
        let first = turn.fetch_add(1, Ordering::Relaxed) % step;
        let benches = benches.iter().skip(first).step_by(step).filter_map(each("-DITERATIONS"));
        benches.chain(tops.iter().skip(first).step_by(step).filter_map(each("--timing"))).collect()
    });
}

#[test]
fn verilator_has_no_warning_of_a_bench() {
    verilate(Tool::Verilator);
}

#[test]
fn the_current_verilator_has_no_warning_of_a_bench() {
    verilate(Tool::VerilatorNew);
}

#[test]
fn icarus_has_no_warning_of_a_bench() {
    silent(|e, benches, tops| {
        let Some(mut c) = Tool::Icarus.command() else { return Vec::new() };
        let name = |f: &String| f.rsplit('/').next().and_then(|n| n.strip_suffix(".v")).map(str::to_owned);
        for top in tops.iter().filter_map(name) {
            c.args(["-s", &top]);
        }
        c.arg("-DITERATIONS").args(e.verilog()).args(benches).args(tops);
        vec![c]
    });
}

#[test]
fn verible_has_no_finding_in_a_bench() {
    silent(|_, benches, tops| {
        let Some(mut c) = Tool::Verible.command() else { return Vec::new() };
        c.args(benches).args(tops);
        vec![c]
    });
}

/// slang says how many tops it elaborated: every bench, with and without its own clock.
#[test]
fn slang_has_no_warning_of_a_bench() {
    none_of(|e, benches, tops| {
        let Some(mut c) = Tool::Slang.command() else { return Vec::new() };
        c.args(["--benches", "."]);
        let said = run(&mut c, &e.dir);
        let expected = format!("modules elaborated without a warning: {}", benches.len() + tops.len());
        (said.text.trim() != expected).then(|| format!("{}: {}", e.label, said.text)).into_iter().collect()
    });
}
