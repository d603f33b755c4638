//! `steps`: iterations per ray, beside the published table.
use super::args::{Cli, StepsArgs};
use super::output::table;
use super::views::{Pixels, Viewed, look};
use crate::config::modes::BEST;
use crate::config::{Config, MapKind, View};
use crate::error::Result;
use crate::measure::PUBLISHED;
use crate::project::{Beside, ModeSteps, Scene, SceneSteps, scene_steps, step_rows};
use std::path::Path;

/// Runs `steps`.
pub fn run(cli: &Cli, a: &StepsArgs) -> Result<()> {
    let c = super::load::load(cli)?;
    let Some(dir) = &a.scenes else {
        let scene = Scene::new(&c, a.scene.map.map.as_deref(), a.scene.map.resample)?;
        let views = look(&c, &a.scene, &scene, &c.view.names, Pixels::Some, a.scene.count())?;
        return counted(cli, &c, &scene, &views, None).map(|_| ());
    };
    c.map.published_border()?;
    let mut sums = vec![0.0; step_rows(&c).len()];
    let mut cells = Vec::new();
    for p in &PUBLISHED {
        let mut c = c.clone();
        (c.map.scale, c.map.repeat, c.map.kind) = (p.scale, p.repeat, MapKind::File);
        let file = dir.join(format!("{}.png", p.scene));
        let scene = Scene::new(&c, Some(Path::new(&file)), false)?;
        let views = look(&c, &a.scene, &scene, &View::ALL, Pixels::Some, None)?;
        let found = counted(cli, &c, &scene, &views, Some(&p.means))?;
        sums.iter_mut().zip(found.sums()).for_each(|(s, m)| *s += m);
        cells.extend(found.beside.into_iter().map(|x| Beside { what: format!("{}, {}", p.scene, x.what), ..x }));
    }
    if cli.json {
        return Ok(());
    }
    let rows = step_rows(&c);
    if let [(name, _)] = &rows[..] {
        println!(
            "mean over scenes and views: {name}, {:.2} iterations a ray",
            sums[0] / (PUBLISHED.len() * View::ALL.len()) as f64
        );
    } else {
        println!("mean over scenes and views, relative to {}:", BEST.label());
        let base = rows.iter().zip(&sums).find(|row| row.0.1 == BEST).map_or(f64::NAN, |row| *row.1);
        let row = |((name, _), s): (&(String, _), &f64)| vec![name.clone(), format!("{:.3}", s / base)];
        println!("{}", table(&["mode", "relative"], &rows.iter().zip(&sums).map(row).collect::<Vec<_>>()));
        println!("{}", verdict(&cells));
    }
    Ok(())
}

fn verdict(cells: &[Beside]) -> String {
    let inside = cells.iter().filter(|c| c.off.abs() <= c.bound).count();
    let mut text = format!(
        "{inside} of {} means lie within 3 % (front, oblique) or 10 % (grazing) of the published one",
        cells.len()
    );
    for c in cells.iter().filter(|c| c.off.abs() > c.bound) {
        text += &format!("; not {}: {:+.1} %", c.what, c.off * 100.0);
    }
    text
}

/// Counts and prints a scene's table.
fn counted(
    cli: &Cli,
    c: &Config,
    scene: &Scene,
    views: &[Viewed],
    means: Option<&[[Option<f64>; 3]; 7]>,
) -> Result<SceneSteps> {
    let sets: Vec<_> = views.iter().map(|v| (&v.set, &v.rays[..])).collect();
    let found = scene_steps(c, scene, &sets, means)?;
    if cli.json {
        println!("{}", serde_json::to_string(&found.rows.concat()).expect("plain data"));
        return Ok(found);
    }
    let cell = |s: &ModeSteps| {
        let off = |p: f64| format!(" / {p:.1} ({:+.1} %)", (s.mean / p - 1.0) * 100.0);
        let beside = s.published.map_or(String::new(), off);
        [format!("{:.2}{beside}", s.mean), format!("{} @{} of {}", s.max, s.max_ray, s.rays + s.given_up)]
    };
    let named = step_rows(c).into_iter().zip(&found.rows);
    let lines = named.map(|((name, _), row)| [name.to_string()].into_iter().chain(row.iter().flat_map(cell)).collect());
    let kind = if means.is_some() { "ours / published" } else { "ours" };
    println!("{}: iterations per ray, {kind}; max @ray of rays (every {}th pixel)", scene.name, c.view.stride);
    let columns = views.iter().flat_map(|view| [view.set.name.as_str(), "max"]);
    let head = ["mode"].into_iter().chain(columns).collect::<Vec<_>>();
    println!("{}", table(&head, &lines.collect::<Vec<_>>()));
    Ok(found)
}
