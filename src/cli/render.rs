//! `reliefrtl render`: the map as a picture, every pixel traced through the datapath.
use super::args::{Cli, RenderArgs};
use super::views::Pixels;
use crate::config::{Config, View};
use crate::engine::EngineName;
use crate::error::{Error, Result};
use crate::files::Sink;
use crate::project::{Lost, Scene, encode, footprint_picture, surface_picture};
use crate::scene::{Picture, RaySet};
use crate::trace::refused;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// A picture that is to be written.
struct Drawn {
    /// The view.
    name: String,
    /// Where it goes.
    out: PathBuf,
    picture: Picture,
    /// Rays traced.
    rays: usize,
    lost: Lost,
    /// Rays that go on beyond what was prepared beyond the border.
    beyond: usize,
}

/// Runs `render`.
pub fn run(cli: &Cli, a: &RenderArgs) -> Result<()> {
    let c = super::load::load(cli)?;
    let sets = super::views::sets(&a.scene, &[View::Oblique], false)?;
    if let Some(n) = a.scene.count() {
        return Err(Error::input(format!(
            "render draws every pixel: --rays {n} counts none; give a camera file of fewer pixels, or --rays R.csv"
        )));
    }
    if a.steps && a.engine != EngineName::Golden && !c.design().gives_steps() {
        return Err(Error::input(format!(
            "render --steps draws iterations, and emit.counters = \"{}\" gives none with a hit: use --engine golden, or another emit.counters",
            c.emit.counters
        )));
    }
    if sets.len() > 1 && !is_picture(&a.out) {
        let n = sets.len();
        return Err(Error::input(format!(
            "--out {}: {n} views are {n} pictures, so they need a name that ends in .png",
            a.out.display()
        )));
    }
    let named = super::views::inputs(&a.scene);
    let outs: Vec<PathBuf> = sets.iter().map(|set| out_of(a, set, sets.len())).collect();
    for out in &outs {
        let inputs = named.iter().map(|p| Some(p.as_path())).chain([c.map.file.as_deref(), cli.config.as_deref()]);
        super::output::keep_inputs(out, &inputs.collect::<Vec<_>>())?;
    }
    let sinks = outs.iter().map(|out| super::output::sink(out)).collect::<Result<Vec<_>>>()?;
    let is_file = sinks.iter().any(|sink| matches!(sink, Sink::File(_)));
    if is_file && !is_picture(&a.out) {
        return Err(Error::input(format!("--out {}: the picture is a PNG, so its name ends in .png", a.out.display())));
    }
    let scene = Scene::new(&c, a.scene.map.map.as_deref(), a.scene.map.resample)?;
    // All pictures are there before the first is written: a view without a hit leaves none of them.
    let drawn =
        sets.iter().zip(outs).map(|(set, out)| draw(cli, &c, a, &scene, set, out)).collect::<Result<Vec<_>>>()?;
    let pictures = drawn.iter().map(|d| d.picture.to_png()).collect::<Result<Vec<_>>>()?;
    sinks.iter().zip(&pictures).try_for_each(|(sink, png)| sink.write(png))?;
    if cli.json {
        let value = |d: &Drawn| json!({"rays": d.rays, "refused": d.lost.refused, "given_up": d.lost.given_up, "beyond": d.beyond, "out": d.out});
        // One picture is one object, as it always was.
        match drawn.as_slice() {
            [one] => println!("{}", value(one)),
            all => println!("{}", all.iter().map(value).collect::<Value>()),
        }
        return Ok(());
    }
    for d in &drawn {
        let of = if drawn.len() > 1 { format!("{}: ", d.name) } else { String::new() };
        println!("{of}{} rays, picture in {}", d.rays, d.out.display());
        if d.beyond > 0 {
            println!(
                "{} more go on more than half a side beyond the map's border, where map.border = \"clamp\" ends: they are left out",
                d.beyond
            );
        }
        super::lost::print(&d.lost, &c, d.rays);
    }
    Ok(())
}

/// Whether a name is that of a PNG.
fn is_picture(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("png"))
}

/// The file of a view's picture: that of `--out`; of several views, with the view's name after it.
fn out_of(a: &RenderArgs, set: &RaySet, views: usize) -> PathBuf {
    if views == 1 {
        return a.out.clone();
    }
    let stem = a.out.file_stem().unwrap_or_default().to_string_lossy();
    a.out.with_file_name(format!("{stem}-{}.png", set.name))
}

fn draw(cli: &Cli, c: &Config, a: &RenderArgs, scene: &Scene, set: &RaySet, out: PathBuf) -> Result<Drawn> {
    super::views::block_rays(set)?;
    let stride = Pixels::Drawn.stride(c, set);
    let rays = scene.set(c, set, stride)?;
    if rays.is_empty() {
        return Err(super::views::no_ray(&set.given));
    }
    let encoded: Vec<_> = rays.iter().map(|r| encode(c, r)).collect();
    let hits = {
        let bar = super::output::spinner(cli, format!("tracing {} rays", encoded.len()));
        let traced = a.engine.engine().trace(c, &scene.pyramid, &encoded)?;
        bar.finish_and_clear();
        traced.hits
    };
    let lost = Lost::of(&hits, &refused(&c.design(), &scene.pyramid, &encoded, &hits)?);
    lost.verdict(hits.len())?;
    let (all, picture) = match set.camera(c.view.width, c.view.height) {
        Some(camera) => (
            camera.rays(c.map.scale, c.map.repeat, stride).len(),
            surface_picture(c, scene, &camera, stride, &rays, &hits, a.steps),
        ),
        None => (rays.len(), footprint_picture(c, scene, set, &rays, &hits)),
    };
    Ok(Drawn { name: set.name.clone(), out, picture, rays: hits.len(), lost, beyond: all - rays.len() })
}
