//! Figures: `steps` (the published table), `accuracy` (against the exact oracle), `bench` (speed of the engines).
use super::args::{AccuracyArgs, BenchArgs, Cli, StepsArgs};
use super::output::{spinner, table};
use crate::bench::Simulator;
use crate::config::{Config, DatapathKind, MapKind, ModeConfig, View};
use crate::error::{Error, Result};
use crate::golden::RayInput;
use crate::interp::{BLOCK, Traffic};
use crate::ir::Binding;
use crate::project::{Scene, encode};
use crate::report::{PUBLISHED, ROWS, Steps, TRIM_ROWS, steps as count};
use crate::trace::{Pipeline, trace_golden, trace_interp};
use serde_json::json;
use std::path::Path;
use std::time::{Duration, Instant};

/// Runs `steps`.
pub fn steps(cli: &Cli, a: &StepsArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    let Some(dir) = &a.scenes else {
        let scene = Scene::new(&c, None, false)?;
        return print_steps(cli, &c, &scene, None).map(|_| ());
    };
    c.map.published_border()?;
    let mut sums = vec![0.0; rows(&c).count()];
    let mut cells = Vec::new();
    for p in &PUBLISHED {
        let mut c = c.clone();
        (c.map.scale, c.map.repeat, c.map.kind) = (p.scale, p.repeat, MapKind::File);
        let file = dir.join(format!("{}.png", p.scene));
        let scene = Scene::new(&c, Some(Path::new(&file)), false)?;
        let (means, beside) = print_steps(cli, &c, &scene, Some(&p.means))?;
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
    means: Option<&[[Option<f64>; 3]; 7]>,
) -> Result<(Vec<f64>, Vec<Beside>)> {
    let mut cells = Vec::new();
    let mut lines = Vec::new();
    let mut out = Vec::new();
    let mut sums = Vec::new();
    for (r, (name, mode)) in rows(c).enumerate() {
        let mut sum = 0.0;
        let mut row = vec![name.to_string()];
        for (v, view) in View::ALL.iter().enumerate() {
            let mut d = c.design();
            d.mode = mode;
            let rays: Vec<RayInput> = scene.view(c, *view, c.view.stride)?.iter().map(|x| encode(c, x)).collect();
            let s: Steps = count(&trace_golden(&d, &scene.pyramid, &rays)?);
            sum += s.mean;
            let published = means.and_then(|m| *m.get(r)?.get(v)?);
            let beside =
                published.map_or(String::new(), |p| format!(" / {p:.1} ({:+.1} %)", (s.mean / p - 1.0) * 100.0));
            row.push(format!("{:.2}{beside}", s.mean));
            cells.extend(published.map(|p| Beside {
                what: format!("{}, {}", view.word(), name.trim()),
                off: s.mean / p - 1.0,
                bound: if *view == View::Grazing { 0.1 } else { 0.03 },
            }));
            row.push(format!("{} @{} of {}", s.max, s.witness, s.rays + s.limits));
            out.push(json!({"scene": scene.name, "row": name, "view": view.word(), "mean": s.mean, "published": published, "max": s.max, "max_ray": s.witness, "rays": s.rays, "given_up": s.limits}));
        }
        lines.push(row);
        sums.push(sum);
    }
    if cli.json {
        println!("{}", serde_json::to_string(&out).expect("plain data"));
    } else {
        let kind = if means.is_some() { "ours / published" } else { "ours" };
        println!("{}: iterations per ray, {kind}; max @ray of rays (every {}th pixel)", scene.name, c.view.stride);
        println!("{}", table(&["mode", "front", "max", "oblique", "max", "grazing", "max"], &lines));
    }
    Ok((sums, cells))
}

/// Runs `accuracy`.
pub fn accuracy(cli: &Cli, a: &AccuracyArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    if let Some(dir) = &a.scenes {
        return super::rates::run(cli, &c, dir);
    }
    let a = &a.map;
    let own = a.map.is_none() && c.map.kind != MapKind::File;
    let kinds: Vec<MapKind> =
        if own { MapKind::ALL.iter().copied().filter(|k| *k != MapKind::File).collect() } else { vec![c.map.kind] };
    let (mut rows, mut witnesses, mut refined) = (Vec::new(), Vec::new(), super::refined::Refined::default());
    for kind in kinds {
        let mut c = c.clone();
        c.map.kind = kind;
        let scene = Scene::new(&c, a.map.as_deref(), a.resample)?;
        for view in View::ALL {
            let seen = scene.view(&c, *view, c.view.stride)?;
            let rays: Vec<RayInput> = seen.iter().map(|x| encode(&c, x)).collect();
            if c.mode.bilinear {
                refined.add(&c, &scene, a.map.as_deref(), *view, &seen)?;
            }
            let hits = trace_golden(&c.design(), &scene.pyramid, &rays)?;
            let r = crate::report::accuracy(&c.design(), &scene.texels, &rays, &hits)?;
            for w in &r.wrong {
                let q = &rays[w.ray];
                witnesses.push(vec![
                    scene.name.clone(),
                    view.word().into(),
                    w.ray.to_string(),
                    format!("{:x} {:x} {:x} {:x}", q.u, q.v, q.du, q.dv),
                    format!("{}, {}", w.got.0, w.got.1),
                    format!("{}, {}", w.exact.0, w.exact.1),
                    format!("{:.1e}", w.margin),
                ]);
            }
            rows.push(vec![
                scene.name.clone(),
                view.word().into(),
                format!("{} of {}", r.wrong.len(), r.rays),
                r.wrong_wall.to_string(),
                r.limits.to_string(),
                format!("{:.2e} @{}", r.worst_t.0, r.worst_t.1),
            ]);
        }
    }
    let head = ["map", "view", "wrong texels", "wrong walls", "given up", "largest t error @ray"];
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
        println!("\nevery wrong texel (margin: how close the exact decision was, over the height range):");
        print!("{}", table(&each, &witnesses));
        if c.mode.bilinear {
            refined.print();
        }
    }
    Ok(())
}

