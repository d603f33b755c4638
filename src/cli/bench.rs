//! `reliefrtl bench`: speed of the engines on the same rays, in turns, by processor time.
use super::args::{BenchArgs, Cli};
use super::output::{spinner, table};
use super::views::{Pixels, look};
use crate::bench::{COMPILERS, Harness, Load, Simulator};
use crate::config::{Config, View};
use crate::error::{Error, Result};
use crate::golden::{RayInput, Tracer};
use crate::interp::{BLOCK, Traffic};
use crate::ir::Binding;
use crate::measure::turns::{Spread3, Turns};
use crate::process;
use crate::project::{self, Scene, encode};
use crate::scene::evenly;
use crate::trace::{Pipeline, hit_row};
use cpu_time::ThreadTime;
use serde_json::{Value, json};
use std::time::Instant;

/// Rays that Icarus takes: it is far slower than the rest.
const ICARUS: usize = 500;

/// An engine, and what was measured of it.
struct Engine {
    name: String,
    /// Rays a turn.
    rays: usize,
    /// Seconds until it can run: elaboration, or Verilator and the compiler.
    build_s: f64,
    /// Seconds in which the pyramid is loaded, each turn; none where nothing is copied.
    load_s: Option<f64>,
    /// Seconds of each turn.
    turns: Vec<f64>,
    /// What they are: processor time, but where several threads work.
    wall: bool,
}

/// What every engine gets.
struct Task {
    scene: Scene,
    rays: Vec<RayInput>,
    /// The golden model's hits, as words of the ports.
    expected: Vec<Vec<u64>>,
    iterations: u64,
}

/// Runs `bench`.
pub fn run(cli: &Cli, a: &BenchArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    let d = c.design();
    let n = a.scene.count().unwrap_or(20_000);
    if n == 0 {
        return Err(Error::NothingRan("bench needs at least one ray".into()));
    }
    let scene = Scene::new(&c, a.scene.map.map.as_deref(), a.scene.map.resample)?;
    let views = look(&c, &a.scene, &scene, &[View::Oblique], Pixels::Some, None)?;
    let names: Vec<&str> = views.iter().map(|v| v.set.name.as_str()).collect();
    let seen: Vec<RayInput> = views.iter().flat_map(|v| &v.rays).map(|x| encode(&c, x)).collect();
    let rays: Vec<RayInput> = evenly(&seen, Some(n)).into_iter().cycle().take(n).collect();
    let golden = Tracer::new(&d)?;
    let hits: Vec<_> = rays.iter().map(|r| golden.trace(&scene.pyramid, r)).collect();
    let iterations = hits.iter().map(|h| u64::from(h.steps)).sum();
    let expected = hits.iter().map(|h| hit_row(&d, h)).collect();
    let task = Task { scene, rays, expected, iterations };
    let bar = spinner(cli, "measuring");
    let (engines, left_out) = measure(&c, &task, a.turns as usize, &|what| bar.set_message(what.to_owned()))?;
    bar.finish_and_clear();
    left_out.iter().for_each(|e| super::output::note(format_args!("left out: {e}")));
    print(cli, &task, &names, &engines);
    Ok(())
}

/// Builds all engines, then measures them in turns: each once, and again, so that what else the machine does meets all of them.
fn measure(c: &Config, task: &Task, turns: usize, tell: &dyn Fn(&str)) -> Result<(Vec<Engine>, Vec<Error>)> {
    let (d, n) = (c.design(), task.rays.len());
    let engine = |name: String, rays: usize, build_s: f64, wall: bool| Engine {
        name,
        rays,
        build_s,
        load_s: None,
        turns: Vec::new(),
        wall,
    };
    let golden = Tracer::new(&d)?;
    let start = Instant::now();
    let p = Pipeline::new(&d, &Binding::new())?;
    let stream = p.stream();
    let built = start.elapsed().as_secs_f64();
    let threads = rayon::current_num_threads();
    let (mut harnesses, mut left_out) = (Vec::new(), Vec::new());
    let hardware = project::hardware(c)?;
    let top = format!("{}traverse", c.emit.prefix);
    let (images, items) = p.words(&task.scene.pyramid, &task.rays);
    let memory: Vec<u64> = task.scene.pyramid.memory().iter().map(|w| u64::from(*w)).collect();
    let load = Load { memory: &memory, rays: &items, expected: &task.expected };
    for compiler in COMPILERS.into_iter().filter(|compiler| process::starts(compiler)) {
        tell(&format!("building the harness in Verilator with {compiler}"));
        match Harness::new(compiler, &hardware.files, &hardware.traverse.module, &top) {
            Ok(harness) => {
                harness.load(&load)?;
                harnesses.push((compiler, harness));
            }
            Err(e @ Error::ToolMissing(_)) => left_out.push(e),
            Err(e) => return Err(e),
        }
    }
    let mut all = vec![
        engine("golden, 1 thread".into(), n, 0.0, false),
        engine("interpreter, 1 thread".into(), n, built, false),
        engine(format!("interpreter, {threads} threads"), n, built, true),
    ];
    all.extend(harnesses.iter().map(|(cxx, h)| engine(format!("verilator, {cxx}"), n, h.build.as_secs_f64(), false)));
    for turn in 1..=turns {
        tell(&format!("turn {turn} of {turns}"));
        let start = ThreadTime::now();
        let steps: u64 = task.rays.iter().map(|r| u64::from(golden.trace(&task.scene.pyramid, r).steps)).sum();
        all[0].turns.push(start.elapsed().as_secs_f64());
        let start = ThreadTime::now();
        let one = stream.run(&items, &images, BLOCK, Traffic::default())?.results;
        all[1].turns.push(start.elapsed().as_secs_f64());
        let start = Instant::now();
        let many = stream.run_parallel(&items, &images, BLOCK, threads, Traffic::default())?.results;
        all[2].turns.push(start.elapsed().as_secs_f64());
        if steps != task.iterations || one != task.expected || many != task.expected {
            return Err(Error::mismatch("the interpreter's hits differ from the golden model's: `check` says where"));
        }
        for (k, (_, harness)) in harnesses.iter().enumerate() {
            let run = harness.run()?;
            all[3 + k].turns.push(run.run_s);
            all[3 + k].load_s = Some(run.load_s);
        }
    }
    let few = n.min(ICARUS);
    tell("measuring Icarus");
    match super::trace::timed(c, Simulator::Icarus, &task.scene, &task.rays[..few]) {
        Ok((build, run)) => {
            let turns = vec![run.as_secs_f64()];
            all.push(Engine { turns, ..engine("icarus".into(), few, build.as_secs_f64(), true) });
        }
        Err(e @ Error::ToolMissing(_)) => left_out.push(e),
        Err(e) => return Err(e),
    }
    Ok((all, left_out))
}

