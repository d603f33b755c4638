//! `reliefrtl bench`: speed of the engines.
use super::args::{BenchArgs, Cli};
use super::output::{spinner, table};
use super::views::{Pixels, look};
use crate::bench::Simulator;
use crate::config::View;
use crate::error::{Error, Result};
use crate::golden::RayInput;
use crate::interp::{BLOCK, Traffic};
use crate::ir::Binding;
use crate::project::{Scene, encode};
use crate::scene::evenly;
use crate::trace::{Pipeline, trace_interp};
use serde_json::json;
use std::time::{Duration, Instant};

/// Runs `bench`: golden model, interpreter on one thread and on all, Icarus and Verilator where they are installed.
pub fn run(cli: &Cli, a: &BenchArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    let d = c.design();
    let n = a.scene.count().unwrap_or(20_000);
    if n == 0 {
        return Err(Error::NothingRan("bench needs at least one ray".into()));
    }
    let scene = Scene::new(&c, a.scene.map.map.as_deref(), a.scene.map.resample)?;
    let views = look(&c, &a.scene, &scene, &[View::Oblique], Pixels::Some, None)?;
    let seen: Vec<RayInput> = views.iter().flat_map(|v| &v.rays).map(|x| encode(&c, x)).collect();
    let rays: Vec<RayInput> = evenly(&seen, Some(n)).into_iter().cycle().take(n).collect();
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
