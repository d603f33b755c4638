//! How results and errors reach the user.
use super::args::Cli;
use crate::emit::Files;
use crate::error::{Error, Finding, Result};
use crate::files::{OutDir, Part};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// What to say when the run is interrupted.
static IF_INTERRUPTED: Mutex<Option<String>> = Mutex::new(None);

/// Says what to do after an interrupt, if there is one from now on.
pub fn if_interrupted(text: Option<String>) {
    *IF_INTERRUPTED.lock().unwrap_or_else(PoisonError::into_inner) = text;
}

/// Called on an interrupt.
pub fn interrupted() {
    if let Some(text) = &*IF_INTERRUPTED.lock().unwrap_or_else(PoisonError::into_inner) {
        eprintln!("reliefrtl: {text}");
    }
}

/// Prints an error: one sentence, or one JSON object.
pub fn error(cli: &Cli, e: &Error) {
    if cli.json {
        let mut told = serde_json::json!({"error": e.to_string(), "exit_code": e.exit_code()});
        if let Error::Mismatch(Finding { place: Some(place), .. }) = e {
            told["first"] = serde_json::to_value(place).expect("plain data");
        }
        println!("{told}");
    } else {
        eprintln!("reliefrtl: {e}");
    }
}

/// Writes `files` under `out`: all of them, or none.
///
/// # Errors
/// If the directory can't be written.
pub fn write_tree(out: &Path, files: &Files) -> Result<()> {
    let mut dir = OutDir::new(out)?;
    files.iter().try_for_each(|(path, text)| dir.add(path, text.as_bytes()))?;
    dir.commit().map(|_| ())
}

/// Writes `files` under `out` beside what else was generated there, or nothing.
///
/// # Errors
/// If the directory can't be written, or holds what does not go with them.
pub fn write_part(out: &Path, files: &Files, part: Part) -> Result<()> {
    let mut dir = OutDir::part(out, part)?;
    files.iter().try_for_each(|(path, text)| dir.add(path, text.as_bytes()))?;
    dir.commit().map(|_| ())
}

/// Refuses an output that would replace one of the inputs.
///
/// # Errors
/// One sentence that names the file.
pub fn keep_inputs(out: &Path, inputs: &[Option<&Path>]) -> Result<()> {
    let whole = |p: &Path| p.canonicalize().ok();
    let Some(out_file) = whole(out) else { return Ok(()) };
    if inputs.iter().flatten().any(|i| whole(i).as_deref() == Some(&out_file)) {
        return Err(Error::input(format!(
            "--out {} would replace the input of that name: choose another file",
            out.display()
        )));
    }
    Ok(())
}

/// A spinner with a text, on a terminal only.
pub fn spinner(cli: &Cli, text: impl Into<String>) -> ProgressBar {
    let bar = ProgressBar::new_spinner();
    if cli.json || !std::io::stderr().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    bar.set_style(ProgressStyle::with_template("{spinner} {msg} {elapsed}").expect("template is well formed"));
    bar.set_message(text.into());
    bar.enable_steady_tick(Duration::from_millis(120));
    bar
}

/// Rows as a table with aligned columns; numbers to the right.
pub fn table(head: &[&str], rows: &[Vec<String>]) -> String {
    let width = |c: usize| rows.iter().map(|r| r[c].chars().count()).chain([head[c].len()]).max().unwrap_or(0);
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    let numeric = |c: usize| {
        let is_number = |s: &String| s.is_empty() || s.starts_with(|x: char| x.is_ascii_digit() || x == '-');
        !rows.is_empty() && rows.iter().all(|r| is_number(&r[c]))
    };
    let line = |cells: Vec<&str>| {
        let parts: Vec<String> = cells
            .iter()
            .enumerate()
            .map(
                |(c, s)| if numeric(c) { format!("{s:>w$}", w = widths[c]) } else { format!("{s:<w$}", w = widths[c]) },
            )
            .collect();
        parts.join("  ").trim_end().to_string() + "\n"
    };
    let mut out = line(head.to_vec());
    rows.iter().for_each(|r| out += &line(r.iter().map(String::as_str).collect()));
    out
}
