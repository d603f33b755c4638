//! `reliefrtl trace`: rays from a table, hits into a table, by any engine; the bytes are the same.
use super::args::{Cli, Engine, TraceArgs};
use super::output::spinner;
use crate::bench::{Outcome, Paths, Simulator, bench_files, run_bench_on};
use crate::catalogue::ray_set;
use crate::config::Config;
use crate::error::{Error, Result};
use crate::files::Scratch;
use crate::golden::{RayHit, RayInput};
use crate::ir::Binding;
use crate::project::{self, Scene};
use crate::scene::read_rays;
use crate::trace::{enter_border, hit, hits_csv, outputs, record, saw_border, trace_golden, trace_interp};
use crate::vectors::set_files;
use std::time::Duration;

/// Runs `trace`.
pub fn run(cli: &Cli, a: &TraceArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    super::output::keep_inputs(
        &a.out,
        &[Some(&a.rays), a.map.map.as_deref(), c.map.file.as_deref(), cli.config.as_deref()],
    )?;
    let out = super::output::sink(&a.out)?;
    let wave = a.wave.as_deref().map(|path| super::output::wave_sink(path, Some(&out))).transpose()?;
    let scene = Scene::new(&c, a.map.map.as_deref(), a.map.resample)?;
    let table = read_rays(&a.rays, c.mode.lod)?;
    let entered =
        enter_border(c.map.border, &table.rays).map_err(|e| Error::input(format!("{}: {e}", a.rays.display())))?;
    let mut rays: Vec<RayInput> = entered.iter().map(|r| project::ray(&c, *r)).collect();
    if let Some(lods) = &table.lods {
        if !c.mode.lod && lods.iter().any(|l| *l > 0) {
            let name = a.rays.display();
            return Err(Error::input(format!("{name} has levels of detail (column lod): they need mode.lod = true")));
        }
        rays.iter_mut().zip(lods).for_each(|(r, l)| r.lod = (*l).min(c.traverse.levels));
    }
    let mut hits = hits(cli, &c, a.engine, &scene, &rays)?;
    let ended = hits.iter().filter(|h| !h.limit).count();
    for (hit, ray) in hits.iter_mut().zip(&entered) {
        if !saw_border(&c.design(), c.map.border, ray, hit) && !hit.limit {
            *hit = RayHit { limit: true, ..RayHit::default() };
        }
    }
    let beyond = ended - hits.iter().filter(|h| !h.limit).count();
    if let Some((sink, format)) = &wave {
        let ray = rays.get(a.wave_ray).ok_or_else(|| {
            Error::input(format!(
                "--wave-ray {} is none of the {} rays in {}",
                a.wave_ray,
                rays.len(),
                a.rays.display()
            ))
        })?;
        record(&c.design(), &scene.pyramid, ray)?.1.write(sink, *format, "traverse")?;
    }
    out.write(hits_csv(&c.design(), c.map.border, &hits).as_bytes())?;
    let lost = Lost { beyond, ..Lost::of(&hits) };
    if cli.json {
        println!(
            "{}",
            serde_json::json!({"rays": hits.len(), "refused": lost.refused, "beyond": lost.beyond, "given_up": lost.given_up, "out": a.out})
        );
    } else {
        let rays = if hits.len() == 1 { "ray" } else { "rays" };
        println!("{} {rays} traced into {}", hits.len(), a.out.display());
        lost.print(&c, hits.len());
    }
    lost.verdict(hits.len())
}

/// Rays without a hit.
pub struct Lost {
    /// Not rays of this design: they travel too far.
    pub refused: usize,
    /// Ended by the step limit.
    pub given_up: usize,
    /// Of those refused: went on behind what was prepared beyond the map's border.
    pub beyond: usize,
}

impl Lost {
    /// Counts them.
    pub fn of(hits: &[RayHit]) -> Self {
        let count = |started: bool| hits.iter().filter(|h| h.limit && (h.steps > 0) == started).count();
        Self { refused: count(false), given_up: count(true), beyond: 0 }
    }

