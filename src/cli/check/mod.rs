//! `reliefrtl check`: golden vectors replayed in an engine.
mod endless;

use super::args::{CheckArgs, Cli};
use super::checked;
use super::output::spinner;
use crate::config::Config;
use crate::emit::write_tree;
use crate::engine::{Checked, EngineName};
use crate::error::{Error, Result};
use crate::files::Scratch;
use crate::project::{
    FileCoverage, Scene, accepts, alone_files, alone_text, alone_vectors, check_tree_at, coverage, parameters, project,
    text, unit_vectors,
};
use crate::vectors::Level;
use std::path::{Path, PathBuf};

/// Runs `check`.
pub fn run(cli: &Cli, a: &CheckArgs) -> Result<()> {
    let (c, alone) = super::load::load_for(cli, &a.unit)?;
    if a.engine == EngineName::Golden {
        return Err(Error::input(
            "check --engine golden would compare the golden model with itself: use interp, icarus or verilator",
        ));
    }
    if a.wave.is_some() && a.engine != EngineName::Interp {
        return Err(Error::input("check --wave records the interpreter: leave out --engine, or set it to interp"));
    }
    if a.coverage && a.engine != EngineName::Verilator {
        return Err(Error::input("check --coverage is counted by Verilator: add --engine verilator"));
    }
    a.wave.as_deref().map_or(Ok(()), |wave| super::output::keep_inputs(wave, &[cli.config.as_deref()]))?;
    let wave = a.wave.as_deref().map(|path| super::output::wave_sink(path, None)).transpose()?;
    let campaign = a.campaign.campaign(!alone.is_empty())?;
    let over = parameters(&a.param)?;
    alone.iter().try_for_each(|m| accepts(m, &over))?;
    if !over.is_empty() && a.batches.is_some() {
        return Err(Error::input("--level 3 takes no --param: levels 1 and 2 do"));
    }
    if let Some(endless) = campaign.filter(|c| c.level == Level::Three) {
        let [m] = &alone[..] else { return Err(Error::input("--level 3 goes on until it is stopped: name one unit")) };
        return endless::run(cli, a, &c, m, endless);
    }
    if a.batches.is_some() {
        return Err(Error::input("--batches ends --level 3: levels 1 and 2 end by themselves"));
    }
    a.dir.as_deref().map_or(Ok(()), |dir| super::output::tree(dir, "golden"))?;
    let work = Scratch::new()?;
    let dir: PathBuf = match &a.dir {
        Some(dir) => dir.clone(),
        None => {
            let tree = work.path().join("tree");
            let files = match &alone[..] {
                [] if over.is_empty() => project(&c, &Scene::new(&c, None, false)?)?.files,
                [] => {
                    let mut files = text(&c)?.files;
                    for name in &a.unit {
                        files.extend(unit_vectors(&c, name, &over, None, false)?);
                    }
                    files
                }
                units if over.is_empty() => alone_files(&c, units, campaign)?,
                units => {
                    let mut files = alone_text(&c, units)?;
                    units.iter().for_each(|m| files.extend(alone_vectors(&c, m, &over, campaign)));
                    files
                }
            };
            write_tree(&tree, &files)?;
            tree
        }
    };
    if a.coverage {
        return covered(cli, &c, &dir);
    }
    let bar = spinner(cli, "checking");
    let seen = |x: &Checked| bar.set_message(format!("{} done", x.unit));
    let done = check_tree_at(&c, &dir, a.engine, &a.unit, &over, a.canary, wave.as_ref(), &seen);
    bar.finish_and_clear();
    let done = done?;
    // Of a tree that an engine has read, other text than what was generated is no fault (a netlist, a mutant): it is said.
    for x in crate::files::altered(&dir)?.iter().filter(|x| !x.path.starts_with("golden/")) {
        super::output::note(format_args!("{} {}", dir.join(&x.path).display(), x.is));
    }
    checked::print(cli, &done);
    match a.canary {
        Some(k) => Err(Error::ToolFailed(format!("the canary {k:?} was not noticed: this check can't fail"))),
        None => Ok(()),
    }
}

/// Replays all vectors in Verilator and prints what they reach.
fn covered(cli: &Cli, c: &Config, dir: &Path) -> Result<()> {
    let bar = spinner(cli, "counting");
    let found = coverage(c, dir);
    bar.finish_and_clear();
    let found = found?;
    if cli.json {
        let file = |(unit, f): (&String, &FileCoverage)| {
            serde_json::json!({
                "unit": unit, "branches_reached": f.branches[0], "branches": f.branches[1],
                "toggles_reached": f.toggles[0], "toggles": f.toggles[1], "with_a_reason": f.reasons,
            })
        };
        let files: Vec<_> = found.files.iter().map(file).collect();
        let all = serde_json::json!({"files": files, "unlisted": found.unlisted, "stale": found.stale});
        println!("{}", serde_json::to_string_pretty(&all).expect("plain data"));
    } else {
        for (unit, f) in &found.files {
            let ([b, all_b], [t, all_t]) = (f.branches, f.toggles);
            let left = all_b + all_t - b - t;
            println!(
                "{unit:<18} branches {b} of {all_b}, toggles {t} of {all_t}; {left} not reached, {} with a reason",
                f.reasons
            );
        }
        found.unlisted.iter().for_each(|p| println!("not reached, and no reason is listed: {p}"));
        if found.exact {
            found.stale.iter().for_each(|p| println!("on the list, {p}"));
        } else {
            println!("the list of reasons (src/units/unreached.toml) is that of the default configuration");
        }
    }
    let wrong = found.unlisted.len() + found.stale.len();
    match found.exact && wrong > 0 {
        true => Err(Error::mismatch(format!("{wrong} points or entries of the list of what is not reached are wrong"))),
        false => Ok(()),
    }
}
