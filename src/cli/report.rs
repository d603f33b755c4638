//! `reliefrtl report`: speed against error of every design, as one page, JSON and CSV.
use super::args::{Cli, ReportArgs};
use crate::error::Result;
use crate::report::page::{Extent, Plan, cells};
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
    println!("{} cells, {work:?}", cells.len());
    Ok(())
}
