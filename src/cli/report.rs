//! `reliefrtl report`: speed against error of every design, as one page, JSON and CSV.
use super::args::{Cli, RaysArg, ReportArgs};
use super::shell::quoted;
use crate::config::{Config, MapKind, View};
use crate::error::{Error, Result};
use crate::report::{Extent, Plan, Selection, files, measurements, write};
use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

/// Runs `report`.
pub fn run(cli: &Cli, a: &ReportArgs) -> Result<()> {
    super::output::open_directory(&a.out)?;
    let mut c = super::load::load(cli)?;
    c.map.resample |= a.scene.map.resample;
    let plan = Plan::new(&c, &selection(&c, a)?)?;
    if plan.jobs.is_empty() {
        let why = plan.not_legal.first().map_or("no design was chosen", |r| r.reason.as_str());
        return Err(Error::NothingRan(format!("nothing to measure: {why}")));
    }
    let bar = ProgressBar::new(plan.jobs.len() as u64);
    if cli.json || !std::io::stderr().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    let style = "{bar:40} {pos} of {len} measurements, {eta} left";
    bar.set_style(ProgressStyle::with_template(style).expect("template is well formed"));
    let resumed = format!("interrupted; the same command goes on from the measurements in {}", a.out.display());
    super::output::if_interrupted(Some(resumed));
    let (measurements, work) = measurements(&plan, &a.out, &|done, _| bar.set_position(done as u64))?;
    bar.finish_and_clear();
    let bar = super::output::spinner(cli, "pictures and bilinear refinement");
    write(&a.out, &files(&plan, &measurements, &again(cli, a))?)?;
    bar.finish_and_clear();
    let page = a.out.join("report.html");
    if cli.json {
        println!(
            "{}",
            serde_json::json!({"cells": measurements.len(), "measured": work.measured, "taken": work.taken, "altered": work.altered, "not_legal": plan.not_legal.len(), "page": page})
        );
    } else {
        println!(
            "{} measurements ({} from an earlier run), {} combinations not legal",
            measurements.len(),
            work.taken,
            plan.not_legal.len()
        );
        for path in &work.altered {
            println!("{path} is not what was measured (edited, or cut short): measured again");
        }
        println!("page in {}", page.display());
    }
    Ok(())
}

/// The command that makes the report again. Where it is written does not matter to what stands in it.
fn again(cli: &Cli, a: &ReportArgs) -> String {
    let mut out = "reliefrtl report".to_owned();
    if let Some(file) = &cli.config {
        out += &format!(" --config {}", quoted(&file.display().to_string()));
    }
    cli.sets.iter().for_each(|s| out += &format!(" --set {}", quoted(s)));
    let mut option = |name: &str, values: Vec<String>| {
        if !values.is_empty() {
            out += &format!(" --{name} {}", values.join(","));
        }
    };
    let path = |path: &Option<std::path::PathBuf>| path.iter().map(|p| quoted(&p.display().to_string())).collect();
    option("map", path(&a.scene.map.map));
    option("maps", a.maps.iter().map(|k| k.word().to_owned()).collect());
    option("scenes", path(&a.scenes));
    option("levels", a.levels.iter().map(u32::to_string).collect());
    option("view", a.scene.view.iter().map(|v| quoted(v)).collect());
    let rays = match &a.scene.rays {
        Some(RaysArg::Count(n)) => Some(n.to_string()),
        Some(RaysArg::File(file)) => Some(quoted(&file.display().to_string())),
        None => None,
    };
    option("rays", rays.into_iter().collect());
    option("datapaths", a.datapaths.iter().map(|k| k.word().to_owned()).collect());
    option("formats", a.formats.iter().map(|f| format!("{}/{}", f.exp, f.man)).collect());
    option("fractions", a.fractions.iter().map(u32::to_string).collect());
    let set = a.modes.and_then(|m| m.to_possible_value().map(|v| v.get_name().to_owned()));
    option("modes", set.into_iter().collect());
    option("synth", a.synth.iter().map(|p| quoted(&p.display().to_string())).collect());
    option("max-texels", a.scene.map.max_texels.iter().map(u64::to_string).collect());
    let flags = [
        (a.scene.map.resample, " --resample"),
        (a.scene.map.crop, " --crop"),
        (a.scene.map.pad, " --pad"),
        (a.full, " --full"),
    ];
    flags.iter().filter(|f| f.0).for_each(|f| out += f.1);
    out
}

/// What the command line chooses.
fn selection(c: &Config, a: &ReportArgs) -> Result<Selection> {
    if a.maps.contains(&MapKind::File) {
        return Err(Error::input("--maps names own maps; a file goes to --map FILE"));
    }
    // A configuration of fewer views (what `fit` wrote, say) has chosen.
    let usual = if c.view.names.len() < View::ALL.len() { &c.view.names[..] } else { &[] };
    let views = super::views::sets(&a.scene, usual, false)?;
    views.iter().try_for_each(super::views::block_rays)?;
    Ok(Selection {
        extent: if a.full { Extent::Full } else { Extent::Standard },
        map: a.scene.map.map.clone(),
        maps: a.maps.clone(),
        scenes: a.scenes.clone(),
        levels: a.levels.clone(),
        views,
        most: a.scene.count(),
        datapaths: a.datapaths.clone(),
        formats: a.formats.clone(),
        fractions: a.fractions.clone(),
        modes: a.modes,
        synth: a.synth.clone(),
        traversals: crate::catalogue::ray_units(),
    })
}
