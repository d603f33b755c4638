//! The report's files: JSON, CSV and the page, from the same tables.
use super::charts::Plot;
use super::figures::{DesignPoint, design_points, series};
use super::measurement::Measurement;
use super::plan::{Extent, Headline, Plan, Rays};
use super::table::{grouped, short};
use super::{bilinear, charts, inventory, pictures, published, sections};
use crate::config::modes::{BEST, deeper, published_rows, trimmed};
use crate::config::{LevelUp, ModeConfig};
use crate::error::{Error, Result};
use crate::files::write_inside;
use crate::measure::{DEFINITION, GIVEN_BITS};
use crate::scene::{Camera, RaySource};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::path::Path;

/// The report's files by name.
pub type Output = Vec<(String, Vec<u8>)>;

/// A card of the verdict strip.
fn card(plan: &Plan, headline: &Headline, dot: Option<&DesignPoint<'_>>) -> Value {
    let (name, label, mode) = (&headline.name, headline.design.label(), headline.design.sentence());
    let Some(d) = dot else {
        let same = |r: &&super::plan::NotLegal| r.design.starts_with(&label);
        let reason = plan.not_legal.iter().find(same).map_or("not measured", |r| r.reason.as_str());
        return json!({"name": name, "label": label, "mode": mode, "reason": reason});
    };
    let (p, zero) = (&d.aggregate, d.aggregate.wrong() + d.aggregate.limits() == 0);
    let lines = vec![
        json!({"what": "wrong texels", "value": sections::of(p.wrong(), p.rays()), "exact": p.wrong()}),
        json!({"what": "of the rays before rounding", "value": sections::of(p.unrounded_wrong(), p.rays()), "exact": p.unrounded_wrong()}),
        json!({"what": "given up", "value": sections::of(p.limits(), p.rays()), "exact": p.limits()}),
        json!({"what": "uv error p99 / max, texel", "value": format!("{} / {}", short(d.uv_p99()), short(p.largest(|c| c.uv_all.max)))}),
        json!({"what": "t error max, of the height", "value": short(p.largest(|c| c.t_max))}),
        json!({"what": "cycles per ray that ends", "value": short(p.cycles())}),
    ];
    json!({"name": name, "label": label, "mode": mode, "big": if zero { "0".to_owned() } else { format!("{} %", short(100.0 * p.rate())) }, "lines": lines})
}

/// The rays of views; those by elevation left out.
fn views_of(plan: &Plan) -> impl Iterator<Item = &Rays> {
    plan.rays.iter().filter(|r| r.elevation.is_none())
}

/// The names of modes on the page, and what they do: the rows of the published table, then the rest.
fn legend() -> Vec<Value> {
    let more = deeper().take(1).chain([ModeConfig { level_up: LevelUp::Always, ..BEST }]);
    let modes = published_rows().chain(trimmed()).chain(more);
    modes.map(|m| json!({"name": m.label(), "words": m.sentence()})).collect()
}

/// Which rays of each view are traced, in words.
fn traced(plan: &Plan) -> Vec<String> {
    let most = plan.selection.most.map_or(String::new(), |n| format!(", at most {n}"));
    let words = |r: &Rays| match (&r.set.source, r.stride) {
        (RaySource::Table(table), _) => format!("{}: all {} of the table", r.set.name, table.rays.len()),
        (_, 1) => format!("{}: every pixel{most}", r.set.name),
        (_, n) => format!("{}: every {n}th pixel each way{most}", r.set.name),
    };
    views_of(plan).map(words).collect()
}

fn picture_rows(plan: &Plan) -> Result<Vec<Value>> {
    let map = &plan.maps[0];
    // Tests need no more than one picture.
    let tiny = plan.selection.extent == Extent::Tiny;
    let views = &pictures::cameras(plan);
    let legal = |h: &&Headline| h.design.design(&plan.config, map.spec.levels).is_ok();
    let shown = plan.headlines.iter().take(if tiny { 1 } else { 5 }).filter(legal);
    let jobs: Vec<_> = shown.flat_map(|h| views.iter().map(move |view| (h, view))).collect();
    let one = |(h, (view, camera)): &(&Headline, &(String, Camera))| {
        let p = pictures::view(plan, map, &h.design, camera)?;
        let uri = |p: &[crate::scene::Picture; 3]| p.iter().map(pictures::data_uri).collect::<Result<Vec<_>>>();
        Ok(json!({
            "design": h.design.label(), "view": view, "whole": uri(&p.whole)?, "near": uri(&p.near)?,
            "wrong": sections::of(p.counts[1], p.counts[0]), "limits": p.counts[2], "pixel": p.worst,
            "error": if p.error.is_finite() { short(p.error) + " texels" } else { "given up".to_owned() },
        }))
    };
    jobs.par_iter().map(one).collect()
}

