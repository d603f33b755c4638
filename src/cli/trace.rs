//! `reliefrtl trace`: rays from a table, hits into a table, by any engine; the bytes are the same.
use super::args::{Cli, Engine, RaysArg, TraceArgs};
use super::output::spinner;
use super::views::Pixels;
use crate::bench::{Outcome, Paths, Simulator, bench_files, run_bench_on};
use crate::catalogue::ray_set;
use crate::config::Config;
use crate::error::{Error, Result};
use crate::files::Scratch;
use crate::golden::{RayHit, RayInput};
use crate::ir::Binding;
use crate::project::{self, Scene};
use crate::scene::border::enter_border;
use crate::scene::{RaySet, RaySource, evenly};
use crate::trace::{hit, hits_csv, outputs, record, saw_border, trace_golden, trace_interp};
use crate::vectors::set_files;
use std::time::Duration;

/// Runs `trace`.
pub fn run(cli: &Cli, a: &TraceArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    let mut seen = a.scene.clone();
    if let Some(RaysArg::Count(n)) = seen.rays
        && seen.view.is_empty()
    {
        // Without a view there is nothing to count: a number is a file's name, too.
        seen.rays = Some(RaysArg::File(n.to_string().into()));
    }
    let named = super::views::inputs(&seen);
    let inputs = named.iter().map(|p| Some(p.as_path())).chain([c.map.file.as_deref(), cli.config.as_deref()]);
    let inputs: Vec<_> = inputs.collect();
    super::output::keep_inputs(&a.out, &inputs)?;
    a.wave.as_deref().map_or(Ok(()), |wave| super::output::keep_inputs(wave, &inputs))?;
    let out = super::output::sink(&a.out)?;
    let wave = a.wave.as_deref().map(|path| super::output::wave_sink(path, Some(&out))).transpose()?;
    if !seen.chosen() {
        return Err(Error::input("trace needs rays: --rays R.csv, or --view NAME|CAMERA.toml,..."));
    }
    let scene = Scene::new(&c, seen.map.map.as_deref(), seen.map.resample)?;
    let mut entered: Vec<[f64; 4]> = Vec::new();
    let mut rays: Vec<RayInput> = Vec::new();
    for set in super::views::sets(&seen, &[], c.mode.lod)? {
        let (numbers, lods) = numbers(&c, &scene, &set, seen.count())?;
        let lod = |k: usize| lods.get(k).map_or(0, |l| (*l).min(c.traverse.levels));
        rays.extend(numbers.iter().enumerate().map(|(k, r)| RayInput { lod: lod(k), ..project::ray(&c, *r) }));
        entered.extend(numbers);
    }
    let mut hits = hits(cli, &c, a.engine, &scene, &rays)?;
    let ended = hits.iter().filter(|h| !h.limit).count();
    for (hit, ray) in hits.iter_mut().zip(&entered) {
        if !saw_border(&c.design(), c.map.border, ray, hit) && !hit.limit {
            *hit = RayHit { limit: true, ..RayHit::default() };
        }
    }
    let beyond = ended - hits.iter().filter(|h| !h.limit).count();
    let recorded = match &wave {
        None => None,
        Some((sink, format)) => {
            let ray = rays
                .get(a.wave_ray)
                .ok_or_else(|| Error::input(format!("--wave-ray {} is none of the {} rays", a.wave_ray, rays.len())))?;
            Some((record(&c.design(), &scene.pyramid, ray)?.1, sink, *format))
        }
    };
    // Each is written, even if the other can't be: nobody may be left at the end of a pipe.
    let written = out.write(hits_csv(&c.design(), c.map.border, &hits).as_bytes());
    let waved = recorded.map_or(Ok(()), |(wave, sink, format)| wave.write(sink, format, "traverse"));
    written.and(waved)?;
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

/// A set's rays in tiles of the design, and their levels of detail. A table's rays stay all, whatever lies behind the border, for each has
/// its line of hits.
fn numbers(c: &Config, scene: &Scene, set: &RaySet, most: Option<usize>) -> Result<(Vec<[f64; 4]>, Vec<u32>)> {
    let RaySource::Table(table) = &set.source else {
        if most == Some(0) {
            return Err(super::views::none_asked());
        }
        let rays = evenly(&scene.set(c, set, Pixels::Drawn.stride(c, set))?, most);
        if rays.is_empty() {
            return Err(super::views::no_ray(&set.given));
        }
        return Ok((rays.iter().map(|r| [r.u, r.v, r.du, r.dv]).collect(), Vec::new()));
    };
    let entered = enter_border(c.map.border, &table.rays).map_err(|e| Error::input(format!("{}: {e}", set.given)))?;
    let lods = table.lods.clone().unwrap_or_default();
    if !c.mode.lod && lods.iter().any(|l| *l > 0) {
        let name = &set.given;
        return Err(Error::input(format!("{name} has levels of detail (column lod): they need mode.lod = true")));
    }
    Ok((entered, lods))
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
