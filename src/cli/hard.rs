//! `reliefrtl hard`: the hard cases on the configured design.
use super::args::{Cli, Engine, HardArgs, MOST_RAYS};
use super::output::{spinner, table};
use super::views::{Pixels, Viewed, look};
use crate::config::{Config, DatapathKind, Design, ModeConfig};
use crate::error::{Error, Result};
use crate::files::Part;
use crate::golden::{Pyramid, RayHit, RayInput, decode_time};
use crate::measure::endure::{Endured, endure as endured, modes};
use crate::measure::hard::HardFigures;
use crate::project::Scene;
use crate::scene::hard::{Case, HardScene, footprints};
use serde_json::{Value, json};

/// What is run: a case, or rays of the user's.
enum Task<'a> {
    /// A named case, on its own map or on that of the user's.
    Case(&'static Case),
    /// A view or a table of rays on a map.
    Set(&'a Viewed),
}

impl Task<'_> {
    fn name(&self) -> &str {
        match self {
            Self::Case(case) => case.name,
            Self::Set(view) => &view.set.name,
        }
    }

    /// Whether a step limit of exactly what the rays need is asked for, too.
    const fn limit(&self) -> bool {
        match self {
            Self::Case(case) => case.limit,
            Self::Set(_) => true,
        }
    }
}

/// What all tasks share.
struct Ground<'a> {
    c: &'a Config,
    /// The user's map, if there is one.
    own: Option<&'a Scene>,
    seed: u64,
}

impl Ground<'_> {
    /// A task's map and rays; or why it has none in this design.
    fn scene(&self, task: &Task<'_>, rays: usize) -> std::result::Result<HardScene, String> {
        let design = self.c.design();
        let scene = match (task, self.own) {
            (Task::Case(case), None) => case.scene(&design, rays, self.seed),
            (Task::Case(case), Some(own)) => case
                .over(&design, &own.texels, rays, self.seed)
                .ok_or("its map has a size of its own, so its rays don't go over another")?,
            (Task::Set(view), own) => {
                let texels = own.map_or_else(Vec::new, |own| own.texels.clone());
                HardScene { design, texels, rays: view.rays.iter().map(|r| [r.u, r.v, r.du, r.dv]).collect() }
            }
        };
        illegal(self.c, scene.design.traverse).map_or(Ok(scene), Err)
    }
}

/// The parts of the travels after which rays end, 0 to 1.
pub(super) fn ends(d: &Design, hits: &[RayHit]) -> Vec<f64> {
    let full = f64::from((1u32 << d.traverse.height_bits) - 1);
    let end = |hit: &RayHit| if hit.limit { 1.0 } else { (decode_time(d, hit.t) / full).clamp(0.0, 1.0) };
    hits.iter().map(end).collect()
}

