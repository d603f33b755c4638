//! `accuracy`: hits against the exact oracle, per map and view.
use super::args::{AccuracyArgs, Cli};
use super::output::table;
use super::refined::{self, Refined};
use super::views::{Pixels, Viewed, look};
use crate::config::{Config, MapKind};
use crate::error::Result;
use crate::golden::RayInput;
use crate::measure::{DEFINITION, Spread, WrongTexel, accuracy, uv_given};
use crate::project::{Scene, encode};
use crate::trace::trace_golden;
use serde::Serialize;

/// What was measured of one view of one map. Errors of positions in texels, of the parameter t in height ranges.
#[derive(Serialize)]
struct Row {
    map: String,
    view: String,
    /// Rays that were judged.
    rays: usize,
    /// Rays that end in another texel than the exact walk of the same words.
    wrong_texels: usize,
    /// Rays that end in the right texel and say "wall" where it is none, or the other way round.
    wrong_walls: usize,
    /// Rays that ended by the step limit.
    given_up: usize,
    worst_t: Worst,
    /// Against the exact walk of the ray's words.
    uv: Uv,
    /// Against the exact walk of the ray as it was given, before its rounding to words.
    uv_given: Uv,
}

/// A largest error, and the ray that has it.
#[derive(Serialize)]
struct Worst {
    error: f64,
    ray: usize,
}

/// A distribution of position errors.
#[derive(Serialize)]
struct Uv {
    rays: u64,
    p50: f64,
    p99: f64,
    max: f64,
    max_ray: usize,
}

/// A ray that ends in a wrong texel.
#[derive(Serialize)]
struct Witness {
    map: String,
    view: String,
    ray: usize,
    /// The words u, v, du, dv in hex.
    words: [String; 4],
    got: (u32, u32),
    exact: (u32, u32),
    /// How close the exact decision was, over the height range.
    margin: f64,
}

/// What `--json` prints.
#[derive(Serialize)]
struct Said<'a> {
    definition: &'static str,
    views: &'a [Row],
    witnesses: &'a [Witness],
    #[serde(skip_serializing_if = "Option::is_none")]
    bilinear: Option<&'a [refined::Row]>,
}

impl Uv {
    fn of(s: &Spread) -> Self {
        Self { rays: s.rays, p50: s.p50, p99: s.p99, max: s.max, max_ray: s.max_ray }
    }
}

/// Runs `accuracy`.
pub fn run(cli: &Cli, a: &AccuracyArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    if let Some(dir) = &a.scenes {
        return super::rates::run(cli, &c, dir);
    }
    let (a, views) = (&a.scene.map, &a.scene);
    let own = a.map.is_none() && c.map.kind != MapKind::File;
    let kinds: Vec<MapKind> =
        if own { MapKind::ALL.iter().copied().filter(|k| *k != MapKind::File).collect() } else { vec![c.map.kind] };
    let (mut rows, mut witnesses, mut refined) = (Vec::new(), Vec::new(), Refined::default());
    for kind in kinds {
        let mut c = c.clone();
        c.map.kind = kind;
        let scene = Scene::new(&c, a.map.as_deref(), a.resample)?;
        for seen in look(&c, views, &scene, &c.view.names, Pixels::Some, views.count())? {
            if c.mode.bilinear {
                refined.add(&c, &scene, a.map.as_deref(), &seen.set.name, &seen.rays)?;
            }
            let (row, wrong) = measure(&c, &scene, &seen)?;
            rows.push(row);
            witnesses.extend(wrong);
        }
    }
    if cli.json {
        let bilinear = c.mode.bilinear.then_some(refined.rows.as_slice());
        let said = Said { definition: DEFINITION, views: &rows, witnesses: &witnesses, bilinear };
        println!("{}", serde_json::to_string_pretty(&said).expect("plain data"));
    } else {
        print(&rows, &witnesses);
        if c.mode.bilinear {
            refined.print();
        }
    }
    Ok(())
}

fn measure(c: &Config, scene: &Scene, seen: &Viewed) -> Result<(Row, Vec<Witness>)> {
    let rays: Vec<RayInput> = seen.rays.iter().map(|x| encode(c, x)).collect();
    let hits = trace_golden(&c.design(), &scene.pyramid, &rays)?;
    let r = accuracy(&c.design(), &scene.texels, &rays, &hits)?;
    let (map, view) = (scene.name.clone(), seen.set.name.clone());
    let witness = |w: &WrongTexel| Witness {
        map: map.clone(),
        view: view.clone(),
        ray: w.ray,
        words: [rays[w.ray].u, rays[w.ray].v, rays[w.ray].du, rays[w.ray].dv].map(|word| format!("{word:x}")),
        got: w.got,
        exact: w.exact,
        margin: w.margin,
    };
    let witnesses = r.wrong.iter().map(witness).collect();
    let numbers: Vec<[f64; 4]> = seen.rays.iter().map(|r| [r.u, r.v, r.du, r.dv]).collect();
    let given = Spread::of(uv_given(&c.design(), &scene.texels, &numbers, &hits)?);
    let row = Row {
        rays: r.rays,
        wrong_texels: r.wrong.len(),
        wrong_walls: r.wrong_wall,
        given_up: r.limits,
        worst_t: Worst { error: r.worst_t.0, ray: r.worst_t.1 },
        uv: Uv::of(&Spread::of(r.uv)),
        uv_given: Uv::of(&given),
        map,
        view,
    };
    Ok((row, witnesses))
}

fn print(rows: &[Row], witnesses: &[Witness]) {
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
    let line = |r: &Row| {
        vec![
            r.map.clone(),
            r.view.clone(),
            format!("{} of {}", r.wrong_texels, r.rays),
            r.wrong_walls.to_string(),
            r.given_up.to_string(),
            format!("{:.2e} @{}", r.worst_t.error, r.worst_t.ray),
            format!("{:.2e}", r.uv.p99),
            format!("{:.2e} @{}", r.uv.max, r.uv.max_ray),
            format!("{:.2e}", r.uv_given.p99),
        ]
    };
    print!("{}", table(&head, &rows.iter().map(line).collect::<Vec<_>>()));
    println!("{DEFINITION}; of the rays as given: before their rounding to words");
    println!("\nevery wrong texel (margin: how close the exact decision was, over the height range):");
    let head = ["map", "view", "ray", "u v du dv (hex)", "got", "exact", "margin"];
    let line = |w: &Witness| {
        vec![
            w.map.clone(),
            w.view.clone(),
            w.ray.to_string(),
            w.words.join(" "),
            format!("{}, {}", w.got.0, w.got.1),
            format!("{}, {}", w.exact.0, w.exact.1),
            format!("{:.1e}", w.margin),
        ]
    };
    print!("{}", table(&head, &witnesses.iter().map(line).collect::<Vec<_>>()));
}
