//! `reliefrtl render`: the map as a picture, every pixel traced through the datapath.
use super::args::{Cli, Engine, RenderArgs};
use crate::config::{Config, View};
use crate::error::{Error, Result};
use crate::files::Sink;
use crate::golden::RayHit;
use crate::project::{Scene, encode};
use crate::scene::border::tiles;
use crate::scene::{Camera, Picture, Shader, ViewRay};
use crate::trace::shade_point;
use std::path::Path;

/// Runs `render`.
pub fn run(cli: &Cli, a: &RenderArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    super::output::keep_inputs(
        &a.out,
        &[a.map.map.as_deref(), c.map.file.as_deref(), cli.config.as_deref(), Some(Path::new(&a.view))],
    )?;
    let out = super::output::sink(&a.out)?;
    let is_file = matches!(out, Sink::File(_));
    if is_file && a.out.extension().is_none_or(|e| !e.eq_ignore_ascii_case("png")) {
        return Err(Error::input(format!("--out {}: the picture is a PNG, so its name ends in .png", a.out.display())));
    }
    let scene = Scene::new(&c, a.map.map.as_deref(), a.map.resample)?;
    let (camera, stride) = match a.view.parse::<View>() {
        Ok(view) => (Camera::standard(view, c.view.width, c.view.height), c.view.stride),
        Err(_) if a.view.ends_with(".toml") => (Camera::load(&a.view)?, 1),
        Err(_) => {
            let views = View::WORDS.join(", ");
            return Err(Error::input(format!(
                "--view {} is none of {views}, nor a camera file ending in .toml",
                a.view
            )));
        }
    };
    let (rays, hits) = trace(cli, &c, a.engine, &scene, &camera, stride)?;
    out.write(&picture(&c, &scene, &camera, stride, &rays, &hits, a.steps)?.to_png()?)?;
    let lost = super::trace::Lost::of(&hits);
    let beyond = camera.rays(c.map.scale, c.map.repeat, stride).len() - rays.len();
    if cli.json {
        println!(
            "{}",
            serde_json::json!({"rays": hits.len(), "refused": lost.refused, "given_up": lost.given_up, "beyond": beyond, "out": a.out})
        );
    } else {
        println!("{} rays, picture in {}", hits.len(), a.out.display());
        if beyond > 0 {
            println!(
                "{beyond} more go on more than half a side beyond the map's border, where map.border = \"clamp\" ends: they are left out"
            );
        }
        lost.print(&c, hits.len());
    }
    lost.verdict(hits.len())?;
    Ok(())
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
