//! Emitted trees beside each other and beside a user's own files: what differs ends elaboration by its name, what has another prefix doesn't
//! meet, lists of files hold from anywhere, and no directive leaks.
mod mixtures;
mod users;

use super::tools::{Said, Tool, run};
use crate::files::write;
use reliefrtl::config::Config;
use reliefrtl::emit::{self, Files};
use reliefrtl::ir::Module;
use reliefrtl::project;
use reliefrtl::units;
use std::path::{Path, PathBuf};
use std::sync::Arc;

fn config(sets: &[&str]) -> Config {
    let mut c = Config::default();
    sets.iter().for_each(|s| c.apply_set(s).unwrap_or_else(|e| panic!("{s}: {e}")));
    c.validate().unwrap_or_else(|e| panic!("{sets:?}: {e}"));
    c
}

fn text(sets: &[&str]) -> Files {
    project::text(&config(sets)).unwrap_or_else(|e| panic!("{sets:?}: {e}")).files
}

fn modules(sets: &[&str]) -> Vec<Arc<Module>> {
    emit::modules(&units::all(&config(sets).design())).expect("legal")
}

/// A directory of this test's own with these files.
fn tree(name: &str, files: &Files) -> PathBuf {
    let dir = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("trees").join(name);
    let _ = std::fs::remove_dir_all(&dir);
    write(&dir, files);
    dir
}

/// Elaborates `top` of the Verilog files given, at its default parameters.
fn elaborate(tool: Tool, dir: &Path, top: &str, files: &[&str]) -> Option<Said> {
    let mut c = tool.command()?;
    match tool {
        Tool::Icarus => drop(c.args(["-s", top]).args(files)),
        Tool::Verilator | Tool::VerilatorNew => drop(c.args(["-Wno-lint", "--top-module", top]).args(files)),
        Tool::Slang => drop(c.args(["--words", "--top", top]).args(files)),
        Tool::Yosys | Tool::YosysNew => {
            let script = format!("read_verilog -formal {}; hierarchy -check -top {top}", files.join(" "));
            c.args(["-p", &script]);
        }
        Tool::Verible | Tool::SlangInterfaces => panic!("{tool:?} elaborates nothing"),
    }
    Some(run(&mut c, dir))
}

const ELABORATE: [Tool; 5] = [Tool::Icarus, Tool::Verilator, Tool::VerilatorNew, Tool::Yosys, Tool::Slang];