/// Runs `hard`.
pub fn run(cli: &Cli, a: &HardArgs) -> Result<()> {
    let named: Vec<&'static Case> = match a.case.as_slice() {
        [] => Case::all().collect(),
        names => names.iter().map(|name| Case::find(name)).collect::<Result<_>>()?,
    };
    if a.list {
        list(cli, &named);
        return Ok(());
    }
    let each = a.scene.count().unwrap_or(200);
    if each == 0 {
        return Err(Error::NothingRan("hard needs at least one ray a case".into()));
    }
    let c = super::config::load(cli)?;
    // A map, or rays, of the user's.
    let map = &a.scene.map;
    let own = (map.map.is_some() || a.scene.chosen()).then(|| Scene::new(&c, map.map.as_deref(), map.resample));
    let own = own.transpose()?;
    let views = match &own {
        Some(scene) if a.scene.chosen() => look(&c, &a.scene, scene, &[], Pixels::Some, Some(each))?,
        _ => Vec::new(),
    };
    if let Some(case) = named.iter().find(|case| views.iter().any(|v| v.set.name == case.name)) {
        return Err(Error::input(format!("{0} is the name of a case: give the file of {0} another one", case.name)));
    }
    // Rays of the user's stand in the place of the cases; those that are named come all the same.
    let cases = if views.is_empty() || !a.case.is_empty() { named } else { Vec::new() };
    let chosen: Vec<Task<'_>> = cases.into_iter().map(Task::Case).chain(views.iter().map(Task::Set)).collect();
    let ground = Ground { c: &c, own: own.as_ref(), seed: a.seed };
    if let Some(rays) = a.endure {
        return endure(cli, &ground, &chosen, rays);
    }
    // Only pictures of earlier runs are replaced, and what else was generated there stays.
    let own: Vec<String> = Case::all().map(|case| format!("{}.png", case.name)).collect();
    let own: Vec<&str> = own.iter().map(String::as_str).collect();
    let part = Part { config: PICTURES.into(), replaces: &own, alone_in: &[] };
    let pictures = a.pictures.as_deref().map(super::output::directory).transpose()?;
    let mut pictures = pictures.map(|dir| dir.only(part));
    let bar = spinner(cli, "hard cases");
    let (mut rows, mut witnesses, mut values) = (Vec::new(), Vec::new(), Vec::new());
    let (mut rays, mut broken, mut sum) = (0, Vec::new(), [0; 6]);
    for task in &chosen {
        let name = task.name();
        bar.set_message(format!("hard case {name}"));
        let scene = match ground.scene(task, each) {
            Ok(scene) => scene,
            Err(reason) => {
                let mut row = vec![name.to_string()];
                row.resize(HEAD.len() - 1, "-".into());
                row.push(format!("left out: {reason}"));
                rows.push(row);
                values.push(json!({"case": name, "left_out": reason}));
                continue;
            }
        };
        let f = HardFigures::of_scene(&scene, task.limit())?;
        equal(cli, &c, a.engine, name, &scene, &f)?;
        if let Some(dir) = &mut pictures {
            let picture = footprints(&scene, name, a.seed, &ends(&f.design, &f.hits));
            dir.add(&format!("{name}.png"), &picture.to_png()?)?;
        }
        rays += f.rays.len();
        let counts = [
            f.accuracy.wrong.len() - f.ties,
            f.ties,
            f.accuracy.limits,
            f.differ.len(),
            f.limit_wrong.unwrap_or(0),
            f.tied,
        ];
        sum.iter_mut().zip(counts).for_each(|(sum, k)| *sum += k);
        if !f.keeps_promises() {
            broken.push(name);
        }
        rows.push(row(name, &f));
        witnesses.extend(witness(name, &f));
        values.push(value(name, &f));
    }
    bar.finish_and_clear();
    if rays == 0 {
        return Err(Error::NothingRan("no case fits this design".into()));
    }
    if let Some(dir) = pictures {
        dir.commit()?;
    }
    let [wrong, ties, limits, differ, limit_wrong, tied] = sum;
    if cli.json {
        let value = json!({"seed": a.seed, "rays": rays, "wrong": wrong, "wrong_ties": ties, "ties": tied, "given_up": limits,
            "modes_differ": differ, "limit_wrong": limit_wrong, "cases": values});
        println!("{}", serde_json::to_string_pretty(&value).expect("plain data"));
    } else {
        print!("{}", table(&HEAD, &rows));
        if !witnesses.is_empty() {
            println!("\nwitnesses, the first of each case:");
            print!("{}", table(&["case", "what", "ray", "u v du dv (hex)", "got", "expected"], &witnesses));
        }
        if a.engine != Engine::Golden {
            println!("\n0 of {rays} hits of the engine differ from the golden model's");
        }
        println!(
            "\n{rays} rays, seed {}: {wrong} wrong texels, and {ties} of {tied} rays on an exact tie; {limits} given up; {differ} depend on the mode",
            a.seed
        );
    }
    if broken.is_empty() {
        return Ok(());
    }
    let kind = c.datapath.kind;
    Err(Error::mismatch(format!(
        "the {kind:?} datapath gives up rays, or its modes disagree, in {} of {} cases: {}",
        broken.len(),
        chosen.len(),
        broken.join(", ")
    )))
}

/// What a directory of pictures notes where a tree has the hash of its configuration: pictures go with no tree.
const PICTURES: &str = "hard-cases";

