//! Building and running a bench with Icarus Verilog or Verilator.
use crate::emit::emitted_name;
use crate::error::{Error, Result, exit};
use crate::ir::Binding;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

/// A simulator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Simulator {
    /// `iverilog` and `vvp`.
    Icarus,
    /// `verilator`; the environment's VERILATOR names another program.
    Verilator,
}

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

impl Simulator {
    /// Name as on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Icarus => "icarus",
            Self::Verilator => "verilator",
        }
    }
    fn program(self) -> String {
        match self {
            Self::Icarus => "iverilog".into(),
            Self::Verilator => std::env::var("VERILATOR").unwrap_or_else(|_| "verilator".into()),
        }
    }
}

/// Builds `testbench/<prefix>tb_<unit>.v` of the emitted tree `dir` at `params`, runs it with `plusargs`, and reads its verdict. The plusarg
/// `iterations=FILE` has the bench built with a look into the loop.
///
/// # Errors
/// A missing tool, a failed build, a bench without a verdict; and the bench's own findings by their exit code.
pub fn run_bench(sim: Simulator, dir: &Path, unit: &str, params: &Binding, plusargs: &[String]) -> Result<Outcome> {
    let work = tempfile::tempdir().map_err(|e| Error::file("create", std::env::temp_dir(), e))?;
    let dir = dir.canonicalize().map_err(|e| Error::file("find", dir, e))?;
    let top = emitted_name(&dir, "testbench", &format!("tb_{unit}"), ".v")?;
    let start = Instant::now();
    let define = plusargs.iter().any(|p| p.starts_with("iterations=")).then_some("-DITERATIONS");
    let mut command = match sim {
        Simulator::Icarus => build_icarus(&dir, &top, params, define, work.path())?,
        Simulator::Verilator => {
            build_verilator(&dir, &top, params, define, has_many(&dir, unit, plusargs), work.path())?
        }
    };
    let build = start.elapsed();
    let start = Instant::now();
    command.args(plusargs.iter().map(|p| format!("+{p}"))).current_dir(&dir);
    let out = command.output().map_err(|_| missing(sim))?;
    let run = start.elapsed();
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
    let code = out.status.code().unwrap_or(exit::TOOL_FAILED);
    let text = format!("{verdict} (in {})", sim.name());
    let detail = output.lines().find(|l| l.starts_with("vector ") || l.starts_with("ray ")).unwrap_or_default();
    match code {
        exit::OK if verdict.starts_with("PASS") => {}
        exit::MISMATCH => return Err(Error::mismatch(format!("{text}; first: {detail}"))),
        exit::USAGE => return Err(Error::input(text)),
        exit::NOTHING_RAN => return Err(Error::NothingRan(text)),
        exit::DROPPED => return Err(Error::Dropped(text)),
        exit::EXTRA => return Err(Error::Extra(text)),
        other => return Err(Error::ToolFailed(format!("{text}, exit code {other}"))),
    }
    let checked =
        verdict.split(" of ").nth(1).and_then(|r| r.split(' ').next()).and_then(|n| n.parse().ok()).unwrap_or(0);
    if checked == 0 {
        return Err(Error::NothingRan(format!("{text}: nothing was compared")));
    }
    Ok(Outcome { code, output, checked, build, run })
}

fn build_icarus(dir: &Path, top: &str, params: &Binding, define: Option<&str>, work: &Path) -> Result<Command> {
    let image = work.join("bench.vvp");
    let mut c = Command::new("iverilog");
    c.args(["-g2005", "-Wall", "-s", &format!("{top}_top"), "-o"]).arg(&image);
    c.args(params.iter().map(|(k, v)| format!("-P{top}_top.{k}={v}")));
    c.args(define).arg("-y").arg(dir.join("rtl")).args(bench(dir, top, true));
    finish(Simulator::Icarus, c)?;
    let mut run = Command::new("vvp");
    run.arg("-n").arg(image);
    Ok(run)
}

fn in_path(program: &str) -> bool {
    std::env::var_os("PATH").is_some_and(|path| std::env::split_paths(&path).any(|dir| dir.join(program).is_file()))
}

/// Bytes of a stimulus that an optimized build of a simulation pays for: it takes some three times as long as the whole run of fewer.
const MANY: u64 = 1 << 20;

/// Whether a bench has many vectors to go through.
fn has_many(dir: &Path, unit: &str, plusargs: &[String]) -> bool {
    let named = plusargs.iter().find_map(|p| p.strip_prefix("vectors="));
    let vectors = named.map_or(Path::new("golden").join(unit), PathBuf::from);
    std::fs::metadata(dir.join(vectors).join("stimulus.hex")).is_ok_and(|m| m.len() > MANY)
}

fn build_verilator(
    dir: &Path,
    top: &str,
    params: &Binding,
    define: Option<&str>,
    many: bool,
    work: &Path,
) -> Result<Command> {
    let mut c = Command::new(Simulator::Verilator.program());
    c.args(["--cc", "--exe", "--build", "-O3", "-Wno-lint", "--prefix", "Vtb", "-j", "2", "--top-module"]);
    c.arg(top).args(define).arg("--Mdir").arg(work.join("obj"));
    c.args(["-MAKEFLAGS", "OPT_SLOW=-O0", "-MAKEFLAGS", if many { "OPT_FAST=-O2" } else { "OPT_FAST=-O0" }]);
    c.args(params.iter().map(|(k, v)| format!("-G{k}={v}")));
    c.arg("-y").arg(dir.join("rtl")).args(bench(dir, top, false)).arg(dir.join("testbench/verilator_main.cpp"));
    // Most of the time that a small bench takes goes into Verilator's own library, which is the same for all of them.
    if std::env::var_os("OBJCACHE").is_none() && in_path("ccache") {
        c.env("OBJCACHE", "ccache");
    }
    finish(Simulator::Verilator, c)?;
    Ok(Command::new(work.join("obj/Vtb")))
}

fn bench(dir: &Path, top: &str, clocked: bool) -> Vec<PathBuf> {
    let file = |name: String| dir.join("testbench").join(name);
    let mut files = vec![file(format!("{top}.v"))];
    if clocked {
        files.push(file(format!("{top}_top.v")));
    }
    files
}

fn finish(sim: Simulator, mut c: Command) -> Result<()> {
    let out = c.output().map_err(|_| missing(sim))?;
    if out.status.success() {
        return Ok(());
    }
    let text = String::from_utf8_lossy(&out.stderr).into_owned() + &String::from_utf8_lossy(&out.stdout);
    Err(Error::ToolFailed(format!("{} could not build the bench: {}", sim.program(), first_lines(&text))))
}

fn missing(sim: Simulator) -> Error {
    let package = match sim {
        Simulator::Icarus => "iverilog",
        Simulator::Verilator => "verilator",
    };
    Error::ToolMissing(format!(
        "{} is not installed: install the Debian package {package}, or use --engine interp",
        sim.program()
    ))
}

fn first_lines(text: &str) -> String {
    text.lines().filter(|l| !l.trim().is_empty()).take(3).collect::<Vec<_>>().join(" | ")
}
