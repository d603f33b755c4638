//! The command line as a user meets it: sentences, exit codes, nothing half-written, equal bytes from the engines.
use std::path::Path;
use std::process::{Command, Output};

fn run(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(args).current_dir(dir).output().unwrap()
}

fn refused(args: &[&str], sentence: &str) {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("broken.png"), b"\x89PNG\r\n\x1a\nnot a png").unwrap();
    std::fs::write(dir.path().join("miss.csv"), "u,v,du\n0,0,0\n").unwrap();
    std::fs::write(dir.path().join("let.csv"), "u,v,du,dv\n0,x,0,0\n").unwrap();
    let out = run(dir.path(), args);
    let text = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(2), "{args:?}: {text}");
    assert!(text.contains(sentence), "{args:?}: {text}");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 3, "{args:?} left files behind");
}

#[test]
fn bad_input_gets_one_sentence() {
    refused(&["build", "--map", "broken.png"], "broken.png: not a readable PNG");
    refused(&["build", "--set", "format.expp=3"], "unknown key format.expp (--set): did you mean format.exp?");
    refused(&["build", "--set", "format.exp=1"], "format.exp = 1 is too small: 2 to 8 are legal");
    refused(&["build", "--set", "traverse.levels=13"], "traverse.levels = 13 is too large: 2 to 12 are legal");
    refused(&["trace", "--rays", "miss.csv", "--out", "h.csv"], "no column dv");
    refused(&["trace", "--rays", "let.csv", "--out", "h.csv"], "column v: \"x\" is not a number");
    refused(&["emit", "--unit", "traverze"], "did you mean traverse?");
    refused(&["render", "--view", "side"], "none of front, oblique, grazing");
}

#[test]
fn build_says_what_it_did() {
    let dir = tempfile::tempdir().unwrap();
    let out = run(
        dir.path(),
        &["build", "--set", "vectors.arithmetic=100", "--set", "vectors.rays=20", "--set", "view.stride=16"],
    );
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    for part in ["a loop of 8 slots", "traverse         0 of 60 mismatched", "oblique", "iverilog -g2005"] {
        assert!(text.contains(part), "{part} is missing in:\n{text}");
    }
    for file in [
        "rtl/traverse.v",
        "rtl/filelist.f",
        "testbench/tb_traverse.v",
        "golden/fp_add/vectors.json",
        "manifest.json",
        "preview.png",
    ] {
        assert!(dir.path().join("out").join(file).is_file(), "{file}");
    }
}

#[test]
fn engines_write_the_same_bytes() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(
        dir.path().join("r.csv"),
        "u,v,du,dv\n0.1,0.2,0.3,-0.4\n0.99999999,0.5,-1.5,0.25\n0.5,0.5,0,0\n0.3,0.3,20,0\n",
    )
    .unwrap();
    let mut engines = vec!["golden", "interp"];
    if !std::env::var("RELIEFRTL_NO_SIMULATORS").is_ok_and(|v| v == "1") {
        engines.extend(["icarus", "verilator"]);
    }
    let mut all = Vec::new();
    for e in &engines {
        let out = run(dir.path(), &["trace", "--rays", "r.csv", "--engine", e, "--out", "h.csv"]);
        assert_eq!(out.status.code(), Some(0), "{e}: {}", String::from_utf8_lossy(&out.stderr));
        all.push(std::fs::read_to_string(dir.path().join("h.csv")).unwrap());
    }
    assert!(all.iter().all(|h| h == &all[0]));
    assert_eq!(all[0].lines().count(), 5);
    assert!(all[0].starts_with("ray,i,j,u,v,t,steps,crossings,ups,wall,limit\n"));
}

#[test]
fn the_first_mismatch_is_a_waveform() {
    let small = ["--set", "vectors.arithmetic=100", "--set", "vectors.rays=20", "--set", "view.stride=16"];
    for (unit, output, told) in
        [("fp_add", "result", "output result (stage 2): expected hex"), ("traverse", "out_valid", "output out_i")]
    {
        let dir = tempfile::tempdir().unwrap();
        let args = ["check", "--unit", unit, "--canary", "flip", "--wave", "w.vcd"];
        let out = run(dir.path(), &[&args[..], &small[..]].concat());
        let text = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(1), "{text}");
        assert!(text.contains(told), "{text}");
        let wave = wellen::simple::read(dir.path().join("w.vcd")).unwrap();
        assert!(wave.time_table().len() > 8, "{unit}: {} changes", wave.time_table().len());
        let names: Vec<String> = wave.hierarchy().iter_vars().map(|v| v.full_name(wave.hierarchy())).collect();
        assert!(names.contains(&format!("{unit}.{output}")), "{names:?}");
    }
    let dir = tempfile::tempdir().unwrap();
    let out = run(dir.path(), &["check", "--engine", "icarus", "--wave", "w.vcd"]);
    assert_eq!(out.status.code(), Some(2));
}