/// Runs `bench`: golden model, interpreter on one thread and on all, Icarus and Verilator where they are installed.
pub fn bench(cli: &Cli, a: &BenchArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    let d = c.design();
    let scene = Scene::new(&c, None, false)?;
    let rays: Vec<RayInput> = scene.view(&c, View::Oblique, 2)?.iter().map(|x| encode(&c, x)).collect();
    if rays.is_empty() || a.rays == 0 {
        return Err(Error::NothingRan("bench needs at least one ray".into()));
    }
    let rays: Vec<RayInput> = rays.iter().copied().cycle().take(a.rays).collect();
    let bar = spinner(cli, "measuring");
    let mut rows: Vec<(String, usize, Duration, Duration)> = Vec::new();
    let time = |f: &mut dyn FnMut() -> Result<()>| -> Result<Duration> {
        let start = Instant::now();
        f()?;
        Ok(start.elapsed())
    };
    let none = Duration::ZERO;
    let golden = crate::golden::Tracer::new(&d)?;
    let mut sink = 0;
    let t = time(&mut || {
        rays.iter().for_each(|r| sink += golden.trace(&scene.pyramid, r).steps);
        Ok(())
    })?;
    rows.push(("golden, 1 thread".into(), rays.len(), none, t));
    let start = Instant::now();
    let p = Pipeline::new(&d, &Binding::new())?;
    let build = start.elapsed();
    let t = time(&mut || p.run(&scene.pyramid, &rays, BLOCK, Traffic::default()).map(|_| ()))?;
    rows.push(("interpreter, 1 thread".into(), rays.len(), build, t));
    let t = time(&mut || trace_interp(&d, &scene.pyramid, &rays).map(|_| ()))?;
    rows.push((format!("interpreter, {} threads", rayon::current_num_threads()), rays.len(), build, t));
    for (sim, n) in [(Simulator::Verilator, rays.len()), (Simulator::Icarus, rays.len().min(500))] {
        bar.set_message(format!("measuring {}", sim.name()));
        match super::trace::timed(&c, sim, &scene, &rays[..n]) {
            Ok((build, run)) => rows.push((sim.name().into(), n, build, run)),
            Err(Error::ToolMissing(e)) => eprintln!("reliefrtl: left out: {e}"),
            Err(e) => return Err(e),
        }
    }
    bar.finish_and_clear();
    let rate = |r: &(String, usize, Duration, Duration)| r.1 as f64 / r.3.as_secs_f64();
    let base = rows.iter().find(|r| r.0 == "verilator").map(&rate);
    let text: Vec<Vec<String>> = rows
        .iter()
        .map(|r| {
            let ratio = base.map_or("-".into(), |b| match rate(r) / b {
                small if small < 0.1 => format!("{small:.4}"),
                ratio => format!("{ratio:.2}"),
            });
            vec![
                r.0.clone(),
                r.1.to_string(),
                format!("{:.2}", r.2.as_secs_f64()),
                format!("{:.2}", r.3.as_secs_f64()),
                format!("{:.0}", rate(r)),
                ratio,
            ]
        })
        .collect();
    let head = ["engine", "rays", "build s", "run s", "rays/s", "of verilator"];
    if cli.json {
        let value: Vec<_> = text
            .iter()
            .map(|r| head.iter().zip(r).map(|(k, v)| (k.to_string(), json!(v))).collect::<serde_json::Map<_, _>>())
            .collect();
        println!("{}", serde_json::to_string_pretty(&value).expect("plain data"));
    } else {
        print!("{}", table(&head, &text));
        println!(
            "map {}, oblique view, {} iterations in all (golden); simulators load the pyramid and compare as well; Icarus, the slowest, takes the first {} rays",
            scene.name,
            sink,
            rays.len().min(500)
        );
    }
    Ok(())
}
