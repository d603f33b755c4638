//! `--out` of the verbs that write one file: devices, FIFOs, links, standard output, disks that are full.
#![cfg(unix)]
use super::{run, said};
use std::fs;
use std::os::unix::fs::{FileTypeExt, symlink};
use std::path::Path;
use std::process::{Command, Stdio};

const TRACE: [&str; 5] = ["trace", "--rays", "r.csv", "--set", "traverse.levels=3"];

fn place() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("r.csv"), "u,v,du,dv\n0.1,0.2,0.5,0.25\n").unwrap();
    dir
}

fn trace(dir: &Path, out: &str, more: &[&str]) -> (Option<i32>, String) {
    said(dir, &[&TRACE[..], &["--out", out], more].concat())
}

fn fifo(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

/// The hits as a file of their own.
fn hits(dir: &Path) -> Vec<u8> {
    assert_eq!(trace(dir, "plain.csv", &[]).0, Some(0));
    fs::read(dir.join("plain.csv")).unwrap()
}

#[test]
fn a_device_or_fifo_is_written_to() {
    let dir = place();
    let wanted = hits(dir.path());
    // A device node of its own, where that can be made: if it is replaced, it is not the machine's.
    let null = dir.path().join("null");
    let made = Command::new("mknod").arg(&null).args(["c", "1", "3"]).status().is_ok_and(|s| s.success());
    if made && fs::OpenOptions::new().write(true).open(&null).is_ok() {
        for (out, more) in [("null", vec![]), ("plain.csv", vec!["--wave", "null"])] {
            assert_eq!(trace(dir.path(), out, &more).0, Some(0));
            assert!(fs::symlink_metadata(&null).unwrap().file_type().is_char_device(), "{out} {more:?}");
        }
    }
    fifo(&dir.path().join("p"));
    symlink("p", dir.path().join("link to p")).unwrap();
    for out in ["p", "link to p"] {
        let reader = Command::new("cat").arg("p").current_dir(dir.path()).stdout(Stdio::piped()).spawn().unwrap();
        let (code, text) = trace(dir.path(), out, &[]);
        assert_eq!(code, Some(0), "{text}");
        assert_eq!(reader.wait_with_output().unwrap().stdout, wanted);
        assert!(fs::symlink_metadata(dir.path().join("p")).unwrap().file_type().is_fifo());
    }
    let (code, text) = trace(dir.path(), "/dev/full", &[]);
    assert_eq!(code, Some(2), "{text}");
    assert!(text.contains("cannot write /dev/full: No space left on device"), "{text}");
    assert!(fs::symlink_metadata("/dev/full").unwrap().file_type().is_char_device());
}

#[test]
fn a_link_is_followed_and_stays() {
    let dir = place();
    let wanted = hits(dir.path());
    fs::create_dir(dir.path().join("elsewhere")).unwrap();
    fs::write(dir.path().join("elsewhere/h.csv"), "old").unwrap();
    symlink("elsewhere/h.csv", dir.path().join("one")).unwrap();
    symlink("one", dir.path().join("two")).unwrap();
    assert_eq!(trace(dir.path(), "two", &[]).0, Some(0));
    assert_eq!(fs::read(dir.path().join("elsewhere/h.csv")).unwrap(), wanted);
    for link in ["one", "two"] {
        assert!(fs::symlink_metadata(dir.path().join(link)).unwrap().is_symlink());
    }
    symlink("elsewhere/h.png", dir.path().join("p.png")).unwrap();
    symlink("elsewhere", dir.path().join("directory")).unwrap();
    symlink("loop2", dir.path().join("loop1")).unwrap();
    symlink("loop1", dir.path().join("loop2")).unwrap();
    for (out, why) in [
        (
            "p.png",
            "it is a link to elsewhere/h.png, which is not there; links are followed and never replaced, so make that file or",
        ),
        ("directory", "it is a link to a directory"),
        ("loop1", "it is a link that leads nowhere"),
        ("elsewhere", "it is a directory"),
        ("nowhere/h.csv", "nowhere is not a directory"),
        ("r.csv/h.csv", "r.csv is not a directory"),
        ("new/", "it names a directory"),
    ] {
        for more in [["--out", out], ["--wave", out]] {
            let (code, text) = match more[0] {
                "--out" => trace(dir.path(), out, &[]),
                _ => trace(dir.path(), "h2.csv", &more),
            };
            assert_eq!(code, Some(2), "{more:?}: {text}");
            assert!(text.contains(why) || more[0] == "--wave" && text.contains(".vcd or .fst"), "{more:?}: {text}");
            assert!(!dir.path().join("h2.csv").exists(), "refused before the work");
        }
    }
    symlink("nowhere", dir.path().join("tree")).unwrap();
    for verb in ["build", "emit", "vectors", "report"] {
        let (code, text) = said(dir.path(), &[verb, "--out", "tree"]);
        let why = "cannot write into tree: it is a link to nowhere, which is not there; links are followed and never replaced, so make that directory";
        assert!(code == Some(2) && text.contains(why), "{verb}: {text}");
    }
    // Permissions of a file that is replaced stay.
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(dir.path().join("plain.csv"), fs::Permissions::from_mode(0o600)).unwrap();
    hits(dir.path());
    assert_eq!(fs::metadata(dir.path().join("plain.csv")).unwrap().permissions().mode() & 0o777, 0o600);
}

#[test]
fn a_dash_is_standard_output_and_carries_nothing_else() {
    let dir = place();
    let wanted = hits(dir.path());
    for out in ["-", "/dev/stdout"] {
        for more in [&[][..], &["--json"]] {
            let done = run(dir.path(), &[&TRACE[..], &["--out", out], more].concat());
            assert_eq!(done.status.code(), Some(0));
            assert_eq!(done.stdout, wanted, "{out} {more:?}");
            assert!(!done.stderr.is_empty(), "the summary goes to standard error");
        }
    }
    let wave = run(dir.path(), &[&TRACE[..], &["--out", "h.csv", "--wave", "-"]].concat());
    assert!(wave.stdout.starts_with(b"$timescale") && wave.status.success(), "{wave:?}");
    let (code, text) = trace(dir.path(), "-", &["--wave", "-"]);
    assert!(code == Some(2) && text.contains("--out and --wave both go to standard output"), "{text}");
    let picture = run(dir.path(), &["render", "--out", "-", "--set", "traverse.levels=3", "--set", "view.stride=8"]);
    assert!(picture.stdout.starts_with(b"\x89PNG") && picture.status.success(), "{picture:?}");
    assert!(!dir.path().join("-").exists());
    // Standard output that is a file is written to where it stands.
    let file = fs::File::create(dir.path().join("here")).unwrap();
    let ended = Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
        .args([&TRACE[..], &["--out", "here"]].concat())
        .current_dir(dir.path())
        .stdout(file)
        .status()
        .unwrap();
    assert!(ended.success());
    assert_eq!(fs::read(dir.path().join("here")).unwrap(), wanted);
    for verb in ["build", "emit", "vectors", "report"] {
        let (code, text) = said(dir.path(), &[verb, "--out", "-"]);
        assert!(code == Some(2) && text.contains("--out - is standard output, which takes one file"), "{verb}: {text}");
        assert!(!dir.path().join("-").exists());
    }
}

/// A pipe without a reader.
fn closed() -> std::io::PipeWriter {
    std::io::pipe().unwrap().1
}

#[test]
fn a_closed_pipe_takes_nothing_from_the_work() {
    let dir = place();
    let wanted = hits(dir.path());
    let tool = |args: &[&str]| {
        let mut c = Command::new(env!("CARGO_BIN_EXE_reliefrtl"));
        c.args(args).current_dir(dir.path()).stdout(closed());
        let out = c.output().unwrap();
        assert!(!String::from_utf8_lossy(&out.stderr).contains("panicked"), "{out:?}");
        out.status.code()
    };
    let trace = |more: &[&str]| tool(&[&TRACE[..], more].concat());
    // The hits are written, whatever becomes of the waveform and of what is said.
    for more in [&["--out", "h.csv", "--wave", "-"][..], &["--out", "h.csv"], &["--out", "h.csv", "--json"]] {
        assert_eq!(trace(more), Some(141), "{more:?}");
        assert_eq!(fs::read(dir.path().join("h.csv")).unwrap(), wanted, "{more:?}");
        fs::remove_file(dir.path().join("h.csv")).unwrap();
    }
    assert_eq!(trace(&["--out", "-", "--wave", "w.vcd"]), Some(141));
    assert!(fs::read(dir.path().join("w.vcd")).unwrap().starts_with(b"$timescale"));
    let small = ["--set", "traverse.levels=3", "--set", "view.stride=64"];
    assert_eq!(tool(&[&["render", "--out", "-"], &small[..]].concat()), Some(141));
    assert_eq!(tool(&[&["emit", "--unit", "lzc", "--out", "o"], &small[..]].concat()), Some(141));
    assert!(dir.path().join("o/manifest.json").exists());
    // A verdict stays one.
    let check = ["check", "--unit", "lzc", "--canary", "flip", "--set", "vectors.arithmetic=20"];
    assert_eq!(tool(&check), Some(1));
    assert_eq!(tool(&[&check[..], &["--wave", "-"]].concat()), Some(1));
    // What goes on until it is stopped ends, too.
    assert_eq!(tool(&["check", "--unit", "fp_add", "--level", "3", "--set", "vectors.arithmetic=20"]), Some(141));
}

/// Only the verbs that write a tree replace its files.
#[test]
fn a_file_of_an_emitted_tree_is_no_output() {
    let dir = place();
    let emit = ["emit", "--out", "o", "--set", "traverse.levels=3"];
    assert_eq!(said(dir.path(), &emit).0, Some(0));
    let rtl = "o/rtl/relief_traverse.v";
    symlink(rtl, dir.path().join("link.v")).unwrap();
    let look = || fs::read_to_string(dir.path().join(rtl)).unwrap();
    let before = look();
    let rates = ["render", "--set", "traverse.levels=3", "--set", "view.stride=64"];
    for listed in [true, false] {
        for out in [rtl, "o/manifest.json", "link.v", "o/../o/rtl/relief_traverse.v"] {
            for verb in [&TRACE[..], &rates, &["fit", "--max-uv-error", "1"], &["synth", "--unit", "lzc"]] {
                let (code, text) = said(dir.path(), &[verb, &["--out", out]].concat());
                assert_eq!(code, Some(2), "{verb:?} {out}: {text}");
                let sentence = "it is a file of the tree that was emitted into ";
                assert!(text.contains(sentence) && text.contains("choose another name"), "{verb:?} {out}: {text}");
            }
        }
        let (code, text) = trace(dir.path(), "o/new.csv", &[]);
        assert_eq!(code, Some(0), "what is no file of the tree may stand in it: {text}");
        fs::remove_file(dir.path().join("o/new.csv")).unwrap();
        if listed {
            // Pictures replace pictures, and no tree.
            let hard = ["hard", "--case", "floor", "--rays", "4", "--engine", "golden", "--pictures"];
            let (code, text) = said(dir.path(), &[&hard[..], &["o"]].concat());
            assert!(code == Some(2) && text.contains("choose another output directory"), "{text}");
            for _ in 0..2 {
                let (code, text) = said(dir.path(), &[&hard[..], &["pictures"]].concat());
                assert_eq!(code, Some(0), "{text}");
            }
            // A tree that was copied without its list.
            fs::remove_file(dir.path().join("o/.reliefrtl-files")).unwrap();
        }
    }
    assert_eq!(look(), before);
}

#[test]
fn a_directory_for_temporary_files_is_named_by_what_sets_it() {
    let dir = place();
    fs::write(dir.path().join("file"), "").unwrap();
    for (tmp, why) in [
        ("", "TMPDIR is empty"),
        ("none", "TMPDIR is none, which is not there"),
        ("file", "TMPDIR is file, which is no directory"),
    ] {
        let mut c = Command::new(env!("CARGO_BIN_EXE_reliefrtl"));
        c.args(["check", "--unit", "lzc", "--set", "vectors.arithmetic=20"]).env("TMPDIR", tmp).current_dir(dir.path());
        let out = c.output().unwrap();
        let text = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(2), "{text}");
        let right = "let it name a directory that can be written (or unset it)";
        assert_eq!(text, format!("reliefrtl: {why}: {right}\n"));
    }
}