const HEAD: [&str; 8] =
    ["case", "texels", "wrong texels", "wrong on a tie", "largest margin", "given up", "modes differ", "step limit"];

/// The engine's hits are the golden model's.
fn equal(cli: &Cli, c: &Config, engine: Engine, name: &str, hard: &HardScene, f: &HardFigures) -> Result<()> {
    if engine == Engine::Golden {
        return Ok(());
    }
    let mut c = c.clone();
    c.traverse = f.design.traverse;
    let t = &c.traverse;
    let pyramid = Pyramid::build(t.levels, t.height_bits, &hard.texels)?;
    let scene = Scene { texels: hard.texels.clone(), pyramid, kind: c.map.kind, name: name.into(), taken: None };
    let hits = super::trace::hits(cli, &c, engine, &scene, &f.rays)?;
    match hits.iter().zip(&f.hits).position(|(got, want)| got != want) {
        None => Ok(()),
        Some(ray) => Err(Error::mismatch(format!(
            "case {name}, ray {ray} ({}): expected {}, got {}",
            words(&f.rays[ray]),
            found(&f.hits[ray]),
            found(&hits[ray])
        ))),
    }
}

/// Runs `hard --endure`.
fn endure(cli: &Cli, ground: &Ground<'_>, tasks: &[Task<'_>], rays: usize) -> Result<()> {
    let (c, seed) = (ground.c, ground.seed);
    let cases: Vec<&Task<'_>> = tasks.iter().filter(|task| ground.scene(task, 0).is_ok()).collect();
    if rays == 0 || cases.is_empty() {
        return Err(Error::NothingRan("hard --endure needs at least one ray and a case that fits this design".into()));
    }
    let share = rays.div_ceil(cases.len());
    if share > MOST_RAYS {
        return Err(Error::input(format!(
            "--endure {rays} are {share} rays of each case, more than {MOST_RAYS}, the most at once: ask for fewer, and again with another --seed"
        )));
    }
    let bar = spinner(cli, "hard cases");
    let (mut rows, mut values, mut sum) = (Vec::new(), Vec::new(), Endured::default());
    for (k, task) in cases.iter().enumerate() {
        let name = task.name();
        bar.set_message(format!("{share} rays of hard case {name} ({} of {})", k + 1, cases.len()));
        let mut scene = ground.scene(task, share).map_err(Error::input)?;
        if let Task::Set(_) = task {
            // Each ray in every mode, then the next; all over again where there are too few.
            let (given, modes) = (scene.rays, modes(&c.design()).len());
            scene.rays = (0..share).map(|k| given[k / modes % given.len()]).collect();
        }
        let of = endured(&scene)?;
        let long = of.longest.map_or_else(Default::default, |l| [l.steps.to_string(), words(&l.ray), mode(&l.mode)]);
        let counts = [format!("{} of {}", of.given_up, of.rays), of.refused.to_string()];
        rows.push([&[name.to_string()], &counts[..], &long[..]].concat());
        values.push(json!({"case": name, "rays": of.rays, "given_up": of.given_up, "refused": of.refused,
            "longest": of.longest.map(|l| json!({"steps": l.steps, "words": words(&l.ray), "mode": mode(&l.mode)}))}));
        sum = sum.and(of);
    }
    bar.finish_and_clear();
    if cli.json {
        let value =
            json!({"seed": seed, "rays": sum.rays, "given_up": sum.given_up, "refused": sum.refused, "cases": values});
        println!("{}", serde_json::to_string_pretty(&value).expect("plain data"));
    } else {
        print!("{}", table(&["case", "given up", "refused", "most steps", "u v du dv (hex)", "mode"], &rows));
        println!(
            "\n{} of {} rays end by the step limit of {}, seed {seed}, {} cases, each ray in one of {} modes in turn; {} refused",
            sum.given_up,
            sum.rays,
            c.traverse.step_limit,
            cases.len(),
            modes(&c.design()).len(),
            sum.refused
        );
    }
    match sum.witness.filter(|_| c.datapath.kind != DatapathKind::Published) {
        None => Ok(()),
        Some((ray, m)) => Err(Error::mismatch(format!("a ray does not end: {} ({})", words(&ray), mode(&m)))),
    }
}

