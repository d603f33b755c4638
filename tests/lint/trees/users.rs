//! A tree beside another and beside a user's own files: prefixes, lists of files, directives.
use super::super::tools::{Tool, run};
use super::{elaborate, text, tree};
use reliefrtl::emit::Files;
use reliefrtl::verilog::SPDX;
use std::collections::BTreeSet;
use std::process::Command;

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
        c.args(["-MAKEFLAGS", "OPT_FAST=-O0 OPT_SLOW=-O0"]);
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
        // What the user said before our file still holds after it.
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
