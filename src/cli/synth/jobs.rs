//! What a call of `synth` measures, and what is kept of it.
use crate::catalogue::{self, timed};
use crate::cli::args::{Cli, SynthArgs, SynthTarget};
use crate::cli::shell::word;
use crate::config::{Config, DatapathConfig, Design, LatencyConfig, ModeConfig, TraverseConfig};
use crate::error::{Error, Result};
use crate::ir::Module;
use crate::synth::{Figures, Placing, Target, asked, digest, foreign, measure, measure_files, versions};
use serde::Serialize;
use serde_json::Value;
use std::sync::Arc;

/// A unit to measure.
pub(super) struct Job {
    /// The unit.
    pub unit: Arc<Module>,
    /// Its design.
    design: Design,
    /// Clocks that were asked for.
    pub clocks: Option<u32>,
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
    let c = crate::cli::load::load_for(cli, &a.unit)?.0;
    let d = c.design();
    let all: Vec<String> = catalogue::units(&d).into_iter().map(|m| m.name.clone()).collect();
    let mut names = if a.unit == ["all"] { all } else { a.unit.clone() };
    if a.unit == ["all"] && !a.latency.is_empty() {
        names.retain(|name| timed().iter().any(|u| u.unit == name));
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

/// The design with the latency of a unit of arithmetic.
fn at_latency(c: &Config, name: &str, clocks: u32) -> Result<Design> {
    let Some(key) = timed().iter().find(|u| u.unit == name).map(|u| u.key) else {
        return Err(Error::input(format!(
            "--latency {clocks} is for units of arithmetic, and {name} is none: its own clocks come from --profile, --clock or --set latency.*"
        )));
    };
    let mut c = c.clone();
    let of_set = |e: Error| Error::input(e.to_string().replace("(--set)", "(--latency)"));
    c.apply_set(&format!("latency.{key}={clocks}")).map_err(of_set)?;
    Ok(c.design())
}

/// What was measured, so that `report` knows it again.
#[derive(Serialize)]
struct Measured {
    exp: u32,
    man: u32,
    traverse: TraverseConfig,
    mode: ModeConfig,
    datapath: DatapathConfig,
    latency: LatencyConfig,
}

fn design(d: &Design) -> Value {
    let Design { format, traverse, mode, datapath, latency, .. } = *d;
    let measured = Measured { exp: format.exp, man: format.man, traverse, mode, datapath, latency };
    serde_json::to_value(measured).expect("plain data")
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
