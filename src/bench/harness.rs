//! The traverse unit in Verilator under a C++ harness that is made for speed: rays and results in memory, the model built with
//! `-O3 -march=native`, and only the traversal timed. What `bench` compares with.
use super::run::first_lines;
use super::text::window_words;
use crate::config::Design;
use crate::emit::Files;
use crate::error::{Error, Result};
use crate::files::Scratch;
use crate::ir::Module;
use crate::process;
use crate::trace::{inputs, outputs};
use minijinja::{Environment, context};
use serde::Deserialize;
use std::path::Path;
use std::process::Output;
use std::time::{Duration, Instant};

/// C++ compilers that are tried.
pub const COMPILERS: [&str; 2] = ["g++", "clang++"];

/// What is sent, and what must come back.
pub struct Load<'a> {
    /// Words of the pyramid, by address.
    pub memory: &'a [u64],
    /// A row of inputs for each ray.
    pub rays: &'a [Vec<u64>],
    /// A row of outputs for each ray.
    pub expected: &'a [Vec<u64>],
}

/// A built harness.
pub struct Harness {
    /// Time of Verilator and of the compiler.
    pub build: Duration,
    work: Scratch,
}

/// What a run says. Times in seconds.
#[derive(Clone, Debug, Deserialize)]
pub struct HarnessRun {
    /// Processor time of the reset and of loading the pyramid.
    pub load_s: f64,
    /// Processor time of the traversal.
    pub run_s: f64,
    /// Time of the traversal by the clock on the wall.
    pub wall_s: f64,
    /// Clocks of the traversal.
    pub clocks: u64,
    /// Results that came back, each compared in every output.
    pub compared: u64,
    /// Rays with another result than expected.
    pub wrong: u64,
    /// The first of them.
    pub first_wrong: u64,
}

/// The harness of a design's traverse unit, whose emitted name is `top`.
pub fn harness_text(d: &Design, traverse: &Module, top: &str) -> String {
    let mut env = Environment::new();
    env.set_keep_trailing_newline(true);
    env.add_template("harness", include_str!("templates/harness.cpp")).expect("the template is well formed");
    let tag = traverse.port("in_tag").map_or(1, |p| p.1.width.eval(&traverse.default_binding()));
    let sizes: Vec<i64> = window_words(d, traverse).iter().map(|e| e.eval(&traverse.default_binding())).collect();
    let value = context! {
        sizes,
        top, inputs => inputs(traverse), outputs => outputs(traverse), tags => 1u64 << tag.clamp(1, 16),
        // More than 65535 iterations of a full loop take.
        patience => 65536u64 * 256,
    };
    env.get_template("harness").and_then(|t| t.render(value)).expect("the template uses only what it is given")
}

impl Harness {
    /// Builds the harness of a design's traverse unit, of the emitted tree `files` and under the name `top`, with a compiler of [`COMPILERS`].
    ///
    /// # Errors
    /// [`Error::ToolMissing`] without Verilator, make or the compiler; [`Error::ToolFailed`] if the build fails.
    pub fn new(compiler: &str, files: &Files, (d, traverse): (&Design, &Module), top: &str) -> Result<Self> {
        let work = Scratch::new()?;
        let put = |name: &str, bytes: &[u8]| {
            let place = work.path().join(name);
            std::fs::create_dir_all(place.parent().unwrap_or(work.path()))
                .map_err(|e| Error::file("create", &place, e))?;
            std::fs::write(&place, bytes).map_err(|e| Error::file("write", &place, e))
        };
        files.iter().filter(|(name, _)| name.starts_with("rtl/")).try_for_each(|(n, text)| put(n, text.as_bytes()))?;
        put("harness.cpp", harness_text(d, traverse, top).as_bytes())?;
        let start = Instant::now();
        let verilator = std::env::var("VERILATOR").unwrap_or_else(|_| "verilator".into());
        // Nothing that costs time in the model: no assertions, no random values for x.
        let options = ["--cc", "--exe", "-O3", "--x-assign", "fast", "--x-initial", "fast", "--noassert", "-Wno-lint"];
        let model = ["--prefix", "Vdut", "--Mdir", "obj", "--top-module", top, "-y", "rtl"];
        let source = format!("rtl/{top}.v");
        let out = tool(work.path(), &verilator, &[&options[..], &model, &[&source, "harness.cpp"]].concat())?;
        finish(&verilator, &out)?;
        let (cxx, link) = (format!("CXX={compiler}"), format!("LINK={compiler}"));
        let fast = ["OPT_FAST=-O3 -march=native", "OPT_GLOBAL=-O3 -march=native", "OPT_SLOW=-O1", "CURDIR=."];
        let make = [&["-C", "obj", "-f", "Vdut.mk", "-j", "2", &cxx, &link][..], &fast].concat();
        let out = tool(work.path(), "make", &make)?;
        finish(compiler, &out)?;
        Ok(Self { build: start.elapsed(), work })
    }

    /// Says what [`Harness::run`] sends from now on.
    ///
    /// # Errors
    /// A directory that can't be written.
    pub fn load(&self, load: &Load<'_>) -> Result<()> {
        let counts = [load.memory.len() as u64, load.rays.len() as u64];
        let rows = load.rays.iter().chain(load.expected).flatten();
        let words = counts.iter().chain(load.memory).chain(rows);
        let place = self.work.path().join("rays.bin");
        let bytes: Vec<u8> = words.flat_map(|w| w.to_ne_bytes()).collect();
        std::fs::write(&place, bytes).map_err(|e| Error::file("write", &place, e))
    }

    /// Sends all rays once.
    ///
    /// # Errors
    /// A result that is not the expected one, one that never came, one that is not waited for.
    pub fn run(&self) -> Result<HarnessRun> {
        let program = self.work.path().join("obj/Vdut");
        let mut command = process::command_in(self.work.path(), program);
        let out =
            process::output(&mut command).map_err(|e| Error::ToolFailed(format!("the harness in Verilator: {e}")))?;
        let text = String::from_utf8_lossy(&out.stdout).into_owned();
        let run: HarnessRun = serde_json::from_str(&text).map_err(|_| {
            Error::ToolFailed(format!("the harness in Verilator ended without figures: {}", first_lines(&text)))
        })?;
        match out.status.code() {
            Some(0) => Ok(run),
            Some(1) => Err(Error::mismatch(format!(
                "{} of {} hits in Verilator differ from the golden model's, ray {} first",
                run.wrong, run.compared, run.first_wrong
            ))),
            Some(6) => Err(Error::Dropped(format!("Verilator: a ray never came back, after {} results", run.compared))),
            Some(7) => Err(Error::Extra("Verilator: a result that is not waited for".into())),
            _ => Err(Error::ToolFailed(format!("the harness in Verilator failed: {}", first_lines(&text)))),
        }
    }
}

fn tool(work: &Path, program: &str, arguments: &[&str]) -> Result<Output> {
    let missing = |_| Error::ToolMissing(format!("{program} is not installed: `sh tools/test.sh` installs it"));
    process::output(process::command_in(work, program).args(arguments)).map_err(missing)
}

fn finish(program: &str, out: &Output) -> Result<()> {
    if out.status.success() {
        return Ok(());
    }
    let text = String::from_utf8_lossy(&out.stderr).into_owned() + &String::from_utf8_lossy(&out.stdout);
    Err(Error::ToolFailed(format!("{program} could not build the harness: {}", first_lines(&text))))
}
