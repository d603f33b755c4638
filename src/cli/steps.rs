//! `steps`: iterations per ray, beside the published table.
use super::args::{Cli, StepsArgs};
use super::output::table;
use super::views::{Pixels, Viewed, look};
use crate::config::{Config, DatapathKind, MapKind, ModeConfig, View};
use crate::error::Result;
use crate::golden::RayInput;
use crate::measure::{PUBLISHED, ROWS, Steps, TRIM_ROWS, steps as count};
use crate::project::{Scene, encode};
use crate::trace::trace_golden;
use serde_json::json;
use std::path::Path;

/// Runs `steps`.
pub fn run(cli: &Cli, a: &StepsArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    let Some(dir) = &a.scenes else {
        let scene = Scene::new(&c, a.scene.map.map.as_deref(), a.scene.map.resample)?;
        let views = look(&c, &a.scene, &scene, &c.view.names, Pixels::Some, a.scene.count())?;
        return print_steps(cli, &c, &scene, &views, None).map(|_| ());
    };
    c.map.published_border()?;
    let mut sums = vec![0.0; rows(&c).count()];
    let mut cells = Vec::new();
    for p in &PUBLISHED {
        let mut c = c.clone();
        (c.map.scale, c.map.repeat, c.map.kind) = (p.scale, p.repeat, MapKind::File);
        let file = dir.join(format!("{}.png", p.scene));
        let scene = Scene::new(&c, Some(Path::new(&file)), false)?;
        let views = look(&c, &a.scene, &scene, View::ALL, Pixels::Some, None)?;
        let (means, beside) = print_steps(cli, &c, &scene, &views, Some(&p.means))?;
        sums.iter_mut().zip(means).for_each(|(s, m)| *s += m);
        cells.extend(beside.into_iter().map(|x| Beside { what: format!("{}, {}", p.scene, x.what), ..x }));
    }
    if !cli.json {
        println!("mean over scenes and views, relative to {}:", ROWS[ROWS.len() - 1].0);
        let base = sums[ROWS.len() - 1];
        let row = |(r, s): ((&str, ModeConfig), &f64)| vec![r.0.to_string(), format!("{:.3}", s / base)];
        println!("{}", table(&["mode", "relative"], &rows(&c).zip(&sums).map(row).collect::<Vec<_>>()));
        println!("{}", Beside::verdict(&cells));
    }
    Ok(())
}

/// A mean beside the published one.
struct Beside {
    what: String,
    /// Ours / published - 1.
    off: f64,
    /// How far off it may be: what the published cameras are known to, and a grazing view hangs most on them.
    bound: f64,
}

impl Beside {
    fn verdict(cells: &[Self]) -> String {
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
}

/// The published rows, then those with fewer iterations, where the datapath has them.
fn rows(c: &Config) -> impl Iterator<Item = (&'static str, ModeConfig)> {
    let trims = c.datapath.kind != DatapathKind::Published;
    ROWS.into_iter().chain(TRIM_ROWS.into_iter().filter(move |_| trims))
}

/// Prints a scene's table; returns each row's means, summed over the views, and the means that have a published one beside them.
fn print_steps(
    cli: &Cli,
    c: &Config,
    scene: &Scene,
    views: &[Viewed],
    means: Option<&[[Option<f64>; 3]; 7]>,
) -> Result<(Vec<f64>, Vec<Beside>)> {
    let mut cells = Vec::new();
    let mut lines = Vec::new();
    let mut out = Vec::new();
    let mut sums = Vec::new();
    for (r, (name, mode)) in rows(c).enumerate() {
        let mut sum = 0.0;
        let mut row = vec![name.to_string()];
        for (v, view) in views.iter().enumerate() {
            let mut d = c.design();
            d.mode = mode;
            let rays: Vec<RayInput> = view.rays.iter().map(|x| encode(c, x)).collect();
            let s: Steps = count(&trace_golden(&d, &scene.pyramid, &rays)?);
            sum += s.mean;
            let published = means.and_then(|m| *m.get(r)?.get(v)?);
            let beside =
                published.map_or(String::new(), |p| format!(" / {p:.1} ({:+.1} %)", (s.mean / p - 1.0) * 100.0));
            row.push(format!("{:.2}{beside}", s.mean));
            cells.extend(published.map(|p| Beside {
                what: format!("{}, {}", view.set.name, name.trim()),
                off: s.mean / p - 1.0,
                bound: if view.set.standard() == Some(View::Grazing) { 0.1 } else { 0.03 },
            }));
            row.push(format!("{} @{} of {}", s.max, s.witness, s.rays + s.limits));
            out.push(json!({"scene": scene.name, "row": name, "view": view.set.name, "mean": s.mean, "published": published, "max": s.max, "max_ray": s.witness, "rays": s.rays, "given_up": s.limits}));
        }
        lines.push(row);
        sums.push(sum);
    }
    if cli.json {
        println!("{}", serde_json::to_string(&out).expect("plain data"));
    } else {
        let kind = if means.is_some() { "ours / published" } else { "ours" };
        println!("{}: iterations per ray, {kind}; max @ray of rays (every {}th pixel)", scene.name, c.view.stride);
        let columns = views.iter().flat_map(|view| [view.set.name.as_str(), "max"]);
        println!("{}", table(&["mode"].into_iter().chain(columns).collect::<Vec<_>>(), &lines));
    }
    Ok((sums, cells))
}
