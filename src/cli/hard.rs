//! `reliefrtl hard`: the hard cases on the configured design.
use super::args::{Cli, HardArgs, MOST_RAYS};
use super::output::{spinner, table};
use super::views::{Pixels, look};
use crate::config::Design;
use crate::engine::EngineName;
use crate::error::{Error, Result};
use crate::files::{OutDir, Part};
use crate::golden::RayHit;
use crate::measure::corner_cases::ends;
use crate::measure::hex_words;
use crate::measure::soak::modes;
use crate::project::{
    EnduredCase, HardCase, HardGround, HardOutcome, HardSum, HardTask, HardWatch, Scene, endure_cases, hard_cases,
};
use crate::scene::hard::{Case, HardScene, footprints};
use indicatif::ProgressBar;
use serde_json::{Value, json};

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
    let c = super::load::load(cli)?;
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
    let sets = views.iter().map(|v| HardTask::Set(&v.set, &v.rays));
    let chosen: Vec<HardTask<'_>> = cases.into_iter().map(HardTask::Case).chain(sets).collect();
    let ground = HardGround { c: &c, own: own.as_ref(), seed: a.seed };
    if let Some(rays) = a.endure {
        return endure(cli, &ground, &chosen, rays);
    }
    // Only pictures of earlier runs are replaced, and what else was generated there stays.
    let own: Vec<String> = Case::all().map(|case| format!("{}.png", case.name)).collect();
    let own: Vec<&str> = own.iter().map(String::as_str).collect();
    let part = Part { config: PICTURES.into(), replaces: &own, alone_in: &[] };
    let pictures = a.pictures.as_deref().map(super::output::directory).transpose()?;
    let pictures = pictures.map(|dir| dir.only(part));
    let mut watch = Watch { bar: spinner(cli, "hard cases"), pictures, seed: a.seed };
    let found = hard_cases(&ground, &chosen, each, a.engine, &mut watch)?;
    watch.bar.finish_and_clear();
    watch.pictures.map_or(Ok(()), |dir| dir.commit().map(|_| ()))?;
    if cli.json {
        println!("{}", serde_json::to_string_pretty(&found).expect("plain data"));
    } else {
        print(&found, a.engine);
    }
    let broken: Vec<&str> = found.run().filter(|case| !case.keeps_promises).map(|case| case.case.as_str()).collect();
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

/// The spinner, and the directory of pictures.
struct Watch {
    bar: ProgressBar,
    pictures: Option<OutDir>,
    seed: u64,
}

impl HardWatch for Watch {
    fn begins(&mut self, case: &str) {
        self.bar.set_message(format!("hard case {case}"));
    }

    fn ends(&mut self, case: &str, scene: &HardScene, design: &Design, hits: &[RayHit]) -> Result<()> {
        let Some(dir) = &mut self.pictures else { return Ok(()) };
        let picture = footprints(scene, case, self.seed, &ends(design, hits));
        dir.add(&format!("{case}.png"), &picture.to_png()?)
    }
}

fn print(found: &HardSum, engine: EngineName) {
    let rows: Vec<Vec<String>> = found.cases.iter().map(row).collect();
    print!("{}", table(&HEAD, &rows));
    let witnesses: Vec<Vec<String>> = found.run().flat_map(witness).collect();
    if !witnesses.is_empty() {
        println!("\nwitnesses, the first of each case:");
        print!("{}", table(&["case", "what", "ray", "u v du dv (hex)", "got", "expected"], &witnesses));
    }
    if engine != EngineName::Golden {
        println!("\n0 of {} hits of the engine differ from the golden model's", found.rays);
    }
    println!(
        "\n{} rays, seed {}: {} wrong texels, and {} of {} rays on an exact tie; {} given up; {} depend on the mode",
        found.rays, found.seed, found.wrong, found.wrong_ties, found.ties, found.given_up, found.modes_differ
    );
}