/// With `--json` an error is one JSON object on standard error, whoever finds it.
#[test]
fn errors_for_machines() {
    let dir = place();
    let cases: [(&[&str], i32, &str, &str); 8] = [
        (&["list", "--nothing"], 2, "usage", "unexpected argument '--nothing' found"),
        (&["trace"], 2, "usage", "--out"),
        (&["check", "--shard", "1/0"], 2, "usage", "--shard"),
        (&["list", "--set", "format.exp=99"], 2, "input", "format.exp = 99 is too large"),
        (&["steps", "--map", "none.png"], 2, "file", "cannot read none.png"),
        (&["trace", "--rays", "r.csv", "--out", "no/h.csv"], 2, "input", "no is not a directory"),
        (&["hard", "--rays", "0"], 5, "nothing-ran", "at least one ray"),
        (&["check", "--unit", "lzc", "--canary", "flip", "--set", "vectors.arithmetic=20"], 1, "mismatch", "lzc"),
    ];
    for (args, code, kind, message) in cases {
        let out = run(dir.path(), &[args, &["--json"]].concat());
        assert_eq!((out.status.code(), &out.stdout[..]), (Some(code), &b""[..]), "{args:?}");
        let told: serde_json::Value = serde_json::from_slice(&out.stderr).unwrap_or_else(|e| panic!("{args:?}: {e}"));
        let error = &told["error"];
        assert_eq!((&error["code"], &error["kind"]), (&code.into(), &kind.into()), "{args:?}: {told}");
        assert!(error["message"].as_str().unwrap().contains(message), "{args:?}: {told}");
        if kind == "file" {
            assert_eq!(error["place"], "none.png");
        }
    }
}

