//! `reliefrtl synth`: areas and clocks of units, as a table and in a file.
use super::args::{Cli, SynthArgs, SynthTarget};
use super::output::{spinner, table};
use super::shell::word;
use crate::catalogue;
use crate::config::{Config, Design, latency_key};
use crate::error::{Error, Result};
use crate::files::Sink;
use crate::ir::Module;
use crate::synth::{Figures, Placing, Target, asked, check_module_name, digest, measure, measure_files, versions};
use serde_json::{Value, json};
use std::path::PathBuf;
use std::sync::Arc;

/// A unit to measure.
pub(super) struct Job {
    /// The unit.
    pub unit: Arc<Module>,
    /// Its design.
    design: Design,
    /// Clocks that were asked for.
    clocks: Option<u32>,
}

/// Everything that a call measures of ours.
pub(super) struct Work {
    /// What it is mapped to.
    pub target: Target,
    /// What the placer is asked for.
    pub placing: Placing,
    /// The units, in the order asked for.
    pub jobs: Vec<Job>,
}

/// Looks at all that was asked for before anything is measured.
pub(super) fn prepare(cli: &Cli, a: &SynthArgs) -> Result<Work> {
    let c = super::config::load_for(cli, &a.unit)?.0;
    let d = c.design();
    let all: Vec<String> = catalogue::units(&d).into_iter().map(|m| m.name.clone()).collect();
    let mut names = if a.unit == ["all"] { all } else { a.unit.clone() };
    if a.unit == ["all"] && !a.latency.is_empty() {
        names.retain(|name| latency_key(name).is_some());
    }
    let target = target(a)?;
    let placing = Placing { seeds: a.seeds.clone(), freq: a.freq, timing_weight: a.timing_weight, copies: a.copies };
    // One run at the configured latencies, or one at each latency asked for.
    let latencies: Vec<Option<u32>> =
        if a.latency.is_empty() { vec![None] } else { a.latency.iter().copied().map(Some).collect() };
    let mut jobs = Vec::new();
    for name in &names {
        for clocks in &latencies {
            let design = clocks.map_or(Ok(d), |clocks| at_latency(&c, name, clocks))?;
            design.check_divider()?;
            jobs.push(Job { unit: catalogue::find(&design, name)?, design, clocks: *clocks });
        }
    }
    Ok(Work { target, placing, jobs })
}

/// The figures of one unit, and all that is kept of them: the call that measures it again, the tools, the digest of the text.
pub(super) fn entry(cli: &Cli, a: &SynthArgs, work: &Work, job: &Job) -> Result<(Figures, Value)> {
    let figures = measure(&job.unit, &work.target, &work.placing)?;
    let mut value = serde_json::to_value(&figures).expect("plain data");
    value["design"] = design(&job.design);
    value["digest"] = digest(&job.unit, work.placing.copies).into();
    value["asked"] = asked(&work.target, &work.placing).into();
    value["tools"] = versions(&work.target)?.into();
    Ok((figures, with_command(command(cli, a, (&job.unit.name, job.clocks), None), value)))
}

/// An entry with its call, which comes first, so that a line says what it is about.
fn with_command(command: String, value: Value) -> Value {
    let Value::Object(rest) = value else { unreachable!("figures are a table") };
    std::iter::once(("command".to_string(), Value::from(command))).chain(rest).collect()
}

/// The figures of another project's module, and what is kept of them.
pub(super) fn beside(cli: &Cli, a: &SynthArgs, work: &Work, asked_for: &str) -> Result<(Figures, Value)> {
    let other = foreign(asked_for)?;
    let figures = measure_files(&other.files, &other.top, &work.target, &work.placing)?;
    let mut value = serde_json::to_value(&figures).expect("plain data");
    value["digest"] = other.digest().into();
    value["asked"] = asked(&work.target, &work.placing).into();
    value["tools"] = versions(&work.target)?.into();
    // A call measures a unit of ours, too: the first one.
    let none = || Error::NothingRan("no unit is left to measure: name one with --unit".into());
    let first = work.jobs.first().map(|job| (job.unit.name.as_str(), job.clocks)).ok_or_else(none)?;
    Ok((figures, with_command(command(cli, a, first, Some(asked_for)), value)))
}