/// The fastest build of Verilator: what the others are compared with.
fn strongest(engines: &[Engine]) -> Option<&Engine> {
    let built = engines.iter().filter(|e| e.name.starts_with("verilator"));
    built.min_by(|a, b| Turns::median(&a.turns).total_cmp(&Turns::median(&b.turns)))
}

fn print(cli: &Cli, task: &Task, views: &[&str], engines: &[Engine]) {
    let base = strongest(engines);
    let ratio = |e: &Engine| base.and_then(|base| Turns::pairs((&base.turns, base.rays), (&e.turns, e.rays)));
    let rate = |e: &Engine| e.rays as f64 / Turns::median(&e.turns);
    let time = |e: &Engine| if e.wall { "wall" } else { "processor" };
    if cli.json {
        let three = |s: Spread3| json!({"min": s.min, "median": s.median, "max": s.max});
        let value = |e: &Engine| {
            let pairs = ratio(e).map(|r| json!({"min": r.min, "median": r.median, "max": r.max, "pairs": r.count}));
            json!({"engine": e.name, "rays": e.rays, "time": time(e), "build_s": e.build_s, "load_s": e.load_s, "turns": e.turns.len(),
                "run_s": three(Turns::spread(&e.turns)), "rays_per_s": rate(e), "of_verilator": pairs,
                "compared": e.rays * e.turns.len(), "wrong": 0})
        };
        let all: Value = engines.iter().map(value).collect();
        let value = json!({"map": task.scene.name, "views": views, "rays": task.rays.len(), "iterations": task.iterations,
            "compared_with": base.map(|e| &e.name), "engines": all});
        println!("{}", serde_json::to_string_pretty(&value).expect("plain data"));
        return;
    }
    let digits = |x: f64| if x < 0.1 { format!("{x:.4}") } else { format!("{x:.2}") };
    let seconds = |x: f64| if x < 0.1 { format!("{x:.4}") } else { format!("{x:.2}") };
    let row = |e: &Engine| {
        let s = Turns::spread(&e.turns);
        let of = ratio(e).map_or_else(
            || ["-".to_owned(), String::new()],
            |r| [format!("{} / {} / {}", digits(r.min), digits(r.median), digits(r.max)), r.count.to_string()],
        );
        let [of, pairs] = of;
        vec![
            e.name.clone(),
            e.rays.to_string(),
            format!("{:.2}", e.build_s),
            e.load_s.map_or(String::new(), seconds),
            format!("{} / {} / {}", seconds(s.min), seconds(s.median), seconds(s.max)),
            time(e).into(),
            format!("{:.0}", rate(e)),
            of,
            pairs,
        ]
    };
    let head = [
        "engine",
        "rays",
        "build s",
        "load s",
        "run s: min / median / max",
        "time",
        "rays/s",
        "of verilator: min / median / max",
        "pairs",
    ];
    print!("{}", table(&head, &engines.iter().map(row).collect::<Vec<_>>()));
    let compared: usize = engines.iter().map(|e| e.rays * e.turns.len()).sum();
    println!("\n0 of {compared} hits differ from the golden model's, in every output");
    let base = base.map_or("no Verilator is there to compare with".into(), |e| {
        format!(
            "compared with {}, the faster of its builds (-O3 -march=native, rays from memory), turn by turn",
            e.name
        )
    });
    println!(
        "map {}, {}: {} iterations a turn; {base}; times of the traversal alone, Icarus, the slowest, once with its bench and {ICARUS} rays at most",
        task.scene.name,
        views.join(", "),
        task.iterations,
    );
}
