//! Speed of the engines on the same rays, in turns, by processor time.
use super::Scene;
use crate::bench::{COMPILERS, Harness, Load};
use crate::config::Config;
use crate::emit::hardware;
use crate::engine::EngineName;
use crate::error::{Error, Result};
use crate::golden::{RayInput, prepare};
use crate::interp::{BLOCK, Traffic};
use crate::ir::Binding;
use crate::measure::turns::{Spread3, Turns};
use crate::process;
use crate::trace::{Pipeline, hit_row, image};
use cpu_time::ThreadTime;
use serde::Serialize;
use std::time::Instant;

/// Rays that Icarus takes: it is far slower than the rest.
pub const ICARUS_RAYS: usize = 500;

/// What every engine gets.
pub struct SpeedTask {
    /// The map.
    pub scene: Scene,
    /// The rays.
    pub rays: Vec<RayInput>,
    /// The golden model's hits, as words of the ports.
    expected: Vec<Vec<u64>>,
    /// Iterations of all rays together.
    pub iterations: u64,
}

impl SpeedTask {
    /// Rays on a map, and what the golden model says of them.
    ///
    /// # Errors
    /// An illegal design.
    pub fn new(c: &Config, scene: Scene, rays: Vec<RayInput>) -> Result<Self> {
        let d = c.design();
        let golden = prepare(&d)?;
        let hits: Vec<_> = rays.iter().map(|r| golden.trace(&scene.pyramid, r)).collect();
        let iterations = hits.iter().map(|h| u64::from(h.steps)).sum();
        let expected = hits.iter().map(|h| hit_row(&d, h)).collect();
        Ok(Self { scene, rays, expected, iterations })
    }
}

/// What was measured of an engine; times in seconds.
#[derive(Clone, Debug, Serialize)]
pub struct EngineSpeed {
    /// Its name, and how it ran, for people: the three fields after it in words.
    pub engine: String,
    /// `golden`, `interpreter`, `verilator` or `icarus`.
    pub kind: &'static str,
    /// Threads that trace rays.
    pub threads: usize,
    /// What compiled the harness; none where nothing is compiled.
    pub compiler: Option<&'static str>,
    /// Rays a turn.
    pub rays: usize,
    /// `processor` time, but where several threads work `wall` time.
    pub time: &'static str,
    /// Time until it can run: elaboration, or Verilator and the compiler.
    pub build_s: f64,
    /// Time in which the pyramid is loaded, each turn; none where nothing is copied.
    pub load_s: Option<f64>,
    /// Turns measured.
    pub turns: usize,
    /// Time of a turn.
    pub run_s: Range,
    /// Rays per second of the median turn.
    pub rays_per_s: f64,
    /// How many times as fast as the fastest build of Verilator, turn by turn; none without one.
    pub of_verilator: Option<Ratio>,
    /// Hits compared with the golden model's.
    pub compared: usize,
    /// Of these, those that differ.
    pub wrong: usize,
}

/// The least, the middle and the largest value.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Range {
    /// Least.
    pub min: f64,
    /// Median.
    pub median: f64,
    /// Largest.
    pub max: f64,
}

/// The same of ratios of turns.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Ratio {
    /// Least.
    pub min: f64,
    /// Median.
    pub median: f64,
    /// Largest.
    pub max: f64,
    /// How many pairs of turns.
    pub pairs: usize,
}

/// What was measured of all.
#[derive(Clone, Debug, Serialize)]
pub struct Speeds {
    /// The map.
    pub map: String,
    /// The views whose rays these are.
    pub views: Vec<String>,
    /// Rays.
    pub rays: usize,
    /// Iterations of all rays together.
    pub iterations: u64,
    /// The engine that the others are compared with.
    pub compared_with: Option<String>,
    /// Each engine.
    pub engines: Vec<EngineSpeed>,
    /// What could not be measured, for a program that is not installed.
    #[serde(skip)]
    pub left_out: Vec<String>,
}

