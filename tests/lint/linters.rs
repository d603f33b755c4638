//! Tools that read a whole configuration at once and must have nothing to say.
use super::configs::{Emitted, all, extra, file_count};
use super::no_problems;
use super::tools::{Said, Tool, run};
use crate::budget::share;
use rayon::prelude::*;
use reliefrtl::config::DatapathKind;
use reliefrtl::ir::{SYSTEM_VERILOG, VERILOG};
use std::collections::BTreeSet;
use std::process::Command;

/// Runs a tool over one in so many configurations; the tool must have been given every file of them.
fn silent(tool: Tool, step: usize, arguments: impl Fn(&mut Command, &Emitted) + Sync) {
    let some: Vec<&Emitted> = all().iter().step_by(step).collect();
    of_each_datapath(&some);
    let one = |e: &Emitted| -> Option<(usize, Option<String>)> {
        let mut c = tool.command()?;
        arguments(&mut c, e);
        Some((e.verilog().len(), run(&mut c, &e.dir).unless_silent(&e.label)))
    };
    let Some(said) = some.par_iter().map(|e| one(e)).collect::<Option<Vec<_>>>() else { return };
    no_problems(&said.iter().filter_map(|s| s.1.clone()).collect::<Vec<_>>());
    let checked: usize = said.iter().map(|s| s.0).sum();
    assert_eq!(checked, some.iter().map(|e| e.verilog().len()).sum::<usize>());
    println!("{tool:?}: {checked} files of {} configurations", some.len());
}

/// Whatever is left out, each datapath is read.
fn of_each_datapath(some: &[&Emitted]) {
    for kind in DatapathKind::ALL {
        assert!(some.iter().any(|e| e.config.datapath.kind == kind && e.config.emit.units.is_empty()), "{kind:?}");
    }
}

/// A traversal as a whole; units that it does not have one at a time. (Several tops are no mistake where every unit is one, but Verilator
/// mixes up the widths of a module that several tops have at several parameter values.)
fn verilate(tool: Tool) {
    let one = |(e, top): &(&Emitted, Option<String>)| -> Option<Option<String>> {
        let mut c = tool.command()?;
        match top {
            None => c.arg("-Wno-MULTITOP").args(e.verilog()),
            Some(top) => c.args(["--top-module", top, "-y", "rtl", &format!("rtl/{top}.v")]),
        };
        Some(run(&mut c, &e.dir).unless_silent(&e.label))
    };
    let tops = |e: &'static Emitted| -> Vec<(&Emitted, Option<String>)> {
        match e.config.emit.units.as_slice() {
            [] => vec![(e, None)],
            _ => e.units.iter().map(|m| (e, Some(format!("{}{}", e.config.emit.prefix, m.name)))).collect(),
        }
    };
    // In the usual run the current one is asked about a fifth of the configurations, and Debian's, which knows less, about a ninth, each about the
    // default; neither divides the number of choices of arithmetic.
    let (first, step) = if tool == Tool::Verilator { (7, 9) } else { (0, 5) };
    let asked = |k: usize| k == 0 || share(step) == 1 || k % step == first;
    let some: Vec<&Emitted> = all().iter().enumerate().filter(|(k, _)| asked(*k)).map(|(_, e)| e).collect();
    of_each_datapath(&some);
    let cases: Vec<_> = some.iter().flat_map(|e| tops(e)).collect();
    let Some(said) = cases.par_iter().map(one).collect::<Option<Vec<_>>>() else { return };
    no_problems(&said.into_iter().flatten().collect::<Vec<_>>());
    let labels: std::collections::BTreeSet<&str> = cases.iter().map(|c| c.0.label.as_str()).collect();
    assert_eq!(labels.len(), some.len(), "every configuration was read");
    println!("{tool:?}: {} configurations", some.len());
}

/// Each unit of the default configuration, and each that no traversal needs, once more as the top, at its own default parameters; in the usual run
/// one in so many of them.
fn verilate_each(tool: Tool, step: usize) {
    let e = extra();
    let one = |name: &String| -> Option<Option<String>> {
        let mut c = tool.command()?;
        c.args(["--top-module", name, "-y", "rtl", &format!("rtl/{name}.v")]);
        Some(run(&mut c, &e.dir).unless_silent(name))
    };
    let some: Vec<String> = e.names().into_iter().step_by(step).collect();
    let Some(said) = some.par_iter().map(one).collect::<Option<Vec<_>>>() else { return };
    no_problems(&said.into_iter().flatten().collect::<Vec<_>>());
}

