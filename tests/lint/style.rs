//! Rules of the emitted text that no linter knows (`docs/verilog-style.md`).
use super::configs::{all, file_count};
use super::no_problems;
use reliefrtl::config::DefaultNettype;
use reliefrtl::verilog::SPDX;
use std::path::Path;

/// What is wrong with one file: line number and rule.
fn problems_of(text: &str) -> Vec<(usize, String)> {
    let mut out = Vec::new();
    let mut quiet = false;
    for (i, line) in text.lines().enumerate() {
        let mut say = |rule: &str| out.push((i + 1, format!("{rule}: {line}")));
        let (code, comment) = line.split_once("//").map_or((line, None), |(code, c)| (code, Some(c.trim())));
        let words: Vec<&str> = code.split(|c: char| !(c.is_alphanumeric() || "_$`'".contains(c))).collect();
        if line.len() > 100 {
            say("longer than 100 columns");
        }
        let above =
            i.checked_sub(1).and_then(|k| text.lines().nth(k)).is_some_and(|l| l.trim_start().starts_with("//"));
        if words.contains(&"localparam") && comment.is_none() && !above {
            say("a derived constant without its meaning");
        }
        if line.ends_with(' ') || line.contains('\t') || !line.is_ascii() {
            say("a trailing blank, a tab or a character outside ASCII");
        }
        for forbidden in ["initial", "function", "task", "casex", "casez", "logic", "inout", "integer'", "#"] {
            // A delay line has no reset: in a simulator an unknown index would stay unknown.
            let index = code.trim() == "initial index = {IndexW{1'b0}};";
            // Words of a memory at power-up, where a parameter names their file.
            let words_of_file = code.trim() == "initial $readmemh(MEM_INIT, mem);";
            if words.contains(&forbidden) && !index && !words_of_file {
                say("a word that is not used");
            }
        }
        if words.contains(&"always") && !code.trim_start().starts_with("always @(posedge clk) begin") {
            say("always is for clocked blocks only");
        }
        if ["'x", "'bx", "'hx", "'z", "'bz", "'hz"].iter().any(|x| code.to_lowercase().contains(x)) {
            say("an unknown value");
        }
        let directives =
            ["`default_nettype none", "`ifndef YOSYS", "`default_nettype wire", "`endif", "`timescale 1ns/1ps"];
        if code.contains('`') && !directives.contains(&code.trim_end()) {
            say("a directive that is not default_nettype or the asked timescale");
        }
        // The scoped pair around wires named unused_* is the only pragma.
        match comment {
            Some("verilator lint_off UNUSED") if !quiet && code.trim().is_empty() => quiet = true,
            Some("verilator lint_on UNUSED") if quiet && code.trim().is_empty() => quiet = false,
            Some(c)
                if ["verilator", "synopsys", "synthesis", "verible", "pragma", "slang"].contains(&first_word(c)) =>
            {
                say("a pragma that is not the pair around unused bits")
            }
            _ if quiet && !code.trim_start().starts_with("wire unused_") && !line.starts_with("      ") => {
                say("not an unused_ wire between the pragmas")
            }
            _ if code.contains("unused_") && !quiet => say("an unused_ wire outside the pragmas"),
            _ => {}
        }
        // What Yosys needs to know of a memory is no directive to anybody else.
        if code.replace("(* no_rw_check *)", "").contains("(*") && !code.contains("@(*)") {
            say("an attribute");
        }
    }
    if quiet {
        out.push((text.lines().count(), "lint_off without lint_on".into()));
    }
    out
}

fn first_word(comment: &str) -> &str {
    comment.split_whitespace().next().unwrap_or_default()
}

/// Names of this machine that a careless banner could hold.
fn local_names() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).display().to_string();
    let variables = ["HOME", "HOSTNAME", "USER", "TMPDIR"].iter().filter_map(|v| std::env::var(v).ok());
    let host = std::fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default().trim().to_owned();
    variables.chain([root, host]).filter(|n| n.len() > 4).collect()
}

