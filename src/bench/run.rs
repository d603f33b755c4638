//! Building and running a bench with Icarus Verilog or Verilator.
use super::headers;
use super::kept::Build;
use super::said::Said;
use super::simulator::Simulator;
use crate::emit::emitted_name;
use crate::error::{Error, Finding, Result, exit};
use crate::files::{Scratch, only_files_in};
use crate::ir::Binding;
use crate::process;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

/// What a bench said.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The bench's exit code.
    pub code: i32,
    /// Everything it printed.
    pub output: String,
    /// Rows that it compared.
    pub checked: usize,
    /// Time of the build.
    pub build: Duration,
    /// Time of the run.
    pub run: Duration,
}

/// Builds `testbench/<prefix>tb_<unit>.v` of the emitted tree `dir` at `params`, runs it with `plusargs`, and reads its verdict. The plusarg
/// `iterations=FILE` has the bench built with a look into the loop; `preloaded` is [`Paths::preloaded`].
///
/// Paths are taken from the tree, as [`Paths`].
///
/// # Errors
/// As [`run_bench_on`].
pub fn run_bench(sim: Simulator, dir: &Path, unit: &str, params: &Binding, plusargs: &[String]) -> Result<Outcome> {
    let (mut paths, mut others) = (Paths::default(), Vec::new());
    for argument in plusargs {
        match argument.split_once('=') {
            Some(("vectors", path)) => paths.vectors = Some(dir.join(path)),
            Some(("results", path)) => paths.results = Some(dir.join(path)),
            Some(("iterations", path)) => paths.iterations = Some(dir.join(path)),
            _ if argument == "preloaded" => paths.preloaded = true,
            _ => others.push(argument.as_str()),
        }
    }
    run_bench_on(sim, dir, unit, params, &paths, &others)
}

/// Where a bench reads and writes.
#[derive(Clone, Debug, Default)]
pub struct Paths {
    /// Directory of the vectors; without it the tree's own.
    pub vectors: Option<PathBuf>,
    /// Where the words of every result go.
    pub results: Option<PathBuf>,
    /// Where every iteration goes.
    pub iterations: Option<PathBuf>,
    /// Whether the map of the vectors is in the memory at power-up (`MEM_INIT`), so that no word of it goes through the load port.
    pub preloaded: bool,
}

