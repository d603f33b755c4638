//! What a bench found reaches whoever started it: one wrong nibble in an expected row, and the status is not 0; with the right row it is.
use crate::simulators::skip;
use reliefrtl::config::Config;
use reliefrtl::project::{Scene, project};
use std::path::Path;
use std::process::{Command, Output};

fn run(dir: &Path, program: &str, args: &[&str]) -> Output {
    Command::new(program).args(args).current_dir(dir).output().unwrap_or_else(|e| panic!("{program}: {e}"))
}

fn built(dir: &Path, program: &str, args: &[&str]) {
    let out = run(dir, program, args);
    let said = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    assert!(out.status.success(), "{program} {args:?}: {said}");
}

/// A tree with the vectors of `fp_lt`, and the same with one nibble of the last expected row changed under `bad`.
fn tree(dir: &Path) -> String {
    let mut c = Config::default();
    (c.vectors.arithmetic, c.vectors.rays, c.traverse.levels) = (200, 5, 3);
    c.vectors.planned = false;
    let prefix = c.emit.prefix.clone();
    let files = project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files;
    let put = |path: &str, text: &str| {
        let place = dir.join(path);
        std::fs::create_dir_all(place.parent().unwrap()).unwrap();
        std::fs::write(place, text).unwrap();
    };
    files.iter().filter(|f| f.0.ends_with(".v") || f.0.ends_with(".cpp")).for_each(|(p, t)| put(p, t));
    for name in ["stimulus.hex", "expected.hex"] {
        let text = &files[&format!("golden/fp_lt/{name}")];
        put(&format!("golden/fp_lt/{name}"), text);
        let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
        if name == "expected.hex" {
            let last = lines.last_mut().unwrap();
            *last = if last == "0" { "1".into() } else { "0".into() };
        }
        put(&format!("bad/{name}"), &(lines.join("\n") + "\n"));
    }
    prefix
}

/// Statuses of a program with the good vectors and with the bad ones.
fn statuses(dir: &Path, program: &str, args: &[&str]) -> [Option<i32>; 2] {
    ["golden/fp_lt", "bad"].map(|vectors| {
        let plus = format!("+vectors={vectors}");
        run(dir, program, &[args, &[&plus]].concat()).status.code()
    })
}

#[test]
fn a_wrong_nibble_ends_icarus_with_the_code() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let prefix = tree(dir.path());
    let (tb, top) = (format!("testbench/{prefix}tb_fp_lt.v"), format!("{prefix}tb_fp_lt_top"));
    let top_file = format!("testbench/{top}.v");
    built(dir.path(), "iverilog", &["-g2005", "-y", "rtl", "-s", &top, "-o", "tb.vvp", &tb, &top_file]);
    assert_eq!(statuses(dir.path(), "vvp", &["-n", "tb.vvp"]), [Some(0), Some(1)]);
    let nothing = run(dir.path(), "vvp", &["-n", "tb.vvp", "+vectors=nowhere"]);
    assert_eq!(nothing.status.code(), Some(2), "no vectors");
}

/// With the emitted `main` the status is the code; made by Verilator alone (`--binary`) the program ends itself, which is not 0 either.
#[test]
fn a_wrong_nibble_ends_verilator_with_a_status() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let prefix = tree(dir.path());
    let (tb, top) = (format!("testbench/{prefix}tb_fp_lt.v"), format!("{prefix}tb_fp_lt_top"));
    let top_file = format!("testbench/{top}.v");
    let name = format!("{prefix}tb_fp_lt");
    let common = ["--build", "-Wno-lint", "-MAKEFLAGS", "OPT_FAST=-O0", "-MAKEFLAGS", "OPT_SLOW=-O0", "-y", "rtl"];
    let own = ["--cc", "--exe", "--prefix", "Vtb", "--Mdir", "own", "--top-module", &name, &tb];
    built(dir.path(), "verilator", &[&common[..], &own, &["testbench/verilator_main.cpp"]].concat());
    assert_eq!(statuses(dir.path(), "own/Vtb", &[]), [Some(0), Some(1)]);
    let alone = ["--binary", "--timing", "--prefix", "Vtop", "--Mdir", "alone", "--top-module", &top, &tb, &top_file];
    built(dir.path(), "verilator", &[&common[..], &alone].concat());
    let [good, bad] = statuses(dir.path(), "alone/Vtop", &[]);
    assert_eq!(good, Some(0));
    // Verilator aborts: a signal, which has no code.
    assert_ne!(bad, Some(0));
    let said = run(dir.path(), "alone/Vtop", &["+vectors=bad"]);
    let said = String::from_utf8_lossy(&said.stdout).into_owned() + &String::from_utf8_lossy(&said.stderr);
    assert!(said.contains("exit code 1"), "{said}");
}

/// A core file as it would be written for FuseSoC, for Icarus and for Verilator.
fn core(prefix: &str) -> String {
    format!(
        "CAPI=2:
name: ::tree:0
filesets:
  bench:
    file_type: verilogSource
    files: [rtl/{prefix}fp_lt.v, testbench/{prefix}tb_fp_lt.v]
  clock:
    file_type: verilogSource
    files: [testbench/{prefix}tb_fp_lt_top.v]
  main:
    file_type: cppSource
    files: [testbench/verilator_main.cpp]
targets:
  icarus:
    filesets: [bench, clock]
    default_tool: icarus
    toplevel: {prefix}tb_fp_lt_top
    parameters: [vectors]
  verilator:
    filesets: [bench, main]
    default_tool: verilator
    tools:
      verilator:
        mode: cc
        verilator_options: [-Wno-lint, -CFLAGS, -DVTOP=V{prefix}tb_fp_lt]
        make_options: [OPT_FAST=-O0, OPT_SLOW=-O0]
    toplevel: {prefix}tb_fp_lt
    parameters: [vectors]
parameters:
  vectors: {{datatype: str, paramtype: plusarg}}
"
    )
}

fn a_wrong_nibble_ends_fusesoc(target: &str) {
    let Some(tools) = std::env::var_os("RELIEFRTL_TOOLS").map(std::path::PathBuf::from) else {
        println!("skipped: RELIEFRTL_TOOLS is not set (sh tools/test.sh sets it)");
        return;
    };
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let prefix = tree(dir.path());
    std::fs::write(dir.path().join("tree.core"), core(&prefix)).unwrap();
    let fusesoc = tools.join("bin/fusesoc").display().to_string();
    let status = |vectors: &str| {
        let place = dir.path().join(vectors).display().to_string();
        let target = format!("--target={target}");
        let line = ["--cores-root", ".", "run", &target, "::tree:0", "--vectors", &place];
        let mut c = Command::new(&fusesoc);
        // As for Verilator elsewhere: it finds its own files by itself.
        let out = c.env_remove("VERILATOR_ROOT").args(line).current_dir(dir.path()).output().unwrap();
        let said = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
        (out.status.code(), said)
    };
    let (good, said) = status("golden/fp_lt");
    assert!(good == Some(0) && said.contains("PASS"), "{said}");
    let (bad, said) = status("bad");
    assert!(bad.is_some_and(|c| c != 0) && said.contains("FAIL"), "{said}");
}

#[test]
fn a_wrong_nibble_ends_fusesoc_with_a_status() {
    a_wrong_nibble_ends_fusesoc("icarus");
}

#[test]
fn a_wrong_nibble_ends_verilator_in_fusesoc_with_a_status() {
    a_wrong_nibble_ends_fusesoc("verilator");
}