/// What is wrong with the configuration at the case's sizes.
fn illegal(c: &Config, traverse: crate::config::TraverseConfig) -> Option<String> {
    let mut c = c.clone();
    c.traverse = traverse;
    c.validate().err().map(|e| e.to_string())
}

fn list(cli: &Cli, cases: &[&Case]) {
    if cli.json {
        let all: Vec<Value> = cases.iter().map(|c| json!({"case": c.name, "about": c.about})).collect();
        println!("{}", serde_json::to_string_pretty(&all).expect("plain data"));
    } else {
        let rows: Vec<Vec<String>> = cases.iter().map(|c| vec![c.name.into(), c.about.into()]).collect();
        print!("{}", table(&["case", "what it aims at"], &rows));
    }
}

fn row(name: &str, f: &HardFigures) -> Vec<String> {
    let of = |k: usize| format!("{k} of {}", f.rays.len());
    vec![
        name.into(),
        (1u32 << f.design.traverse.levels).to_string(),
        of(f.accuracy.wrong.len() - f.ties),
        format!("{} of {}", f.ties, f.tied),
        if f.largest_margin() > 0.0 { format!("{:.1e}", f.largest_margin()) } else { String::new() },
        of(f.accuracy.limits),
        of(f.differ.len()),
        f.limit_wrong.map_or(String::new(), |k| format!("{k} of {} end wrongly", 2 * f.rays.len())),
    ]
}

/// The first ray of each kind of trouble.
fn witness(name: &str, f: &HardFigures) -> Vec<Vec<String>> {
    let line = |what: String, ray: usize, got: String, expected: String| {
        vec![name.to_string(), what, ray.to_string(), words(&f.rays[ray]), got, expected]
    };
    let texel = |(i, j): (u32, u32)| format!("{i}, {j}");
    let worst = f.accuracy.wrong.iter().max_by(|a, b| a.margin.total_cmp(&b.margin));
    let wrong =
        worst.map(|w| line(format!("wrong texel, margin {:.1e}", w.margin), w.ray, texel(w.got), texel(w.exact)));
    let limit = f.hits.iter().position(|hit| hit.limit);
    let limit =
        limit.map(|ray| line("given up".into(), ray, format!("{} iterations", f.hits[ray].steps), "a hit".into()));
    let differs = f.differ.first().map(|d| line(mode(&d.mode), d.ray, found(&d.got), found(&d.expected)));
    wrong.into_iter().chain(limit).chain(differs).collect()
}

fn value(name: &str, f: &HardFigures) -> Value {
    let differ = f.differ.first().map(|d| {
        json!({"ray": d.ray, "words": words(&f.rays[d.ray]), "mode": mode(&d.mode), "got": found(&d.got), "expected": found(&d.expected)})
    });
    let worst = f.accuracy.wrong.iter().max_by(|a, b| a.margin.total_cmp(&b.margin)).map(
        |w| json!({"ray": w.ray, "words": words(&f.rays[w.ray]), "got": w.got, "exact": w.exact, "margin": w.margin}),
    );
    json!({"case": name, "texels": 1u32 << f.design.traverse.levels, "rays": f.rays.len(),
        "wrong": f.accuracy.wrong.len() - f.ties, "wrong_ties": f.ties, "ties": f.tied, "given_up": f.accuracy.limits, "modes": f.modes,
        "modes_differ": f.differ.len(), "limit_wrong": f.limit_wrong, "worst": worst, "first_that_differs": differ})
}

pub(super) fn words(r: &RayInput) -> String {
    format!("{:x} {:x} {:x} {:x}", r.u, r.v, r.du, r.dv)
}

fn mode(m: &ModeConfig) -> String {
    let start = if m.start_level { "start level" } else { "root" };
    format!("{start}, {} down, up {:?}, trim {:?}", m.levels_down, m.level_up, m.trim)
}

fn found(h: &RayHit) -> String {
    let end = if h.limit {
        ", given up"
    } else if h.wall {
        ", wall"
    } else {
        ""
    };
    format!("{}, {} at t {:x}{end}", h.i, h.j, h.t)
}