/// As [`run_bench`], with paths of any bytes. The tools stand in a directory of ours and see names of ours only, whatever the tree, the vectors and
/// the files that the bench writes are called.
///
/// # Errors
/// A missing tool, a failed build, a bench without a verdict; and the bench's own findings by their exit code.
pub fn run_bench_on(
    sim: Simulator,
    dir: &Path,
    unit: &str,
    params: &Binding,
    paths: &Paths,
    plusargs: &[&str],
) -> Result<Outcome> {
    let work = Scratch::new()?;
    let dir = dir.canonicalize().map_err(|e| Error::file("find", dir, e))?;
    let top = emitted_name(&dir, "testbench", &format!("tb_{unit}"), ".v")?;
    for part in ["rtl", "testbench", "golden"] {
        only_files_in(&dir.join(part))?;
        link(&dir.join(part), &work.path().join(part))?;
    }
    only_files_in(paths.vectors.as_deref().unwrap_or(&dir.join("golden").join(unit)))?;
    let mut arguments: Vec<String> = plusargs.iter().map(|p| format!("+{p}")).collect();
    if let Some(vectors) = &paths.vectors {
        let vectors = vectors.canonicalize().map_err(|e| Error::file("find", vectors, e))?;
        link(&vectors, &work.path().join("vectors"))?;
        arguments.push("+vectors=vectors".into());
    }
    let written = [("results", &paths.results), ("iterations", &paths.iterations)];
    let written: Vec<(&str, &PathBuf)> =
        written.into_iter().filter_map(|(key, to)| Some((key, to.as_ref()?))).collect();
    arguments.extend(written.iter().map(|(key, _)| format!("+{key}={key}.txt")));
    let start = Instant::now();
    let define = paths.iterations.is_some().then_some("-DITERATIONS");
    let map = (paths.preloaded && paths.vectors.is_some()).then_some("MEM_INIT=\"vectors/memory.hex\"");
    let many = has_many(&dir, unit, paths);
    let product = work.path().join(sim.product());
    let more = format!("{define:?} {many} {map:?}");
    let kept = Build { sim, program: sim.program(), tree: &dir, top: &top, params, more, product };
    kept.once(|| match sim {
        Simulator::Icarus => build_icarus(&top, params, (define, map), work.path()),
        Simulator::Verilator => build_verilator(&top, params, (define, map), many, work.path()),
    })?;
    let mut command = match sim {
        Simulator::Icarus => process::command_in(work.path(), "vvp"),
        Simulator::Verilator => process::command_in(work.path(), work.path().join(sim.product())),
    };
    if sim == Simulator::Icarus {
        command.args(["-n", sim.product()]);
    }
    let build = start.elapsed();
    let start = Instant::now();
    let out = process::output(command.args(&arguments)).map_err(|e| not_started(sim, &e))?;
    let run = start.elapsed();
    for (key, place) in written {
        match std::fs::read(work.path().join(format!("{key}.txt"))) {
            Ok(bytes) => crate::files::write_atomic(place, &bytes)?,
            // A bench that ended early has written none.
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => {}
            Err(e) => return Err(Error::file("read", key, e)),
        }
    }
    let output = String::from_utf8_lossy(&out.stdout).into_owned();
    let verdict = output.lines().find(|l| l.starts_with("PASS ") || l.starts_with("FAIL "));
    let Some(verdict) = verdict else {
        let text = output + &String::from_utf8_lossy(&out.stderr);
        return Err(Error::ToolFailed(format!(
            "{}: tb_{unit} ended without a verdict: {}",
            sim.name(),
            first_lines(&text)
        )));
    };
    let said = Said::read(&output);
    let code = out.status.code().unwrap_or(exit::TOOL_FAILED);
    let mut text = format!("{verdict} (in {})", sim.name());
    let detail = output.lines().find(|l| l.starts_with("vector ") || l.starts_with("ray ")).unwrap_or_default();
    match code {
        exit::OK if verdict.starts_with("PASS") => {}
        exit::MISMATCH => {
            // A handshake that is wrong is no row's mismatch.
            if !detail.is_empty() {
                text += &format!("; first: {detail}");
            }
            return Err(Error::Mismatch(Finding { text, place: said.place(unit, sim.name()).map(Box::new) }));
        }
        exit::USAGE => return Err(Error::input(text)),
        exit::NOTHING_RAN => return Err(Error::NothingRan(text)),
        exit::DROPPED => return Err(Error::Dropped(text)),
        exit::EXTRA => return Err(Error::Extra(text)),
        other => return Err(Error::ToolFailed(format!("{text}, exit code {other}"))),
    }
    let Some((checked, _)) = said.done else {
        return Err(Error::NothingRan(format!(
            "{text}: its bench does not say how many rows it compared (no line @done): emit the tree anew"
        )));
    };
    if checked == 0 {
        return Err(Error::NothingRan(format!("{text}: nothing was compared")));
    }
    Ok(Outcome { code, output, checked, build, run })
}

/// Gives a directory another name; one that is not there gets none.
pub(super) fn link(directory: &Path, name: &Path) -> Result<()> {
    if !directory.is_dir() {
        return Ok(());
    }
    #[cfg(unix)]
    let linked = std::os::unix::fs::symlink(directory, name);
    #[cfg(windows)]
    let linked = std::os::windows::fs::symlink_dir(directory, name);
    linked.map_err(|e| Error::file("link to", directory, e))
}

/// What a build is given besides parameters of numbers: a define, and the parameter that names a map.
type Given<'a> = (Option<&'a str>, Option<&'a str>);

fn build_icarus(top: &str, params: &Binding, (define, map): Given<'_>, work: &Path) -> Result<()> {
    let mut c = process::command_in(work, "iverilog");
    c.args(["-g2005", "-Wall", "-s", &format!("{top}_top"), "-o", "bench.vvp"]);
    c.args(params.iter().map(|(k, v)| format!("-P{top}_top.{k}={v}")));
    c.args(map.map(|m| format!("-P{top}_top.{m}")));
    c.args(define).args(["-y", "rtl"]).args(bench(top, true));
    finish(Simulator::Icarus, c)
}

fn in_path(program: &str) -> bool {
    std::env::var_os("PATH").is_some_and(|path| std::env::split_paths(&path).any(|dir| dir.join(program).is_file()))
}

/// Bytes of a stimulus that an optimized build of a simulation pays for: it takes some three times as long as the whole run of fewer.
const MANY: u64 = 1 << 20;

