//! Headers of C++'s library that each build by Verilator reads, compiled once for all builds where these are kept (RELIEFRTL_BUILDS): parsing them
//! takes longer than the model of a small bench.
use crate::process;
use std::path::{Path, PathBuf};

/// What `verilated.h` and the files that Verilator writes include.
const NAMES: [&str; 22] = [
    "algorithm",
    "array",
    "atomic",
    "cassert",
    "cinttypes",
    "cmath",
    "condition_variable",
    "cstdarg",
    "cstdio",
    "cstdlib",
    "cstring",
    "deque",
    "functional",
    "limits",
    "map",
    "memory",
    "mutex",
    "set",
    "sstream",
    "string",
    "unordered_set",
    "vector",
];

/// Of the makefile's flags those that a compiled header has to share with what reads it.
const FLAGS: [&str; 5] = ["-O0", "-faligned-new", "-fcf-protection=none", "-x", "c++-header"];

/// How a quick build reads them; nothing where no builds are kept, or this can't be made: then each build reads the text.
pub(super) fn compiled() -> Option<PathBuf> {
    let kept = std::env::var_os("RELIEFRTL_BUILDS").filter(|v| !v.is_empty()).map(PathBuf::from)?;
    let place = kept.join("headers");
    let header = place.join("library.h");
    // It becomes a word of a makefile.
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
    if !header.is_absolute() || !header.to_str()?.chars().all(plain) {
        return None;
    }
    // Under a name of its own first: another process may be doing the same.
    if !place.is_dir() {
        std::fs::create_dir_all(&kept).ok()?;
        let own = tempfile::Builder::new().prefix(".headers-").tempdir_in(&kept).ok()?;
        make(own.path())?;
        if std::fs::rename(own.path(), &place).is_ok() {
            let _ = own.keep();
        }
    }
    header.is_file().then_some(header)
}

fn make(dir: &Path) -> Option<()> {
    let text: String = NAMES.iter().map(|n| format!("#include <{n}>\n")).collect();
    std::fs::write(dir.join("library.h"), &text).ok()?;
    let mut c = process::command_in(dir, "g++");
    c.args(FLAGS).args(["-o", "library.h.gch", "library.h"]);
    process::output(&mut c).ok()?.status.success().then_some(())?;
    // What ccache takes for its digest, so that another run's is the same.
    std::fs::write(dir.join("library.h.gch.sum"), text).ok()
}

/// Settings with which ccache keeps objects that were compiled with them.
pub(super) const CCACHE: [(&str, &str); 2] =
    [("CCACHE_SLOPPINESS", "pch_defines,time_macros"), ("CCACHE_PCH_EXTSUM", "true")];