/// All files of a report; `again` is the command that makes it.
///
/// # Errors
/// A template that does not fit its values.
pub fn files(plan: &Plan, measurements: &[Measurement], again: &str) -> Result<Output> {
    let (angles, views): (Vec<Measurement>, Vec<Measurement>) =
        measurements.iter().cloned().partition(|c| c.spec.elevation.is_some());
    let (points, lines) = (design_points(plan, &views), series(plan, &views, &angles));
    let claims = published::claims(plan, &views);
    let tables = [
        sections::worst(plan, &points),
        sections::pareto(&points),
        inventory::series(&lines),
        inventory::steps(plan, &views),
        sections::histogram(plan, &points),
        sections::matrix(plan, &points),
        published::table(&views),
        claims.clone(),
        inventory::not_legal(&plan.not_legal),
        inventory::maps(plan),
        super::units::units(plan),
        bilinear::table(plan)?,
        inventory::measurements(measurements),
    ];
    let c = &plan.config;
    let head = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "config": c.hash(),
        "seed": c.map.seed,
        "command": again,
        "cells": measurements.len(),
        "designs": points.len(),
        "rays": measurements.iter().map(|x| x.rays).sum::<u64>(),
        "unjudged": measurements.iter().map(|x| x.unjudged).sum::<u64>(),
        "picture": [c.view.width, c.view.height],
        "strides": views_of(plan).map(|r| r.stride).collect::<Vec<_>>(),
        "views": views_of(plan).map(|r| r.set.name.as_str()).collect::<Vec<_>>(),
        "side": 1u64 << c.traverse.levels,
        "mode": BEST.label(),
    });
    let mut report = json!({"report": head});
    for t in &tables {
        report[t.name] = t.json();
    }
    let mut out =
        vec![("report.json".to_owned(), (serde_json::to_string_pretty(&report).map_err(bad)? + "\n").into_bytes())];
    for name in ["cells", "pareto", "steps", "published"] {
        let table = tables.iter().find(|t| t.name == name);
        out.extend(table.map(|t| (format!("{name}.csv"), t.csv())));
    }
    let cards: Vec<Value> =
        plan.headlines.iter().map(|h| card(plan, h, points.iter().find(|d| *d.design == h.design))).collect();
    let along = |by: &str, what: &str| charts::along(plan, &lines, by, what);
    let named: Vec<String> = plan
        .headlines
        .iter()
        .filter_map(|h| points.iter().find(|d| *d.design == h.design))
        .map(charts::histogram)
        .collect();
    let mut clouds =
        [Plot::Wrong, Plot::Uv, Plot::Size, Plot::Placed].map(|plot| charts::pareto(plan, &points, plot)).to_vec();
    clouds.retain(|svg| !svg.is_empty());
    let give_up = |d: &&DesignPoint<'_>| !d.comparable();
    let left_out: Vec<String> = points
        .iter()
        .filter(give_up)
        .map(|d| format!("{} (given up: {})", d.label(), sections::of(d.aggregate.limits(), d.aggregate.rays())))
        .collect();
    let charts = json!({
        "pareto": clouds,
        "angle": [along("angle", "wrong"), along("angle", "uv"), along("angle", "cycles")],
        "size": [along("size", "wrong"), along("size", "uv"), along("size", "cycles")],
        "bits": [along("bits", "wrong"), along("bits", "uv"), along("bits", "cycles")],
        "histogram": named,
    });
    let shown: serde_json::Map<String, Value> =
        tables.iter().filter(|t| t.name != "cells").map(|t| (t.name.to_owned(), t.page())).collect();
    let page = json!({
        "head": head, "rays": grouped(measurements.iter().map(|x| x.rays).sum()), "cards": cards, "left_out": left_out, "charts": charts, "tables": shown, "pictures": picture_rows(plan)?, "refined": bilinear::pictures(plan)?,
        "traced": traced(plan), "legend": legend(), "uv": DEFINITION, "given_bits": GIVEN_BITS, "claims": published::claim_words(&claims), "levels": c.traverse.levels, "map": plan.maps[0].spec.name, "placed": points.iter().filter(|d| d.placed.is_some()).count(),
    });
    out.push(("report.html".to_owned(), html(&page)?.into_bytes()));
    Ok(out)
}

fn bad(e: impl std::fmt::Display) -> Error {
    Error::input(format!("the report: {e}"))
}

fn html(page: &Value) -> Result<String> {
    let mut env = minijinja::Environment::new();
    env.set_trim_blocks(true);
    env.set_lstrip_blocks(true);
    env.set_undefined_behavior(minijinja::UndefinedBehavior::Strict);
    env.add_template("style.css", include_str!("templates/style.css")).map_err(bad)?;
    env.add_template("page.html", include_str!("templates/page.html")).map_err(bad)?;
    env.get_template("page.html").and_then(|t| t.render(minijinja::Value::from_serialize(page))).map_err(bad)
}

/// Writes the files of a report, each beside its place first.
///
/// # Errors
/// If the directory can't be written.
pub fn write(out: &Path, files: &Output) -> Result<()> {
    files.iter().try_for_each(|(name, bytes)| write_inside(out, name, bytes))
}
