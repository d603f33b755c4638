//! How results and errors reach the user.
use super::args::Cli;
use crate::error::{Error, Finding, Result, exit};
use crate::files::{OutDir, Sink, tree_of};
use crate::interp::WaveFormat;
use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::json;
use std::io::IsTerminal;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
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
        note(text);
    }
}

/// Whether standard error is for machines (`--json`), too.
static FOR_MACHINES: AtomicBool = AtomicBool::new(false);

/// Says whether what stands on standard error is one JSON object a line.
pub fn for_machines(json: bool) {
    FOR_MACHINES.store(json, Ordering::SeqCst);
}

/// Says something on standard error that is no error.
pub fn note(text: impl std::fmt::Display) {
    if FOR_MACHINES.load(Ordering::SeqCst) {
        eprintln!("{}", json!({"note": text.to_string()}));
    } else {
        eprintln!("reliefrtl: {text}");
    }
}

/// Prints an error on standard error: one sentence, or one JSON object.
pub fn error(e: &Error) {
    if !FOR_MACHINES.load(Ordering::SeqCst) {
        eprintln!("reliefrtl: {e}");
        return;
    }
    let mut told = json!({"code": e.exit_code(), "kind": e.kind(), "message": e.to_string()});
    match e {
        Error::File { path, .. } => told["place"] = path.display().to_string().into(),
        Error::Mismatch(Finding { place: Some(place), .. }) => {
            told["place"] = serde_json::to_value(place).expect("plain data");
        }
        _ => {}
    }
    eprintln!("{}", json!({"error": told}));
}

/// Prints what is wrong with a command line: as clap says it, or as one JSON object.
pub fn usage(e: &clap::Error) {
    let dashed = dashed(e, std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()));
    if !FOR_MACHINES.load(Ordering::SeqCst) {
        let _ = e.print();
        if let Some(hint) = dashed {
            eprintln!("\n  tip: {hint}");
        }
        return;
    }
    let text = e.render().to_string();
    let mut parts = text.split("\n\n").map(|part| part.split_whitespace().collect::<Vec<_>>().join(" "));
    let message = parts.next().unwrap_or_default();
    let message = message.strip_prefix("error: ").unwrap_or(&message);
    let mut told = json!({"code": exit::USAGE, "kind": "usage", "message": message});
    if let Some(ContextValue::String(argument)) = e.get(ContextKind::InvalidArg) {
        told["place"] = argument.as_str().into();
    }
    let hints: Vec<String> = parts.filter(|part| !part.is_empty()).chain(dashed).collect();
    if !hints.is_empty() {
        told["hint"] = hints.join("; ").into();
    }
    eprintln!("{}", json!({"error": told}));
}

/// How an option takes a value that begins with a dash, where what was refused stands after an option that takes one.
fn dashed(e: &clap::Error, words: impl Iterator<Item = String>) -> Option<String> {
    let Some(ContextValue::String(refused)) = e.get(ContextKind::InvalidArg) else { return None };
    let words: Vec<String> = words.collect();
    let command = Cli::command();
    let verbs = command.get_subcommands().flat_map(|verb| verb.get_arguments());
    let long = |a: &clap::Arg| a.get_action().takes_values().then(|| a.get_long().map(|name| format!("--{name}")))?;
    let options: Vec<String> = command.get_arguments().chain(verbs).filter_map(long).collect();
    let pair = words.windows(2).find(|w| options.contains(&w[0]) && w[1].starts_with(refused.as_str()))?;
    let (option, value) = (&pair[0], &pair[1]);
    Some(format!("a value that begins with a dash is given as '{option}={value}', or if it is a file as './{value}'"))
}

/// Where a verb's one file goes; if that is standard output, what the verb says goes to standard error from here on.
///
/// # Errors
/// As [`Sink::new`]; a file of an emitted tree, which only the verbs replace that write it.
pub fn sink(out: &Path) -> Result<Sink> {
    let sink = Sink::new(out)?;
    if let Sink::File(place) = &sink
        && let Some(tree) = tree_of(place)
    {
        return Err(Error::input(format!(
            "cannot write {}: it is a file of the tree that was emitted into {}, choose another name",
            out.display(),
            tree.display()
        )));
    }
    if sink == Sink::Standard {
        super::print::keep_standard_output_free();
    }
    Ok(sink)
}

/// Where a verb's waveform goes beside its other result.
///
/// # Errors
/// As [`sink`] and [`WaveFormat::of`]; both on standard output or in one file.
pub fn wave_sink(path: &Path, beside: Option<&Sink>) -> Result<(Sink, WaveFormat)> {
    let (format, wave) = (WaveFormat::of(path)?, sink(path)?);
    if wave == Sink::Standard && beside == Some(&wave) {
        return Err(Error::input("--out and --wave both go to standard output: give one of them a file"));
    }
    // Both may be new: their directories are there.
    let place = |file: &Path| {
        let above = file.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Some((above.canonicalize().ok()?, file.file_name()?.to_owned()))
    };
    if let (Sink::File(a), Some(Sink::File(b))) = (&wave, beside)
        && place(a).is_some_and(|a| place(b) == Some(a))
    {
        return Err(Error::input(format!("--out and --wave both name {}: give each a file", path.display())));
    }
    Ok((wave, format))
}

/// Starts the tree that a verb writes, before its work.
///
/// # Errors
/// As [`OutDir::new`]; `-`, which is no directory.
pub fn directory(out: &Path) -> Result<OutDir> {
    no_dash(out)?;
    OutDir::new(out)
}

fn no_dash(out: &Path) -> Result<()> {
    if out.as_os_str() == "-" {
        return Err(Error::input(
            "--out - is standard output, which takes one file, and this verb writes a directory: name one (./- if it is called so)",
        ));
    }
    Ok(())
}

/// The tree of `--dir`, which has a directory `needed`.
///
/// # Errors
/// It is not there, or no such tree.
pub fn tree(dir: &Path, needed: &str) -> Result<()> {
    let why = match std::fs::metadata(dir) {
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => "is not there".to_owned(),
        Err(e) => return Err(Error::file("read", dir, e)),
        Ok(there) if !there.is_dir() => "is no directory".to_owned(),
        Ok(_) if !dir.join(needed).is_dir() => format!("holds no directory {needed}"),
        Ok(_) => return Ok(()),
    };
    Err(Error::input(format!("--dir {} {why}: name a tree that `build` wrote", dir.display())))
}

/// Makes the directory that a verb fills file by file, and sees that it can be written.
///
/// # Errors
/// As [`directory`].
pub fn open_directory(out: &Path) -> Result<()> {
    no_dash(out)?;
    crate::files::open_directory(out)
}

/// Refuses an output (`--out`, `--wave`) that would replace one of the inputs.
///
/// # Errors
/// One sentence that names the file.
pub fn keep_inputs(out: &Path, inputs: &[Option<&Path>]) -> Result<()> {
    let whole = |p: &Path| p.canonicalize().ok();
    // A device stays what it is.
    let Some(out_file) = whole(out).filter(|file| file.is_file()) else { return Ok(()) };
    if inputs.iter().flatten().any(|i| whole(i).as_deref() == Some(&out_file)) {
        return Err(Error::input(format!(
            "{} would replace the input of that name: choose another file",
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
