//! `reliefrtl hard`: the hard cases on the configured design.
use super::args::{Cli, Engine, HardArgs};
use super::output::{spinner, table};
use crate::config::{Config, DatapathKind, ModeConfig};
use crate::error::{Error, Result};
use crate::files::OutDir;
use crate::golden::{Pyramid, RayHit, RayInput, decode_time};
use crate::project::Scene;
use crate::report::endure::{Endured, endure as endured, modes};
use crate::report::hard::HardFigures;
use crate::scene::hard::{Case, HardScene, footprints};
use serde_json::{Value, json};

/// Runs `hard`.
pub fn run(cli: &Cli, a: &HardArgs) -> Result<()> {
    let chosen: Vec<&Case> = match a.case.as_slice() {
        [] => Case::all().collect(),
        names => names.iter().map(|name| Case::find(name)).collect::<Result<_>>()?,
    };
    if a.list {
        list(cli, &chosen);
        return Ok(());
    }
    if a.rays == 0 {
        return Err(Error::NothingRan("hard needs at least one ray a case".into()));
    }
    let c = super::config::load(cli)?;
    if let Some(rays) = a.endure {
        return endure(cli, &c, &chosen, rays, a.seed);
    }
    let mut pictures = a.pictures.as_deref().map(OutDir::new).transpose()?;
    let bar = spinner(cli, "hard cases");
    let (mut rows, mut witnesses, mut values) = (Vec::new(), Vec::new(), Vec::new());
    let (mut rays, mut broken, mut sum) = (0, Vec::new(), [0; 6]);
    for case in &chosen {
        bar.set_message(format!("hard case {}", case.name));
        let scene = case.scene(&c.design(), a.rays, a.seed);
        if let Some(reason) = illegal(&c, scene.design.traverse) {
            let mut row = vec![case.name.to_string()];
            row.resize(HEAD.len() - 1, "-".into());
            row.push(format!("left out: {reason}"));
            rows.push(row);
            values.push(json!({"case": case.name, "left_out": reason}));
            continue;
        }
        let f = HardFigures::of_scene(&scene, case.limit)?;
        equal(cli, &c, a.engine, case.name, &scene, &f)?;
        if let Some(dir) = &mut pictures {
            let full = f64::from((1u32 << f.design.traverse.height_bits) - 1);
            let end =
                |hit: &RayHit| if hit.limit { 1.0 } else { (decode_time(&f.design, hit.t) / full).clamp(0.0, 1.0) };
            let ends: Vec<f64> = f.hits.iter().map(end).collect();
            dir.add(&format!("{}.png", case.name), &footprints(&scene, case.name, a.seed, &ends).to_png()?)?;
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
            broken.push(case.name);
        }
        rows.push(row(case.name, &f));
        witnesses.extend(witness(case.name, &f));
        values.push(value(case.name, &f));
    }
    bar.finish_and_clear();
    if let Some(dir) = pictures {
        dir.commit()?;
    }
    if rays == 0 {
        return Err(Error::NothingRan("no case fits this design".into()));
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
fn endure(cli: &Cli, c: &Config, cases: &[&Case], rays: usize, seed: u64) -> Result<()> {
    let legal = |case: &&&Case| illegal(c, case.scene(&c.design(), 0, seed).design.traverse).is_none();
    let cases: Vec<&&Case> = cases.iter().filter(legal).collect();
    if rays == 0 || cases.is_empty() {
        return Err(Error::NothingRan("hard --endure needs at least one ray and a case that fits this design".into()));
    }
    let share = rays.div_ceil(cases.len());
    let bar = spinner(cli, "hard cases");
    let (mut rows, mut values, mut sum) = (Vec::new(), Vec::new(), Endured::default());
    for (k, case) in cases.iter().enumerate() {
        bar.set_message(format!("{share} rays of hard case {} ({} of {})", case.name, k + 1, cases.len()));
        let of = endured(&case.scene(&c.design(), share, seed))?;
        let long = of.longest.map_or_else(Default::default, |l| [l.steps.to_string(), words(&l.ray), mode(&l.mode)]);
        let counts = [format!("{} of {}", of.given_up, of.rays), of.refused.to_string()];
        rows.push([&[case.name.to_string()], &counts[..], &long[..]].concat());
        values.push(json!({"case": case.name, "rays": of.rays, "given_up": of.given_up, "refused": of.refused,
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
