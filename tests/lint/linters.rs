//! Tools that read a whole configuration at once and must have nothing to say.
use super::configs::{Emitted, all, extra, file_count};
use super::no_problems;
use super::tools::{Said, Tool, run};
use std::process::Command;

/// Runs a tool over every configuration; the tool must have been given every file.
fn silent(tool: Tool, arguments: impl Fn(&mut Command, &Emitted)) {
    let mut checked = 0;
    let mut problems = Vec::new();
    for e in all() {
        let Some(mut c) = tool.command() else { return };
        arguments(&mut c, e);
        problems.extend(run(&mut c, &e.dir).unless_silent(&e.label));
        checked += e.verilog().len();
    }
    no_problems(&problems);
    assert_eq!(checked, file_count());
    println!("{tool:?}: {checked} files of {} configurations", all().len());
}

/// A traversal as a whole; units that it does not have one at a time. (Several tops are no mistake where every unit is one, but Verilator
/// mixes up the widths of a module that several tops have at several parameter values.)
fn verilate(tool: Tool) {
    let mut problems = Vec::new();
    let mut checked = 0;
    for e in all() {
        let tops: Vec<Option<String>> = match e.config.emit.units.as_slice() {
            [] => vec![None],
            _ => e.units.iter().map(|m| Some(format!("{}{}", e.config.emit.prefix, m.name))).collect(),
        };
        for top in tops {
            let Some(mut c) = tool.command() else { return };
            match &top {
                None => c.arg("-Wno-MULTITOP").args(e.verilog()),
                Some(top) => c.args(["--top-module", top, "-y", "rtl", &format!("rtl/{top}.v")]),
            };
            problems.extend(run(&mut c, &e.dir).unless_silent(&e.label));
        }
        checked += e.verilog().len();
    }
    no_problems(&problems);
    assert_eq!(checked, file_count());
    println!("{tool:?}: {checked} files of {} configurations", all().len());
}

/// Each unit of the default configuration, and each that no traversal needs, once more as the top, at its own default parameters.
fn verilate_each(tool: Tool) {
    let e = extra();
    let mut problems = Vec::new();
    for name in e.names() {
        let Some(mut c) = tool.command() else { return };
        c.args(["--top-module", &name]).args(e.verilog());
        problems.extend(run(&mut c, &e.dir).unless_silent(&name));
    }
    no_problems(&problems);
}

#[test]
fn icarus_compiles_every_module_as_a_top_without_a_warning() {
    silent(Tool::Icarus, |c, e| {
        for name in e.names() {
            c.args(["-s", &name]);
        }
        c.args(e.verilog());
    });
}

#[test]
fn verilator_has_no_warning() {
    verilate(Tool::Verilator);
    verilate_each(Tool::Verilator);
}

#[test]
fn the_current_verilator_has_no_warning() {
    verilate(Tool::VerilatorNew);
    verilate_each(Tool::VerilatorNew);
}

#[test]
fn verible_has_no_finding() {
    silent(Tool::Verible, |c, e| {
        c.args(e.verilog());
    });
}

#[test]
fn yosys_reads_every_module_and_finds_no_undriven_or_doubly_driven_net() {
    silent(Tool::Yosys, |c, e| {
        let mut script = format!("read_verilog {}\ndesign -save read\n", e.verilog().join(" "));
        for name in e.names() {
            script += &format!("design -load read\nhierarchy -check -top {name}\nproc\ncheck -assert\n");
        }
        std::fs::write(e.dir.join("check.ys"), script).expect("target is writable");
        c.arg("check.ys");
    });
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
