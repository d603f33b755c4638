//! What an engine checked, unit by unit.
use super::args::Cli;
use crate::engine::{Checked, CheckedFigures};

/// Prints what was checked.
pub fn print(cli: &Cli, done: &[Checked]) {
    if cli.json {
        let rows: Vec<CheckedFigures<'_>> = done.iter().map(Into::into).collect();
        println!("{}", serde_json::to_string_pretty(&rows).expect("plain data"));
        return;
    }
    for x in done {
        println!("{:<16} 0 of {} mismatched{}{}", x.unit, x.rows, if x.note.is_empty() { "" } else { "; " }, x.note);
    }
    let total: usize = done.iter().map(|x| x.rows).sum();
    let units = if done.len() == 1 { "unit" } else { "units" };
    println!("{} {units}, 0 of {total} vectors mismatched", done.len());
}
