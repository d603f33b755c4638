//! Figures: `steps` (the published table), `accuracy` (against the exact oracle).
use super::args::{AccuracyArgs, Cli, StepsArgs};
use super::output::table;
use super::views::{Pixels, Viewed, look};
use crate::config::{Config, DatapathKind, MapKind, ModeConfig, View};
use crate::error::Result;
use crate::golden::RayInput;
use crate::project::{Scene, encode};
use crate::report::{DEFINITION, PUBLISHED, ROWS, Spread, Steps, TRIM_ROWS, steps as count, uv_given};
use crate::trace::trace_golden;
use serde_json::json;
use std::path::Path;

/// Runs `steps`.
pub fn steps(cli: &Cli, a: &StepsArgs) -> Result<()> {
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

/// Runs `accuracy`.
pub fn accuracy(cli: &Cli, a: &AccuracyArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    if let Some(dir) = &a.scenes {
        return super::rates::run(cli, &c, dir);
    }
    let (a, views) = (&a.scene.map, &a.scene);
    let own = a.map.is_none() && c.map.kind != MapKind::File;
    let kinds: Vec<MapKind> =
        if own { MapKind::ALL.iter().copied().filter(|k| *k != MapKind::File).collect() } else { vec![c.map.kind] };
    let (mut rows, mut witnesses, mut refined) = (Vec::new(), Vec::new(), super::refined::Refined::default());
    for kind in kinds {
        let mut c = c.clone();
        c.map.kind = kind;
        let scene = Scene::new(&c, a.map.as_deref(), a.resample)?;
        for Viewed { set, rays: seen } in look(&c, views, &scene, &c.view.names, Pixels::Some, views.count())? {
            let rays: Vec<RayInput> = seen.iter().map(|x| encode(&c, x)).collect();
            if c.mode.bilinear {
                refined.add(&c, &scene, a.map.as_deref(), &set.name, &seen)?;
            }
            let hits = trace_golden(&c.design(), &scene.pyramid, &rays)?;
            let r = crate::report::accuracy(&c.design(), &scene.texels, &rays, &hits)?;
            for w in &r.wrong {
                let q = &rays[w.ray];
                witnesses.push(vec![
                    scene.name.clone(),
                    set.name.clone(),
                    w.ray.to_string(),
                    format!("{:x} {:x} {:x} {:x}", q.u, q.v, q.du, q.dv),
                    format!("{}, {}", w.got.0, w.got.1),
                    format!("{}, {}", w.exact.0, w.exact.1),
                    format!("{:.1e}", w.margin),
                ]);
            }
            let numbers: Vec<[f64; 4]> = seen.iter().map(|r| [r.u, r.v, r.du, r.dv]).collect();
            let given = Spread::of(uv_given(&c.design(), &scene.texels, &numbers, &hits)?);
            let uv = Spread::of(r.uv);
            rows.push(vec![
                scene.name.clone(),
                set.name.clone(),
                format!("{} of {}", r.wrong.len(), r.rays),
                r.wrong_wall.to_string(),
                r.limits.to_string(),
                format!("{:.2e} @{}", r.worst_t.0, r.worst_t.1),
                format!("{:.2e}", uv.p99),
                format!("{:.2e} @{}", uv.max, uv.max_ray),
                format!("{:.2e}", given.p99),
            ]);
        }
    }
    let head = [
        "map",
        "view",
        "wrong texels",
        "wrong walls",
        "given up",
        "largest t error @ray",
        "uv error p99, texel",
        "largest @ray",
        "p99 of the rays as given",
    ];
    let each = ["map", "view", "ray", "u v du dv (hex)", "got", "exact", "margin"];
    let objects = |head: &[&str], rows: &[Vec<String>]| -> serde_json::Value {
        let object = |r: &Vec<String>| {
            head.iter().zip(r).map(|(k, v)| (k.to_string(), json!(v))).collect::<serde_json::Map<_, _>>()
        };
        rows.iter().map(object).collect::<Vec<_>>().into()
    };
    if cli.json {
        let mut value = json!({"views": objects(&head, &rows), "witnesses": objects(&each, &witnesses)});
        if c.mode.bilinear {
            value["bilinear"] = objects(&super::refined::HEAD, &refined.rows);
        }
        println!("{}", serde_json::to_string_pretty(&value).expect("plain data"));
    } else {
        print!("{}", table(&head, &rows));
        println!("{DEFINITION}; of the rays as given: before their rounding to words");
        println!("\nevery wrong texel (margin: how close the exact decision was, over the height range):");
        print!("{}", table(&each, &witnesses));
        if c.mode.bilinear {
            refined.print();
        }
    }
    Ok(())
}
