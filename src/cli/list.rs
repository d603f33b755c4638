//! `reliefrtl list`: the units with their parameters and latency.
use super::args::Cli;
use super::output::table;
use crate::catalogue::has_vectors;
use crate::config::Design;
use crate::error::Result;
use crate::ir::Module;
use crate::units;
use crate::units::traversal::{Datapath, PUBLISHED, Traverse, loop_resources, traverse};
use serde_json::json;
use std::sync::Arc;

/// Runs `list`.
pub fn run(cli: &Cli) -> Result<()> {
    let c = super::load::load(cli)?;
    let design = c.design();
    let modules = units::all(&design);
    let t = traverse(&design);
    if cli.json {
        let rows: Vec<_> = modules
            .iter()
            .map(|m| {
                let params: serde_json::Map<_, _> =
                    m.params.iter().map(|p| (p.name.clone(), json!(p.default))).collect();
                json!({"unit": m.name, "summary": m.summary, "latency": m.latency, "parameters": params, "vectors": has_vectors(&design, m)})
            })
            .collect();
        let more: Vec<_> =
            more(&design).iter().map(|m| json!({"unit": m.name, "summary": m.summary, "latency": m.latency})).collect();
        let rows = json!({"units": rows, "available": more, "loop": in_loop(&design, &t)});
        println!("{}", serde_json::to_string_pretty(&rows).expect("plain data"));
        return Ok(());
    }
    let row = |m: &Arc<Module>| {
        let params: Vec<String> = m.params.iter().map(|p| format!("{}={}", p.name, p.default)).collect();
        let latency = match m.latency {
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
    let text = |v: &serde_json::Value| v.as_str().map_or_else(|| v.to_string(), str::to_string);
    let line = |r: &serde_json::Value| ["what", "here", "published", "why"].map(|k| text(&r[k])).to_vec();
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
fn in_loop(d: &Design, t: &Traverse) -> Vec<serde_json::Value> {
    let rows = loop_resources(d, t).rows().into_iter().zip(PUBLISHED.rows());
    rows.map(|((what, here), (_, published))| {
        let why = if here == published { "" } else { (Datapath::of(d).difference)(what) };
        json!({"what": what, "here": here, "published": published, "why": why})
    })
    .collect()
}