#[test]
fn icarus_compiles_every_module_as_a_top_without_a_warning() {
    silent(Tool::Icarus, share(3), |c, e| {
        for name in e.names() {
            c.args(["-s", &name]);
        }
        c.args(e.verilog());
    });
}

#[test]
fn verilator_has_no_warning() {
    verilate(Tool::Verilator);
    verilate_each(Tool::Verilator, share(3));
}

#[test]
fn the_current_verilator_has_no_warning() {
    verilate(Tool::VerilatorNew);
    verilate_each(Tool::VerilatorNew, share(2));
}

#[test]
fn verible_has_no_finding() {
    silent(Tool::Verible, 1, |c, e| {
        c.args(e.verilog());
    });
}

/// Each text once with all that stands below it; in the usual run those that every fifth configuration brings.
#[test]
fn yosys_reads_every_module_and_finds_no_undriven_or_doubly_driven_net() {
    let one = |e: &Emitted| -> Option<Option<String>> {
        let mut c = Tool::Yosys.command()?;
        // Without a top all modules stay, each at its defaults and at what its users give it.
        let mut script = format!("read_verilog {}\nhierarchy -check\n", e.fresh_files().join(" "));
        script += &e.fresh.iter().map(|name| format!("select -assert-any {name}\n")).collect::<String>();
        script += "select -clear\nproc\ncheck -assert\n";
        std::fs::write(e.dir.join("check.ys"), script).expect("target is writable");
        Some(run(c.arg("check.ys"), &e.dir).unless_silent(&e.label))
    };
    let some: Vec<&Emitted> = all().iter().filter(|e| !e.fresh.is_empty()).step_by(share(5)).collect();
    of_each_datapath(&some);
    let Some(said) = some.par_iter().map(|e| one(e)).collect::<Option<Vec<_>>>() else { return };
    no_problems(&said.into_iter().flatten().collect::<Vec<_>>());
    let texts: usize = some.iter().map(|e| e.fresh.len()).sum();
    println!("{texts} modules of {} configurations", some.len());
    assert!(texts > 600 / share(5) && some.len() > 60 / share(5), "{texts} modules of {} configurations", some.len());
}

/// Each text once, by the current Yosys, which looks for undeclared nets where the older one does not.
#[test]
fn the_current_yosys_reads_every_text() {
    let texts: BTreeSet<&String> =
        all().iter().flat_map(|e| e.files.iter()).filter(|(f, _)| f.ends_with(".v")).map(|(_, text)| text).collect();
    let Some(mut c) = Tool::YosysNew.command() else { return };
    let dir = all()[0].dir.join("texts");
    std::fs::create_dir_all(&dir).expect("target is writable");
    let mut script = String::new();
    for (k, text) in texts.iter().enumerate() {
        std::fs::write(dir.join(format!("{k}.v")), text).expect("target is writable");
        script += &format!("read_verilog {k}.v\ndesign -reset\n");
    }
    assert!(texts.len() > 300, "{} texts", texts.len());
    std::fs::write(dir.join("read.ys"), script).expect("target is writable");
    no_problems(&run(c.arg("read.ys"), &dir).unless_silent("every text").into_iter().collect::<Vec<_>>());
}

/// The words that no name may be are those that slang takes for keywords.
#[test]
fn keywords_are_those_of_slang() {
    let Some(mut c) = Tool::Slang.command() else { return };
    let said = run(c.arg("--keywords"), &all()[0].dir);
    let slangs: BTreeSet<String> = said.text.lines().map(str::to_string).collect();
    let ours: BTreeSet<String> = VERILOG.iter().chain(&SYSTEM_VERILOG).map(|w| w.replace('_', "")).collect();
    assert_eq!(slangs, ours, "{}", said.line);
}

/// slang takes all configurations in one process and says how many modules it elaborated.
#[test]
fn slang_has_no_warning() {
    let Some(mut c) = Tool::Slang.command() else { return };
    c.args(all().iter().map(|e| &e.dir));
    let said: Said = run(&mut c, &all()[0].dir);
    assert!(said.ok, "{}", said.text);
    let modules: usize = said.text.trim().rsplit(' ').next().and_then(|n| n.parse().ok()).unwrap_or_default();
    assert_eq!(modules, file_count(), "{}", said.text);
}
