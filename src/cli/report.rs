//! `reliefrtl report`: speed against error of every design, as one page, JSON and CSV.
use super::args::{Cli, ReportArgs};
use crate::error::Result;
use crate::report::page::{Extent, Plan, cells, files, write};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

/// Runs `report`.
pub fn run(cli: &Cli, a: &ReportArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    let extent = if a.full { Extent::Full } else { Extent::Standard };
    let plan = Plan::new(&c, extent, a.scenes.as_deref())?;
    let bar = ProgressBar::new(plan.cells.len() as u64);
    if cli.json || !std::io::stderr().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    let style = "{bar:40} {pos} of {len} measurements, {eta} left";
    bar.set_style(ProgressStyle::with_template(style).expect("template is well formed"));
    let (cells, work) = cells(&plan, &a.out, &|done, _| bar.set_position(done as u64))?;
    bar.finish_and_clear();
    write(&a.out, &files(&plan, &cells, &again(cli, a))?)?;
    let page = a.out.join("report.html");
    if cli.json {
        println!(
            "{}",
            serde_json::json!({"cells": cells.len(), "measured": work.measured, "taken": work.taken, "not_legal": plan.not_legal.len(), "page": page})
        );
    } else {
        println!(
            "{} measurements ({} from an earlier run), {} combinations not legal",
            cells.len(),
            work.taken,
            plan.not_legal.len()
        );
        println!("page in {}", page.display());
    }
    Ok(())
}

/// The command that makes the report again. Where it is written does not matter to what stands in it.
fn again(cli: &Cli, a: &ReportArgs) -> String {
    let mut out = "reliefrtl report".to_owned();
    if let Some(file) = &cli.config {
        out += &format!(" --config '{}'", file.display());
    }
    cli.sets.iter().for_each(|s| out += &format!(" --set '{s}'"));
    if let Some(dir) = &a.scenes {
        out += &format!(" --scenes '{}'", dir.display());
    }
    out + if a.full { " --full" } else { "" }
}