#[test]
fn emitted_text_follows_the_rules_of_style() {
    let local = local_names();
    let mut problems = Vec::new();
    let mut checked = 0;
    for e in all() {
        for path in e.verilog() {
            let text = &e.files[path];
            checked += 1;
            problems.extend(problems_of(text).iter().map(|(n, p)| format!("{}: {path}:{n}: {p}", e.label)));
            let name = path.trim_start_matches("rtl/").trim_end_matches(".v");
            let nets = e.config.emit.default_nettype;
            let once = [
                ("licence and name come first", text.starts_with(&format!("// {SPDX}\n// {name}: "))),
                ("one module a file", text.matches("\nendmodule\n").count() == 1),
                ("module and file have one name", text.contains(&format!("\nmodule {name} "))),
                ("what undeclared nets are after it", text.ends_with(&format!("\nendmodule\n{}", after(nets)))),
                (
                    "what they are in it",
                    text.contains("`default_nettype none\nmodule ") == (nets != DefaultNettype::Keep),
                ),
                ("the asked timescale", text.contains("\n`timescale ") != e.config.emit.timescale.is_empty()),
                ("nothing of another configuration", !text.contains("// Config ")),
                ("no path or name of this machine", !local.iter().any(|n| text.contains(n.as_str()))),
                ("no date", !has_date(text)),
            ];
            problems.extend(once.iter().filter(|(_, ok)| !ok).map(|(p, _)| format!("{}: {path}: {p}", e.label)));
        }
    }
    no_problems(&problems);
    assert_eq!(checked, file_count());
}

/// The directives at the end. Yosys takes the last one of a file for all of it, so there `none` has to be the last.
fn after(nets: DefaultNettype) -> &'static str {
    match nets {
        DefaultNettype::Wire => "`ifndef YOSYS\n`default_nettype wire\n`endif\n",
        DefaultNettype::None | DefaultNettype::Keep => "",
    }
}

/// Four digits, a separator, two digits: a year and a month; or two colons between digits: a time.
fn has_date(text: &str) -> bool {
    let digits = |s: &[u8]| s.iter().all(u8::is_ascii_digit);
    text.as_bytes().windows(8).any(|w| {
        (w[0] == b'2' && w[1] == b'0' && digits(&w[..4]) && b"-/".contains(&w[4]) && digits(&w[5..7]))
            || (digits(&w[..2]) && w[2] == b':' && digits(&w[3..5]) && w[5] == b':' && digits(&w[6..]))
    })
}

#[test]
fn the_rules_find_what_they_are_for() {
    let bad = [
        "  initial x = 0;",
        "  always @* y = x;",
        "  always @(posedge clk or posedge rst) begin",
        "  assign y = 4'bx;",
        "  // verilator lint_off WIDTH",
        "  // verilator lint_on UNUSED",
        "  // synopsys translate_off",
        "  wire unused_0 = &{1'b0, y};",
        "  `include \"x.vh\"",
        "  (* keep *) wire y;",
        "  wire y; ",
        "  localparam integer TimeW = 8;",
    ];
    for line in bad {
        assert!(!problems_of(line).is_empty(), "{line}");
    }
    assert!(!problems_of(&" ".repeat(101)).is_empty());
    assert!(!problems_of("  // verilator lint_off UNUSED\n  wire y;\n  // verilator lint_on UNUSED\n").is_empty());
    assert!(!problems_of("  // verilator lint_off UNUSED\n  wire unused_0 = y;\n").is_empty());
    assert_eq!(
        problems_of("  // verilator lint_off UNUSED\n  wire unused_0 = y;\n  // verilator lint_on UNUSED\n"),
        []
    );
    assert_eq!(
        problems_of("  // bits\n  localparam integer TimeW =\n    8;\n  localparam integer IdxW = 9;  // bits\n"),
        []
    );
    assert!(has_date("2031-04-05 ") && has_date("at 10:11:12 ") && !has_date("addr[2047:1024] 20480"));
}