/// Whether a bench has many vectors to go through.
fn has_many(dir: &Path, unit: &str, paths: &Paths) -> bool {
    let vectors = paths.vectors.clone().unwrap_or_else(|| dir.join("golden").join(unit));
    std::fs::metadata(vectors.join("stimulus.hex")).is_ok_and(|m| m.len() > MANY)
}

fn build_verilator(top: &str, params: &Binding, (define, map): Given<'_>, many: bool, work: &Path) -> Result<()> {
    let mut c = process::command_in(work, Simulator::Verilator.program());
    c.args(["--cc", "--exe", "--build", "-O3", "-Wno-lint", "--prefix", "Vtb", "-j", "2", "--top-module"]);
    // Its makefile refuses a directory with a blank in its path, which make itself is never asked to write down.
    c.arg(top).args(define).args(["--Mdir", "obj", "-MAKEFLAGS", "CURDIR=."]);
    // One file for a quick build: each of several would read the library's headers again. (0 would put each constant into a file of its own.)
    let quick = ["--output-split", "1000000000", "-MAKEFLAGS", "OPT_SLOW=-O0", "-MAKEFLAGS", "OPT_FAST=-O0"];
    c.args(if many { &["-MAKEFLAGS", "OPT_FAST=-O2"][..] } else { &quick });
    if let Some(header) = headers::compiled().filter(|_| !many) {
        c.arg("-CFLAGS").arg(format!("-include {}", header.display())).envs(headers::CCACHE);
    }
    c.args(params.iter().map(|(k, v)| format!("-G{k}={v}"))).args(map.map(|m| format!("-G{m}")));
    c.args(["-y", "rtl"]).args(bench(top, false)).arg("testbench/verilator_main.cpp");
    // Most of the time that a small bench takes goes into Verilator's own library, which is the same for all of them.
    if std::env::var_os("OBJCACHE").is_none() && in_path("ccache") {
        c.env("OBJCACHE", "ccache");
    }
    finish(Simulator::Verilator, c)
}

/// Builds `files` below `work` into one program that counts coverage; quickly, as it runs once.
pub(super) fn build_covered(work: &Path, files: &[String]) -> Result<Command> {
    let mut c = process::command_in(work, Simulator::Verilator.program());
    c.args(["--cc", "--exe", "--build", "-O3", "-Wno-lint", "--prefix", "Vtb", "-j", "2", "--top-module", "covered"]);
    c.args(["--coverage-line", "--coverage-toggle", "--Mdir", "obj", "-MAKEFLAGS", "CURDIR=."]);
    c.args(["-MAKEFLAGS", "OPT_SLOW=-O0", "-MAKEFLAGS", "OPT_FAST=-O0", "-MAKEFLAGS", "OPT_GLOBAL=-O0"]);
    c.args(["-y", "rtl"]).args(files);
    finish(Simulator::Verilator, c)?;
    Ok(process::command_in(work, work.join("obj/Vtb")))
}

fn bench(top: &str, clocked: bool) -> Vec<String> {
    let mut files = vec![format!("testbench/{top}.v")];
    if clocked {
        files.push(format!("testbench/{top}_top.v"));
    }
    files
}

fn finish(sim: Simulator, mut c: Command) -> Result<()> {
    let out = process::output(&mut c).map_err(|e| not_started(sim, &e))?;
    if out.status.success() {
        return Ok(());
    }
    let text = String::from_utf8_lossy(&out.stderr).into_owned() + &String::from_utf8_lossy(&out.stdout);
    Err(Error::ToolFailed(format!("{} could not build the bench: {}", sim.program(), first_lines(&text))))
}

fn not_started(sim: Simulator, why: &std::io::Error) -> Error {
    if why.kind() != std::io::ErrorKind::NotFound {
        return Error::ToolFailed(format!("{} could not be started: {why}", sim.program()));
    }
    let package = match sim {
        Simulator::Icarus => "iverilog",
        Simulator::Verilator => "verilator",
    };
    Error::ToolMissing(format!(
        "{} is not installed: install the Debian package {package}, or use --engine interp",
        sim.program()
    ))
}

pub(super) fn first_lines(text: &str) -> String {
    text.lines().filter(|l| !l.trim().is_empty()).take(3).collect::<Vec<_>>().join(" | ")
}
