//! `reliefrtl render`: the map as a picture, every pixel traced through the datapath.
use super::args::{Cli, Engine, RenderArgs};
use super::trace::Lost;
use super::views::Pixels;
use crate::config::{Config, View};
use crate::error::{Error, Result};
use crate::files::Sink;
use crate::golden::RayHit;
use crate::project::{Scene, encode};
use crate::scene::border::tiles;
use crate::scene::hard::{HardScene, footprints};
use crate::scene::{Camera, Picture, RaySet, Shader, ViewRay};
use crate::trace::shade_point;
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
    /// Rays that go on behind what was prepared beyond the border.
    beyond: usize,
}

/// Runs `render`.
pub fn run(cli: &Cli, a: &RenderArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    let sets = super::views::sets(&a.scene, &[View::Oblique], false)?;
    if let Some(n) = a.scene.count() {
        return Err(Error::input(format!(
            "render draws every pixel: --rays {n} counts none; give a camera file of fewer pixels, or --rays R.csv"
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
    // All pictures are there before the first is written: a view without a hit leaves none of them behind.
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
        d.lost.print(&c, d.rays);
    }
    Ok(())
}

/// Whether a name is that of a PNG.
fn is_picture(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("png"))
}

/// The file of a view's picture: that of `--out`; of several views, with the view's name behind it.
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
    let hits = super::trace::hits(cli, c, a.engine, scene, &encoded)?;
    let lost = Lost::of(&hits);
    lost.verdict(hits.len())?;
    let (all, picture) = match set.camera(c.view.width, c.view.height) {
        Some(camera) => (
            camera.rays(c.map.scale, c.map.repeat, stride).len(),
            picture(c, scene, &camera, stride, &rays, &hits, a.steps)?,
        ),
        None => (rays.len(), from_above(c, scene, set, &rays, &hits)),
    };
    Ok(Drawn { name: set.name.clone(), out, picture, rays: hits.len(), lost, beyond: all - rays.len() })
}

/// A table's rays on the map from above.
fn from_above(c: &Config, scene: &Scene, set: &RaySet, rays: &[ViewRay], hits: &[RayHit]) -> Picture {
    let d = c.design();
    let rays = rays.iter().map(|r| [r.u, r.v, r.du, r.dv]).collect();
    let hard = HardScene { design: d, texels: scene.texels.clone(), rays };
    footprints(&hard, &set.name, c.map.seed, &super::hard::ends(&d, hits))
}

/// Rays of a camera and their hits.
///
/// # Errors
/// As the engine.
pub fn trace(
    cli: &Cli,
    c: &Config,
    engine: Engine,
    scene: &Scene,
    camera: &Camera,
    stride: u32,
) -> Result<(Vec<ViewRay>, Vec<RayHit>)> {
    let rays = scene.rays(c, camera, stride)?;
    let encoded: Vec<_> = rays.iter().map(|r| encode(c, r)).collect();
    let hits = super::trace::hits(cli, c, engine, scene, &encoded)?;
    Ok((rays, hits))
}

/// The picture of hits: the surface, or the iterations.
///
/// # Errors
/// None today; pictures of impossible sizes are refused by the camera.
pub fn picture(
    c: &Config,
    scene: &Scene,
    camera: &Camera,
    stride: u32,
    rays: &[ViewRay],
    hits: &[RayHit],
    steps: bool,
) -> Result<Picture> {
    let (w, h) = camera.picture_size(stride);
    let (w, h) = (w as usize, h as usize);
    let at = |r: &ViewRay| (r.py / stride) as usize * w + (r.px / stride) as usize;
    let t = &c.traverse;
    if steps {
        let mut pixels = vec![None; w * h];
        rays.iter().zip(hits).for_each(|(r, x)| pixels[at(r)] = Some(x.steps));
        return Ok(Picture::steps(w, h, &pixels));
    }
    let d = c.design();
    let mut pixels = vec![None; w * h];
    rays.iter().zip(hits).for_each(|(r, x)| pixels[at(r)] = Some(shade_point(&d, x)));
    let shader =
        Shader::new(&scene.texels, t.levels, t.height_bits, c.map.scale, tiles(c.map.border, c.map.repeat), scene.kind);
    Ok(Picture::shaded(&shader, w, h, &pixels))
}
