//! `reliefrtl synth`: areas and clocks of units, as a table and in a file.
mod jobs;
mod restate;

use super::args::{Cli, SynthArgs};
use super::output::{spinner, table};
use crate::error::{Error, Result};
use crate::files::Sink;
use crate::synth::{Figures, foreign};
use jobs::{beside, entry, prepare};
use serde_json::Value;

/// Runs `synth`.
pub fn run(cli: &Cli, a: &SynthArgs) -> Result<()> {
    if let Some(file) = &a.stale {
        return restate::stale(file);
    }
    if let Some(file) = &a.refresh {
        return restate::refresh(cli, file, if a.unit == ["all"] { &[] } else { &a.unit });
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