/// Measures all engines that are installed, `turns` times; `tell` hears what is under way.
///
/// # Errors
/// An engine whose hits are not the golden model's.
pub fn speeds(c: &Config, task: &SpeedTask, views: Vec<String>, turns: usize, tell: &dyn Fn(&str)) -> Result<Speeds> {
    let (engines, left_out) = measure(c, task, turns, tell)?;
    let base = strongest(&engines);
    let one = |e: &Timed| {
        let Spread3 { min, median, max, .. } = Turns::spread(&e.turns);
        let ratio = base.and_then(|base| Turns::pairs((&base.turns, base.rays), (&e.turns, e.rays)));
        EngineSpeed {
            engine: e.name.clone(),
            kind: e.kind,
            threads: e.threads,
            compiler: e.compiler,
            rays: e.rays,
            time: if e.wall { "wall" } else { "processor" },
            build_s: e.build_s,
            load_s: e.load_s,
            turns: e.turns.len(),
            run_s: Range { min, median, max },
            rays_per_s: e.rays as f64 / median,
            of_verilator: ratio.map(|r| Ratio { min: r.min, median: r.median, max: r.max, pairs: r.count }),
            compared: e.rays * e.turns.len(),
            wrong: 0,
        }
    };
    Ok(Speeds {
        map: task.scene.name.clone(),
        views,
        rays: task.rays.len(),
        iterations: task.iterations,
        compared_with: base.map(|e| e.name.clone()),
        engines: engines.iter().map(one).collect(),
        left_out: left_out.iter().map(Error::to_string).collect(),
    })
}

/// An engine, and its times.
struct Timed {
    name: String,
    kind: &'static str,
    threads: usize,
    compiler: Option<&'static str>,
    rays: usize,
    build_s: f64,
    load_s: Option<f64>,
    /// Seconds of each turn.
    turns: Vec<f64>,
    wall: bool,
}

/// Builds all engines, then measures them in turns: each once, and again, so that what else the machine does meets all of them.
fn measure(c: &Config, task: &SpeedTask, turns: usize, tell: &dyn Fn(&str)) -> Result<(Vec<Timed>, Vec<Error>)> {
    let (d, n) = (c.design(), task.rays.len());
    // Where several threads work, wall time counts.
    let engine = |kind: &'static str, threads: usize, compiler: Option<&'static str>, build_s: f64| Timed {
        name: match compiler {
            Some(compiler) => format!("{kind}, {compiler}"),
            None => format!("{kind}, {threads} thread{}", if threads == 1 { "" } else { "s" }),
        },
        kind,
        threads,
        compiler,
        rays: n,
        build_s,
        load_s: None,
        turns: Vec::new(),
        wall: threads > 1,
    };
    let golden = prepare(&d)?;
    let start = Instant::now();
    let p = Pipeline::new(&d, &Binding::new())?;
    let stream = p.stream();
    let built = start.elapsed().as_secs_f64();
    let threads = rayon::current_num_threads();
    let (mut harnesses, mut left_out) = (Vec::new(), Vec::new());
    let hardware = hardware(c)?;
    let top = format!("{}traverse", c.emit.prefix);
    let (images, items) = p.words(&task.scene.pyramid, &task.rays);
    let memory = image(&p.design, &task.scene.pyramid);
    let load = Load { memory: &memory, rays: &items, expected: &task.expected };
    for compiler in COMPILERS.into_iter().filter(|compiler| process::starts(compiler)) {
        tell(&format!("building the harness in Verilator with {compiler}"));
        match Harness::new(compiler, &hardware.files, (&d, &hardware.traverse.module), &top) {
            Ok(harness) => {
                harness.load(&load)?;
                harnesses.push((compiler, harness));
            }
            Err(e @ Error::ToolMissing(_)) => left_out.push(e),
            Err(e) => return Err(e),
        }
    }
    let mut all = vec![
        engine("golden", 1, None, 0.0),
        engine("interpreter", 1, None, built),
        engine("interpreter", threads, None, built),
    ];
    all.extend(harnesses.iter().map(|(cxx, h)| engine("verilator", 1, Some(*cxx), h.build.as_secs_f64())));
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
    let few = n.min(ICARUS_RAYS);
    tell("measuring Icarus");
    let icarus = EngineName::Icarus.engine();
    match icarus.installed() {
        Ok(()) => {
            let traced = icarus.trace(c, &task.scene.pyramid, &task.rays[..few])?;
            let turns = vec![traced.run.as_secs_f64()];
            let own = engine("icarus", 1, None, traced.build.as_secs_f64());
            // A program of its own, so wall time.
            all.push(Timed { name: icarus.name().into(), rays: few, turns, wall: true, ..own });
        }
        Err(e) => left_out.push(e),
    }
    Ok((all, left_out))
}

/// The fastest build of Verilator: what the others are compared with.
fn strongest(engines: &[Timed]) -> Option<&Timed> {
    let built = engines.iter().filter(|e| e.name.starts_with("verilator"));
    built.min_by(|a, b| Turns::median(&a.turns).total_cmp(&Turns::median(&b.turns)))
}
