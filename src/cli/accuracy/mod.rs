//! `accuracy`: hits against the exact oracle, per map and view.
mod bilinear_accuracy;
mod published_accuracy;

use super::args::{AccuracyArgs, Cli};
use super::output::table;
use super::views::{Pixels, look};
use crate::config::MapKind;
use crate::error::Result;
use crate::measure::DEFINITION;
use crate::project::{JudgedView, RefinedView, Scene, Witness, judge_view, refined_view};
use serde::Serialize;

/// What `--json` prints.
#[derive(Serialize)]
struct Said<'a> {
    definition: &'static str,
    views: &'a [JudgedView],
    witnesses: &'a [Witness],
    #[serde(skip_serializing_if = "Option::is_none")]
    bilinear: Option<&'a [RefinedView]>,
}

/// Runs `accuracy`.
pub fn run(cli: &Cli, a: &AccuracyArgs) -> Result<()> {
    let c = super::load::load(cli)?;
    if let Some(dir) = &a.scenes {
        return published_accuracy::run(cli, &c, dir);
    }
    let (a, views) = (&a.scene.map, &a.scene);
    let own = a.map.is_none() && c.map.kind != MapKind::File;
    let kinds: Vec<MapKind> =
        if own { MapKind::ALL.iter().copied().filter(|k| *k != MapKind::File).collect() } else { vec![c.map.kind] };
    let (mut rows, mut witnesses, mut refined) = (Vec::new(), Vec::new(), Vec::new());
    for kind in kinds {
        let mut c = c.clone();
        c.map.kind = kind;
        let scene = Scene::new(&c, a.map.as_deref(), a.resample)?;
        for seen in look(&c, views, &scene, &c.view.names, Pixels::Some, views.count())? {
            if c.mode.bilinear {
                refined.push(refined_view(&c, &scene, a.map.as_deref(), &seen.set.name, &seen.rays)?);
            }
            let (row, wrong) = judge_view(&c, &scene, &seen.set.name, &seen.rays)?;
            rows.push(row);
            witnesses.extend(wrong);
        }
    }
    if cli.json {
        let bilinear = c.mode.bilinear.then_some(refined.as_slice());
        let said = Said { definition: DEFINITION, views: &rows, witnesses: &witnesses, bilinear };
        println!("{}", serde_json::to_string_pretty(&said).expect("plain data"));
    } else {
        print(&rows, &witnesses);
        if c.mode.bilinear {
            bilinear_accuracy::print(&refined);
        }
    }
    Ok(())
}

fn print(rows: &[JudgedView], witnesses: &[Witness]) {
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
    let line = |r: &JudgedView| {
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
