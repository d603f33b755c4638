//! `reliefrtl list`: the units with their parameters and latency.
use super::args::Cli;
use super::output::table;
use crate::error::Result;
use crate::units;
use serde_json::json;

/// Runs `list`.
pub fn run(cli: &Cli) -> Result<()> {
    let c = super::config::load(cli)?;
    let design = c.design();
    let modules = units::all(&design);
    if cli.json {
        let rows: Vec<_> = modules
            .iter()
            .map(|m| {
                let params: serde_json::Map<_, _> =
                    m.params.iter().map(|p| (p.name.clone(), json!(p.default))).collect();
                json!({"unit": m.name, "summary": m.summary, "latency": m.latency, "parameters": params})
            })
            .collect();
        println!("{}", serde_json::to_string_pretty(&rows).expect("plain data"));
        return Ok(());
    }
    let t = units::traversal::traverse(&design);
    let rows: Vec<Vec<String>> = modules
        .iter()
        .map(|m| {
            let params: Vec<String> = m.params.iter().map(|p| format!("{}={}", p.name, p.default)).collect();
            let latency = match m.latency {
                Some(0) => "comb.".to_string(),
                Some(k) => k.to_string(),
                None => format!("{}+{}n+{}", t.setup, t.slots, t.finish),
            };
            vec![m.name.clone(), latency, params.join(" "), m.summary.clone()]
        })
        .collect();
    print!("{}", table(&["unit", "clocks", "parameters", "what it does"], &rows));
    println!(
        "\ntraverse: {} clocks of setup, {} for each of n iterations, {} to the result.",
        t.setup, t.slots, t.finish
    );
    Ok(())
}
