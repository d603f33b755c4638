//! `reliefrtl list`: the units with their parameters and latency.
use super::args::Cli;
use super::output::table;
use crate::catalogue::has_vectors;
use crate::config::Design;
use crate::error::Result;
use crate::ir::Module;
use crate::units;
use crate::units::traversal::{Datapath, PUBLISHED, Traverse, loop_resources, traverse};
use serde::Serialize;
use std::sync::Arc;

/// What `list --json` prints.
#[derive(Serialize)]
struct Listed<'a> {
    /// Units of this design.
    units: Vec<ListedUnit<'a>>,
    /// Units that could be emitted with it.
    available: Vec<Available<'a>>,
    /// What stands in the loop, beside the published one.
    r#loop: Vec<InLoop>,
}

/// A unit that is emitted.
#[derive(Serialize)]
struct ListedUnit<'a> {
    /// Its name.
    unit: &'a str,
    /// What it does.
    summary: &'a str,
    /// Clocks; none where a handshake decides.
    latency: Option<u32>,
    /// Parameters with their defaults, in the order of the text.
    parameters: serde_json::Map<String, serde_json::Value>,
    /// It has vectors of its own.
    vectors: bool,
}

impl<'a> ListedUnit<'a> {
    fn new(design: &Design, m: &'a Module) -> Self {
        let parameters = m.params.iter().map(|p| (p.name.clone(), p.default.into())).collect();
        Self { unit: &m.name, summary: &m.summary, latency: m.latency(), parameters, vectors: has_vectors(design, m) }
    }
}

/// A unit that could be emitted.
#[derive(Serialize)]
struct Available<'a> {
    /// Its name.
    unit: &'a str,
    /// What it does.
    summary: &'a str,
    /// Clocks.
    latency: Option<u32>,
}

/// How often something stands in the loop.
#[derive(Serialize)]
struct InLoop {
    /// What.
    what: &'static str,
    /// In this design.
    here: u32,
    /// In the published unit.
    published: u32,
    /// Why they differ; empty where they don't.
    why: &'static str,
}

/// Runs `list`.
pub fn run(cli: &Cli) -> Result<()> {
    let c = super::load::load(cli)?;
    let design = c.design();
    let modules = units::all(&design);
    let t = traverse(&design);
    if cli.json {
        let available = more(&design);
        let rows = Listed {
            units: modules.iter().map(|m| ListedUnit::new(&design, m)).collect(),
            available: available
                .iter()
                .map(|m| Available { unit: &m.name, summary: &m.summary, latency: m.latency() })
                .collect(),
            r#loop: in_loop(&design, &t),
        };
        println!("{}", serde_json::to_string_pretty(&rows).expect("plain data"));
        return Ok(());
    }
    let row = |m: &Arc<Module>| {
        let params: Vec<String> = m.params.iter().map(|p| format!("{}={}", p.name, p.default)).collect();
        let latency = match m.latency() {
            Some(0) => "comb.".to_string(),
            Some(k) => k.to_string(),
            // A handshake takes as long as it is held.
            None if m.name != t.module.name => "-".to_string(),
            None => format!("{}+{}n+{}", t.setup, t.slots, t.finish),
        };
        let vectors = if has_vectors(&design, m) { "own" } else { &t.module.name };
        vec![m.name.clone(), latency, vectors.to_owned(), params.join(" "), m.summary.clone()]
    };
    let rows: Vec<Vec<String>> = modules.iter().map(row).collect();
    print!("{}", table(&["unit", "clocks", "vectors", "parameters", "what it does"], &rows));
    let rows: Vec<Vec<String>> = more(&design).iter().map(row).collect();
    if !rows.is_empty() {
        println!("\navailable, and emitted where `emit.units` or `emit --unit` names them:");
        print!("{}", table(&["unit", "clocks", "vectors", "parameters", "what it does"], &rows));
    }
    println!("\nvectors: a unit's own, or only those of traverse, whose rays go through it.");
    println!(
        "traverse: {} clocks of setup, {} for each of n iterations, {} to the result.",
        t.setup, t.slots, t.finish
    );
    if design.datapath.kind.start_trips(&design.mode) > 0 {
        println!(
            "A ray's first trip round the loop finds its start level and is no iteration: {} clocks more.",
            t.slots
        );
    }
    let listed = |m: &&Arc<Module>| !modules.iter().any(|u| u.name == m.name);
    let below: Vec<String> = crate::emit::modules(&modules)?.iter().filter(listed).map(|m| m.name.clone()).collect();
    if !below.is_empty() {
        println!("Emitted beside these, without vectors of their own: {} (delay lines of traverse).", below.join(", "));
    }
    let line = |r: &InLoop| vec![r.what.to_owned(), r.here.to_string(), r.published.to_string(), r.why.to_owned()];
    let rows: Vec<Vec<String>> = in_loop(&design, &t).iter().map(line).collect();
    println!(
        "\nin the loop of the {} datapath, beside the published one (PIDM-HW table 1, figure 7):",
        c.datapath.kind.word()
    );
    print!("{}", table(&["what", "here", "published", "why"], &rows));
    Ok(())
}

/// Units that are not emitted with this design but could be.
fn more(d: &Design) -> Vec<Arc<Module>> {
    let mut list = units::available(d);
    list.retain(|m| !units::arithmetic(d).iter().any(|o| o.name == m.name));
    list
}

/// Floating-point units and stages of the loop beside the published ones, with the reason where they differ.
fn in_loop(d: &Design, t: &Traverse) -> Vec<InLoop> {
    let rows = loop_resources(d, t).rows().into_iter().zip(PUBLISHED.rows());
    rows.map(|((what, here), (_, published))| {
        let why = if here == published { "" } else { (Datapath::of(d).difference)(what) };
        InLoop { what, here, published, why }
    })
    .collect()
}
