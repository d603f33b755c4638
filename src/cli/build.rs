//! `reliefrtl build`: the whole way, and a summary.
use super::args::{BuildArgs, Cli};
use super::output::{spinner, table};
use crate::config::{Config, View};
use crate::emit::Hardware;
use crate::engine::{Checked, CheckedFigures, EngineName};
use crate::error::Result;
use crate::golden::RayHit;
use crate::measure::{StepFigures, Steps, steps};
use crate::project::{self, Scene, check_tree, encode, surface_picture};
use crate::scene::{Camera, ViewRay};
use serde::Serialize;
use serde_json::json;
use std::path::Path;

/// What a build made and found, as `--json` prints it.
#[derive(Serialize)]
struct Built<'a> {
    /// Directory.
    out: &'a Path,
    /// The map.
    map: serde_json::Value,
    /// Modules written.
    modules: usize,
    /// Slots of the loop.
    slots: u32,
    /// Clocks from a ray's acceptance to the loop.
    setup: u32,
    /// Clocks from the loop to the output.
    finish: u32,
    /// Units whose vectors were checked.
    units: Vec<CheckedFigures<'a>>,
    /// Iterations of each view.
    views: Vec<StepFigures>,
}

/// Runs `build`.
pub fn run(cli: &Cli, a: &BuildArgs) -> Result<()> {
    let c = super::load::load(cli)?;
    let mut dir = super::output::directory(&a.out)?.of(c.hash());
    let bar = spinner(cli, "building");
    let scene = Scene::new(&c, a.map.map.as_deref(), a.map.resample)?;
    if a.print_map {
        bar.finish_and_clear();
        return print_map(cli, &scene);
    }
    let p = project::project(&c, &scene)?;
    let camera = Camera::standard(View::Oblique, c.view.width, c.view.height);
    let stride = c.view.stride.min(2);
    bar.set_message("tracing the picture through the datapath");
    let (rays, hits) = traced(&c, &scene, &camera, stride, EngineName::Interp)?;
    let picture = surface_picture(&c, &scene, &camera, stride, &rays, &hits, false).to_png()?;
    p.files.iter().try_for_each(|(path, text)| dir.add(path, text.as_bytes()))?;
    dir.add("preview.png", &picture)?;
    dir.commit()?;
    bar.set_message("checking every vector in the interpreter");
    let checked = check_tree(&c, &a.out, EngineName::Interp, &[], None, None, &|_| ())?;
    let mut views = Vec::new();
    for view in &c.view.names {
        bar.set_message(format!("tracing the {view} view"));
        let camera = Camera::standard(*view, c.view.width, c.view.height);
        // What the datapath does not count, the golden model does.
        let counted = if c.design().gives_steps() { EngineName::Interp } else { EngineName::Golden };
        let (_, hits) = traced(&c, &scene, &camera, c.view.stride, counted)?;
        views.push((view, steps(&hits)));
    }
    bar.finish_and_clear();
    if cli.json {
        let t = &p.traverse;
        let value = Built {
            out: &a.out,
            map: map_of(&scene),
            modules: p.modules.len(),
            slots: t.slots,
            setup: t.setup,
            finish: t.finish,
            units: checked.iter().map(Into::into).collect(),
            views: views.iter().map(|(view, s)| StepFigures::new(view.word(), s)).collect(),
        };
        println!("{}", serde_json::to_string_pretty(&value).expect("plain data"));
        return Ok(());
    }
    print_summary(cli, a, &c, &scene, &p, &checked, &views);
    Ok(())
}

/// What was made and found, for reading.
fn print_summary(
    cli: &Cli,
    a: &BuildArgs,
    c: &Config,
    scene: &Scene,
    p: &Hardware,
    checked: &[Checked],
    views: &[(&View, Steps)],
) {
    let (t, depth) = (&p.traverse, p.traverse.setup + p.traverse.slots + p.traverse.finish);
    match &scene.taken {
        Some(taken) => println!("map {taken}\nconfig {}, seed {}", c.hash(), c.vectors.seed),
        None => println!("map {}, config {}, seed {}", scene.name, c.hash(), c.vectors.seed),
    }
    println!(
        "{} modules in {}, {} of them units with vectors of their own, the others checked inside of these; parameters of traverse:",
        p.modules.len(),
        a.out.join("rtl").display(),
        checked.len()
    );
    let params: Vec<String> = t.module.params.iter().map(|q| format!("{}={}", q.name, q.default)).collect();
    println!("  {}", params.join(" "));
    println!(
        "pipeline: {} clocks of setup, a loop of {} slots, {} clocks to the result; {depth} in all\n",
        t.setup, t.slots, t.finish
    );
    println!("golden vectors, checked by the interpreter of the emitted datapath:");
    super::checked::print(cli, checked);
    let through = if c.design().gives_steps() { "the datapath" } else { "the golden model, as a hit has no steps" };
    println!(
        "\nrays traced through {through} (every {}th pixel of {} x {} in each direction):",
        c.view.stride, c.view.width, c.view.height
    );
    let rows: Vec<Vec<String>> = views
        .iter()
        .map(|(v, s)| {
            // In the steady state a slot starts an iteration every clock, so a ray costs as many clocks as it has steps.
            let mean = format!("{:.2}", s.mean);
            vec![
                v.word().into(),
                s.rays.to_string(),
                mean.clone(),
                s.max.to_string(),
                s.witness.to_string(),
                mean,
                s.limits.to_string(),
            ]
        })
        .collect();
    print!("{}", table(&["view", "rays", "mean steps", "max steps", "at ray", "clocks/ray", "given up"], &rows));
    for (v, s) in views.iter().filter(|(_, s)| s.limits > 0) {
        println!(
            "{} of {} rays of the {v} view have no hit: they travel 2^tile_bits = {} tiles or more, or need more than {} iterations",
            s.limits,
            s.rays + s.limits,
            1u32 << c.traverse.tile_bits,
            c.traverse.step_limit
        );
    }
    println!("\nNext, in {}:", a.out.display());
    let top = format!("{}tb_traverse", c.emit.prefix);
    println!(
        "  iverilog -g2005 -Wall -y rtl -s {top}_top -o tb.vvp testbench/{top}.v testbench/{top}_top.v && vvp -n tb.vvp"
    );
    println!(
        "  verilator --cc --exe --build -O3 -Wno-lint --prefix Vtb --top-module {top} -y rtl testbench/{top}.v testbench/verilator_main.cpp && ./obj_dir/Vtb"
    );
    println!("  open preview.png");
}

/// Rays of a camera, and their hits in an engine.
fn traced(
    c: &Config,
    scene: &Scene,
    camera: &Camera,
    stride: u32,
    engine: EngineName,
) -> Result<(Vec<ViewRay>, Vec<RayHit>)> {
    let rays = scene.rays(c, camera, stride)?;
    let words: Vec<_> = rays.iter().map(|r| encode(c, r)).collect();
    let hits = engine.engine().trace(c, &scene.pyramid, &words)?.hits;
    Ok((rays, hits))
}

/// The map for machines: what was taken of its file, or the name of a procedural one.
fn map_of(scene: &Scene) -> serde_json::Value {
    scene.taken.as_ref().map_or_else(|| json!({"kind": scene.name}), |taken| json!(taken))
}

fn print_map(cli: &Cli, scene: &Scene) -> Result<()> {
    if cli.json {
        println!("{}", serde_json::to_string_pretty(&json!({"map": map_of(scene)})).expect("plain data"));
    } else {
        match &scene.taken {
            Some(taken) => println!("map {taken}"),
            None => println!("map {}: made, no file", scene.name),
        }
    }
    Ok(())
}