    /// A line for each kind that is there.
    pub fn print(&self, c: &Config, of: usize) {
        if self.beyond > 0 {
            println!(
                "{} of {of} go on more than half a side beyond the map's border, where map.border = \"clamp\" ends: they have no hit",
                self.beyond
            );
        }
        if self.refused > self.beyond {
            println!(
                "{} of {of} can't be traced by this design: in its number format they travel 2^tile_bits = {} tiles of the design or more",
                self.refused - self.beyond,
                1u32 << c.traverse.tile_bits
            );
        }
        if self.given_up > 0 {
            println!("{} of {of} were given up after {} iterations", self.given_up, c.traverse.step_limit);
        }
    }

    /// An error if there was no hit at all.
    ///
    /// # Errors
    /// [`Error::NothingRan`].
    pub fn verdict(&self, of: usize) -> Result<()> {
        if self.refused + self.given_up < of {
            return Ok(());
        }
        Err(Error::NothingRan(format!("none of {of} rays has a hit")))
    }
}

/// Traces `rays` with an engine.
///
/// # Errors
/// As the engine: a simulator may be missing, or disagree with the golden model.
pub fn hits(cli: &Cli, c: &Config, engine: Engine, scene: &Scene, rays: &[RayInput]) -> Result<Vec<RayHit>> {
    let d = c.design();
    let bar = spinner(cli, format!("tracing {} rays", rays.len()));
    let hits = match engine.simulator() {
        None if engine == Engine::Golden => trace_golden(&d, &scene.pyramid, rays)?,
        None => trace_interp(&d, &scene.pyramid, rays)?,
        Some(sim) => simulated(c, sim, scene, rays)?,
    };
    bar.finish_and_clear();
    Ok(hits)
}

/// The emitted Verilog in a simulator; its bench holds every hit against the golden model as well.
fn simulated(c: &Config, sim: Simulator, scene: &Scene, rays: &[RayInput]) -> Result<Vec<RayHit>> {
    simulate(c, sim, scene, rays).map(|x| x.0)
}

/// Times of build and run of the traverse bench in a simulator.
///
/// # Errors
/// As the simulator.
pub fn timed(c: &Config, sim: Simulator, scene: &Scene, rays: &[RayInput]) -> Result<(Duration, Duration)> {
    simulate(c, sim, scene, rays).map(|x| (x.1.build, x.1.run))
}

fn simulate(c: &Config, sim: Simulator, scene: &Scene, rays: &[RayInput]) -> Result<(Vec<RayHit>, Outcome)> {
    let d = c.design();
    let p = project::hardware(c)?;
    let t = &p.traverse;
    let set = ray_set(&d, &scene.pyramid, rays, c.vectors.seed)?;
    let mut files = p.files;
    files.extend(bench_files(&[], Some((&t.module, t.setup + t.slots + t.finish)), &c.emit));
    files.extend(set_files(&set.set).into_iter().map(|(n, text)| (format!("golden/traverse/{n}"), text)));
    files.insert("golden/traverse/memory.hex".into(), set.memory);
    let work = Scratch::new()?;
    let tree = work.path().join("tree");
    super::output::write_tree(&tree, &files)?;
    let results = work.path().join("results.txt");
    let paths = Paths { results: Some(results.clone()), ..Paths::default() };
    let outcome = run_bench_on(sim, &tree, "traverse", &Binding::new(), &paths, &[])?;
    let text = std::fs::read_to_string(&results).map_err(|e| Error::file("read", &results, e))?;
    let mut hits = vec![RayHit::default(); rays.len()];
    let words_of_hit = outputs(&t.module).len();
    let broken = || Error::ToolFailed(format!("{} wrote results that can't be read", sim.name()));
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let ray: usize = words.next().and_then(|w| w.parse().ok()).ok_or_else(broken)?;
        let row = words.map(|w| u64::from_str_radix(w, 16).map_err(|_| broken())).collect::<Result<Vec<u64>>>()?;
        *hits.get_mut(ray).filter(|_| row.len() == words_of_hit).ok_or_else(broken)? = hit(&row);
    }
    Ok((hits, outcome))
}