/// The call that measures this unit alone, and what stands beside it, the same way.
fn command(cli: &Cli, a: &SynthArgs, (unit, clocks): (&str, Option<u32>), beside: Option<&str>) -> String {
    let mut words = format!("reliefrtl synth --unit {unit}");
    let mut add = |key: &str, value: Option<String>| {
        if let Some(value) = value {
            words += &format!(" --{key} {}", word(&value));
        }
    };
    add("beside", beside.map(str::to_owned));
    add("latency", clocks.map(|l| l.to_string()));
    add("config", cli.config.as_ref().map(|p| p.display().to_string()));
    add("profile", cli.profile.map(|p| p.word().to_string()));
    add("clock", cli.clock.map(|mhz| mhz.to_string()));
    cli.sets.iter().for_each(|s| add("set", Some(s.split_whitespace().collect())));
    add("liberty", a.liberty.as_ref().map(|p| p.display().to_string()));
    let target = target(a).map_or("", |t| t.name());
    add("target", (!["ecp5", "liberty"].contains(&target)).then(|| target.to_string()));
    if target == "ecp5" {
        let placing = Placing::default();
        let seeds: Vec<String> = a.seeds.iter().map(u32::to_string).collect();
        add("seeds", (a.seeds != placing.seeds).then(|| seeds.join(",")));
        add("freq", (a.freq != placing.freq).then(|| a.freq.to_string()));
        add("timing-weight", a.timing_weight.map(|w| w.to_string()));
    }
    add("copies", (a.copies != 1).then(|| a.copies.to_string()));
    words
}

/// Runs `synth`.
pub fn run(cli: &Cli, a: &SynthArgs) -> Result<()> {
    if let Some(file) = &a.stale {
        return super::restate::stale(file);
    }
    if let Some(file) = &a.refresh {
        return super::restate::refresh(cli, file, if a.unit == ["all"] { &[] } else { &a.unit });
    }
    super::output::keep_inputs(&a.out, &[a.liberty.as_deref(), cli.config.as_deref()])?;
    if let Some(parent) = a.out.parent().filter(|p| !p.as_os_str().is_empty()) {
        std::fs::create_dir_all(parent).map_err(|e| Error::file("create", parent, e))?;
    }
    let out = super::output::sink(&a.out)?;
    let work = prepare(cli, a)?;
    a.beside.iter().try_for_each(|other| foreign(other).map(|_| ()))?;
    let mut done: Vec<Figures> = Vec::new();
    let mut all: Vec<Value> = Vec::new();
    for job in &work.jobs {
        let clocks = job.clocks.map_or(String::new(), |l| format!(" in {l} clocks"));
        let bar = spinner(cli, format!("{}{clocks} for {}", job.unit.name, work.target.name()));
        let (figures, value) = entry(cli, a, &work, job)?;
        bar.finish_and_clear();
        all.push(value);
        done.push(figures);
    }
    for other in &a.beside {
        let bar = spinner(cli, format!("{other} for {}", work.target.name()));
        let (figures, value) = beside(cli, a, &work, other)?;
        bar.finish_and_clear();
        all.push(value);
        done.push(figures);
    }
    let text = serde_json::to_string_pretty(&all).expect("plain data") + "\n";
    out.write(text.as_bytes())?;
    if cli.json {
        // Standard output has it already, if it goes there.
        if out != Sink::Standard {
            print!("{text}");
        }
    } else {
        print!("{}", rows(&done));
        let part = work.target.part().map_or("", |p| p.name);
        for f in done.iter().filter(|f| !f.misfits.is_empty()) {
            println!("does not fit: {} takes {} in {part}", f.unit, f.misfits.join(", "));
        }
    }
    Ok(())
}

/// The design with the latency of a unit of arithmetic.
fn at_latency(c: &Config, name: &str, clocks: u32) -> Result<Design> {
    let Some(key) = latency_key(name) else {
        return Err(Error::input(format!(
            "--latency {clocks} is for units of arithmetic, and {name} is none: its own clocks come from --profile, --clock or --set latency.*"
        )));
    };
    let mut c = c.clone();
    let of_set = |e: Error| Error::input(e.to_string().replace("(--set)", "(--latency)"));
    c.apply_set(&format!("latency.{key}={clocks}")).map_err(of_set)?;
    Ok(c.design())
}