/// What a directory of pictures notes where a tree has the hash of its configuration: pictures go with no tree.
const PICTURES: &str = "hard-cases";

const HEAD: [&str; 8] =
    ["case", "texels", "wrong texels", "wrong on a tie", "largest margin", "given up", "modes differ", "step limit"];

/// Runs `hard --endure`.
fn endure(cli: &Cli, ground: &HardGround<'_>, tasks: &[HardTask<'_>], rays: usize) -> Result<()> {
    let c = ground.c;
    let bar = spinner(cli, "hard cases");
    let sum = endure_cases(ground, tasks, rays, MOST_RAYS, &|what| bar.set_message(what))?;
    bar.finish_and_clear();
    if cli.json {
        println!("{}", serde_json::to_string_pretty(&sum).expect("plain data"));
    } else {
        let row = |of: &EnduredCase| {
            let longest = of.longest.as_ref();
            let long =
                longest.map_or_else(Default::default, |l| [l.steps.to_string(), l.words.join(" "), l.way.clone()]);
            let counts = [format!("{} of {}", of.given_up, of.rays), of.refused.to_string()];
            [std::slice::from_ref(&of.case), &counts[..], &long[..]].concat()
        };
        let rows: Vec<Vec<String>> = sum.cases.iter().map(row).collect();
        print!("{}", table(&["case", "given up", "refused", "most steps", "u v du dv (hex)", "mode"], &rows));
        println!(
            "\n{} of {} rays end by the step limit of {}, seed {}, {} cases, each ray in one of {} modes in turn; {} refused",
            sum.given_up,
            sum.rays,
            c.traverse.step_limit,
            sum.seed,
            sum.cases.len(),
            modes(&c.design()).len(),
            sum.refused
        );
    }
    match sum.witness.filter(|_| c.datapath.kind.facts().modes_agree) {
        None => Ok(()),
        Some((ray, m)) => {
            Err(Error::mismatch(format!("a ray does not end: {} ({})", hex_words(&ray).join(" "), m.way())))
        }
    }
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

fn row(outcome: &HardOutcome) -> Vec<String> {
    let f = match outcome {
        HardOutcome::Run(case) => case,
        HardOutcome::LeftOut { case, left_out } => {
            let mut row = vec![case.clone()];
            row.resize(HEAD.len() - 1, "-".into());
            row.push(format!("left out: {left_out}"));
            return row;
        }
    };
    let of = |k: usize| format!("{k} of {}", f.rays);
    vec![
        f.case.clone(),
        f.texels.to_string(),
        of(f.wrong),
        format!("{} of {}", f.wrong_ties, f.ties),
        if f.largest_margin > 0.0 { format!("{:.1e}", f.largest_margin) } else { String::new() },
        of(f.given_up),
        of(f.modes_differ),
        f.limit_wrong.map_or(String::new(), |k| format!("{k} of {} end wrongly", 2 * f.rays)),
    ]
}

/// The first ray of each kind of trouble.
fn witness(f: &HardCase) -> Vec<Vec<String>> {
    let line = |what: String, ray: usize, words: &[String; 4], got: String, expected: String| {
        vec![f.case.clone(), what, ray.to_string(), words.join(" "), got, expected]
    };
    let texel = |(i, j): (u32, u32)| format!("{i}, {j}");
    let wrong = f
        .worst
        .as_ref()
        .map(|w| line(format!("wrong texel, margin {:.1e}", w.margin), w.ray, &w.words, texel(w.got), texel(w.exact)));
    let limit = f.first_given_up.as_ref();
    let limit =
        limit.map(|g| line("given up".into(), g.ray, &g.words, format!("{} iterations", g.steps), "a hit".into()));
    let differs = f.first_that_differs.as_ref();
    let differs = differs.map(|d| line(d.way.clone(), d.ray, &d.words, d.got.to_string(), d.expected.to_string()));
    wrong.into_iter().chain(limit).chain(differs).collect()
}
