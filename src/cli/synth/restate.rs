//! `reliefrtl synth --stale` and `--refresh`: figures that are kept, against the text that is emitted now.
use super::jobs::{beside, entry, prepare};
use crate::cli::args::{Cli, SynthArgs, Verb};
use crate::cli::output::spinner;
use crate::cli::shell::words;
use crate::error::{Error, Result};
use crate::files::{TABLE, read_named_text};
use crate::measured::{Entry, parse};
use crate::synth::{asked, digest, foreign};
use clap::Parser;
use serde_json::Value;
use std::path::Path;

/// An entry of a file of figures, and why it has to be measured again.
struct Kept {
    entry: Entry,
    value: Value,
}

fn read(file: &Path) -> Result<Vec<Kept>> {
    let text = read_named_text(file, TABLE)?;
    let wrong = |e: serde_json::Error| {
        Error::input(format!("{} is no list of figures as `reliefrtl synth --out` writes them: {e}", file.display()))
    };
    let entries = parse(&text).map_err(wrong)?;
    let values: Vec<Value> = serde_json::from_str(&text).map_err(wrong)?;
    Ok(entries.into_iter().zip(values).map(|(entry, value)| Kept { entry, value }).collect())
}

/// The call that an entry names.
fn call(entry: &Entry) -> Result<(Cli, SynthArgs)> {
    let wrong = |said: String| Error::input(format!("the figures' call {:?} can't be made: {said}", entry.command));
    let mut cli = Cli::try_parse_from(words(&entry.command)).map_err(|e| wrong(e.to_string()))?;
    match std::mem::replace(&mut cli.verb, Verb::List) {
        Verb::Synth(a) if a.unit.len() == 1 && a.latency.len() < 2 && a.beside.len() < 2 => Ok((cli, a)),
        _ => Err(wrong("it is not `reliefrtl synth` of one unit".into())),
    }
}

/// A figure that is no longer one.
const TEXT: &str = "was measured on another text";
/// A figure of this text, by tools that were asked for something else.
const FLOW: &str = "was measured by another flow";

/// Why an entry has to be measured again, if it has to be.
fn reason(entry: &Entry, value: &Value) -> Result<Option<&'static str>> {
    let (cli, a) = call(entry)?;
    if entry.digest.is_none() {
        return Ok(Some("was never measured on this text"));
    }
    let work = prepare(&cli, &a)?;
    let [job] = &work.jobs[..] else { return Err(Error::input(format!("{}: not one unit", entry.command))) };
    let now = match a.beside.first() {
        Some(other) => foreign(other)?.digest(),
        None => digest(&job.unit, work.placing.copies),
    };
    Ok(match &entry.digest {
        Some(d) if *d != now => Some(TEXT),
        _ if value["asked"] != asked(&work.target, &work.placing) => Some(FLOW),
        _ => None,
    })
}

/// Prints the calls of a file whose text has changed since.
///
/// # Errors
/// Exit code 1 if there are any of another text.
pub fn stale(file: &Path) -> Result<()> {
    let (mut old, mut open, mut good) = (0, 0, 0);
    for kept in read(file)? {
        let why = reason(&kept.entry, &kept.value)?;
        if let Some(why) = why {
            println!("{}  # {why}", kept.entry.command);
        }
        match why {
            // Its entry says what the tools were asked for.
            None | Some(FLOW) => good += 1,
            Some(TEXT) => old += 1,
            Some(_) => open += 1,
        }
    }
    println!("{good} figures are of the text that is emitted now, {old} are not, {open} were never measured on it");
    if old == 0 {
        return Ok(());
    }
    Err(Error::mismatch(format!(
        "{old} figures of {} are not of the text that is emitted now: `reliefrtl synth --refresh {}` measures them again",
        file.display(),
        file.display()
    )))
}

/// Measures again what has to be, one after the other; the file is written after each, so that a run that was interrupted goes on
/// where it was.
///
/// # Errors
/// A tool that is missing or fails.
pub fn refresh(cli: &Cli, file: &Path, only: &[String]) -> Result<()> {
    let mut all = read(file)?;
    for at in 0..all.len() {
        let kept = &all[at];
        let wanted = only.is_empty() || only.contains(&kept.entry.unit) || only.contains(&named(&kept.entry));
        if !wanted || reason(&kept.entry, &kept.value)?.is_none() {
            continue;
        }
        let (inner, a) = call(&kept.entry)?;
        let work = prepare(&inner, &a)?;
        let bar = spinner(cli, kept.entry.command.clone());
        let value = match a.beside.first() {
            Some(other) => beside(&inner, &a, &work, other)?.1,
            None => entry(&inner, &a, &work, &work.jobs[0])?.1,
        };
        bar.finish_and_clear();
        println!("{}: {}", kept.entry.command, value["clock"]["median"]);
        all[at].value = value;
        crate::files::write_atomic(file, lines(&all).as_bytes())?;
    }
    Ok(())
}

/// The unit of an entry that has no figures yet.
fn named(entry: &Entry) -> String {
    let words = entry.words();
    words.iter().position(|w| *w == "--unit").and_then(|at| words.get(at + 1)).unwrap_or(&"").to_string()
}

/// A file of figures: one entry a line.
fn lines(all: &[Kept]) -> String {
    let rows: Vec<String> = all.iter().map(|k| serde_json::to_string(&k.value).expect("plain data")).collect();
    format!("[\n{}\n]\n", rows.join(",\n"))
}