/// A module that is not ours.
pub(super) struct Foreign {
    top: String,
    /// By name, in its order.
    files: Vec<(String, Vec<u8>)>,
}

impl Foreign {
    /// Digest of all files and their names.
    pub fn digest(&self) -> String {
        let mut hash = blake3::Hasher::new();
        for (name, text) in &self.files {
            hash.update(format!("{name}\0{}\0", text.len()).as_bytes());
            hash.update(text);
        }
        hash.finalize().to_hex()[..32].to_string()
    }
}

/// Name and files of a module that is not ours, from `TOP=DIR`.
pub(super) fn foreign(asked: &str) -> Result<Foreign> {
    let Some((top, dir)) = asked.split_once('=').filter(|(_, dir)| !dir.is_empty()) else {
        return Err(Error::input(format!("--beside {asked}: write TOP=DIR, a module and the directory of its files")));
    };
    check_module_name(top).map_err(|e| Error::input(format!("--beside {asked:?}: {e}")))?;
    let read = |path: &std::path::Path, e| Error::file("read", path, e);
    let dir = std::path::Path::new(dir);
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(dir).map_err(|e| read(dir, e))? {
        let path = entry.map_err(|e| read(dir, e))?.path();
        paths.extend(path.is_file().then_some(path));
    }
    paths.sort();
    let file = |p: &PathBuf| {
        let name = p.file_name().unwrap_or_default().to_string_lossy().into_owned();
        std::fs::read(p).map(|text| (name, text)).map_err(|e| read(p, e))
    };
    let files = paths.iter().map(file).collect::<Result<Vec<_>>>()?;
    if !files.iter().any(|f| f.0.ends_with(".v") || f.0.ends_with(".sv")) {
        return Err(Error::input(format!("--beside {asked}: {} holds no .v or .sv file", dir.display())));
    }
    Ok(Foreign { top: top.to_owned(), files })
}

/// What was measured, so that `report` knows it again.
fn design(d: &Design) -> Value {
    json!({"exp": d.format.exp, "man": d.format.man, "traverse": d.traverse, "mode": d.mode, "datapath": d.datapath, "latency": d.latency})
}

fn target(a: &SynthArgs) -> Result<Target> {
    Ok(match (a.target, &a.liberty) {
        (None | Some(SynthTarget::Liberty), Some(file)) => Target::Liberty(file.clone()),
        (Some(SynthTarget::Liberty), None) => return Err(Error::input("--target liberty needs --liberty FILE.lib")),
        (Some(_), Some(_)) => return Err(Error::input("--liberty names cells of its own: leave out --target")),
        (None | Some(SynthTarget::Ecp5), None) => Target::Ecp5,
        (Some(SynthTarget::Ice40), None) => Target::Ice40,
        (Some(SynthTarget::Xilinx), None) => Target::Xilinx,
    })
}

fn rows(done: &[Figures]) -> String {
    let line = |f: &Figures| {
        let (mhz, path) = match &f.clock {
            None => (String::new(), String::new()),
            Some(c) => {
                let p = &c.critical;
                let ns = format!("{:.1} + {:.1} ns, {} hops", p.logic_ns, p.routing_ns, p.hops);
                let names: Vec<&str> = [p.from.as_str()]
                    .into_iter()
                    .chain(p.via.iter().map(String::as_str))
                    .chain([p.to.as_str()])
                    .collect();
                (format!("{:.0}", c.median), format!("{} ({ns})", names.join(" > ")))
            }
        };
        let latency = f.latency.map_or("-".into(), |l| l.to_string());
        let area = f.area.map_or(String::new(), |a| format!("{a:.0}"));
        let depth = f.depth.map_or(String::new(), |d| d.to_string());
        let counts =
            [f.luts, f.carries, f.multipliers, f.memories, f.lut_memories, f.flip_flops].map(|n| n.to_string());
        [vec![f.unit.clone(), latency], counts.to_vec(), vec![depth, area, mhz, path]].concat()
    };
    let head = ["unit", "L", "LUT", "carry", "mult", "mem", "LUT mem", "FF", "depth", "area", "MHz", "critical path"];
    table(&head, &done.iter().map(line).collect::<Vec<_>>())
}