#[test]
fn no_output_that_is_full_or_closed_is_a_panic() {
    let dir = place();
    let verbs: [&[&str]; 7] = [
        &["completions", "bash"],
        &["--help"],
        &["--version"],
        &["list"],
        &["config", "--print"],
        &["list", "--json"],
        &["check", "--unit", "lzc", "--set", "vectors.arithmetic=20"],
    ];
    for verb in verbs {
        let full = || Stdio::from(fs::OpenOptions::new().write(true).open("/dev/full").unwrap());
        let go = || {
            let mut c = Command::new(env!("CARGO_BIN_EXE_reliefrtl"));
            c.args(verb).current_dir(dir.path());
            c
        };
        let out = go().stdout(full()).output().unwrap();
        let text = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(2), "{verb:?}: {text}");
        assert!(text.contains("cannot write to standard output: No space left on device"), "{verb:?}: {text}");
        assert!(!text.contains("panicked"), "{text}");
        // Both full: nothing can be said, and the code says it.
        assert_eq!(go().stdout(full()).stderr(full()).status().unwrap().code(), Some(2));
        // There is no reader: the end is quiet, and no success.
        let out = go().stdout(closed()).output().unwrap();
        assert_eq!((out.status.code(), &out.stderr[..]), (Some(141), &b""[..]), "{verb:?}");
    }
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let ended =
        Command::new(env!("CARGO_BIN_EXE_reliefrtl")).arg("check").arg("--unit").arg("none").stderr(full).status();
    assert_eq!(ended.unwrap().code(), Some(2), "an error that is not heard is one all the same");
}

/// A name that looks like an option, and one after an option that takes none.
#[test]
fn a_value_that_begins_with_a_dash_is_told_how() {
    let dir = tempfile::tempdir().unwrap();
    let told = "a value that begins with a dash is given as '--out=-o x', or if it is a file as './-o x'";
    for more in [&[][..], &["--json"]] {
        let (code, text) = super::said(dir.path(), &[&["emit", "--unit", "fp_lt", "--out", "-o x"][..], more].concat());
        assert!(code == Some(2) && text.contains(told), "{text}");
    }
    let (code, text) = super::said(dir.path(), &["build", "--print-map", "-o"]);
    assert!(code == Some(2) && !text.contains("begins with a dash"), "{text}");
    for name in ["--out=-o x", "--out=./-p x"] {
        let (code, text) =
            super::said(dir.path(), &["emit", "--unit", "fp_lt", name, "--set", "vectors.arithmetic=20"]);
        assert_eq!(code, Some(0), "{text}");
    }
    assert!(dir.path().join("-o x/rtl").is_dir() && dir.path().join("-p x/rtl").is_dir());
}
