//! `reliefrtl build`: the whole way, and a summary. `vectors`: the golden vectors alone.
use super::args::{BuildArgs, Cli, Engine, VectorsArgs};
use super::output::{spinner, table};
use crate::config::View;
use crate::error::{Error, Result};
use crate::files::Part;
use crate::measure::steps;
use crate::project::{self, Scene, check_tree};
use crate::scene::Camera;
use serde_json::json;

/// Runs `build`.
pub fn run(cli: &Cli, a: &BuildArgs) -> Result<()> {
    let c = super::config::load(cli)?;
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
    let (rays, hits) = super::render::trace(cli, &c, Engine::Interp, &scene, &camera, stride)?;
    let picture = super::render::picture(&c, &scene, &camera, stride, &rays, &hits, false)?.to_png()?;
    p.files.iter().try_for_each(|(path, text)| dir.add(path, text.as_bytes()))?;
    dir.add("preview.png", &picture)?;
    dir.commit()?;
    bar.set_message("checking every vector in the interpreter");
    let checked = check_tree(&c, &a.out, None, &[], None, None, &|_| ())?;
    let mut views = Vec::new();
    for view in &c.view.names {
        bar.set_message(format!("tracing the {view} view"));
        let camera = Camera::standard(*view, c.view.width, c.view.height);
        let (_, hits) = super::render::trace(cli, &c, Engine::Interp, &scene, &camera, c.view.stride)?;
        views.push((view, steps(&hits)));
    }
    bar.finish_and_clear();
    let (t, depth) = (&p.traverse, p.traverse.setup + p.traverse.slots + p.traverse.finish);
    if cli.json {
        let views: Vec<_> = views
            .iter()
            .map(|(v, s)| json!({"view": v.word(), "rays": s.rays, "mean_steps": s.mean, "max_steps": s.max, "max_ray": s.witness, "given_up": s.limits}))
            .collect();
        let units: Vec<_> =
            checked.iter().map(|x| json!({"unit": x.unit, "checked": x.rows, "mismatched": 0})).collect();
        let value = json!({"out": a.out, "map": map_of(&scene), "modules": p.modules.len(), "slots": t.slots, "setup": t.setup, "finish": t.finish, "units": units, "views": views});
        println!("{}", serde_json::to_string_pretty(&value).expect("plain data"));
        return Ok(());
    }
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
    super::check::print(cli, &checked);
    println!(
        "\nrays traced through the datapath (every {}th pixel of {} x {} in each direction):",
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
    Ok(())
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

/// Runs `vectors`.
pub fn vectors(cli: &Cli, a: &VectorsArgs) -> Result<()> {
    let (c, alone) = super::config::load_for(cli, &a.unit)?;
    let campaign = a.campaign.campaign(!alone.is_empty())?;
    let over = project::parameters(&a.param)?;
    alone.iter().try_for_each(|m| project::accepts(m, &over))?;
    let dir = super::output::directory(&a.out)?;
    let bar = spinner(cli, "computing vectors");
    let own: Vec<String> = a.unit.iter().map(|name| format!("golden/{name}/")).collect();
    let files = if alone.is_empty() && !over.is_empty() {
        let map = a.map.map.as_deref();
        let each = a.unit.iter().map(|name| project::unit_vectors(&c, name, &over, map, a.map.resample));
        each.collect::<Result<Vec<_>>>()?.into_iter().flatten().collect()
    } else if alone.is_empty() {
        let scene = Scene::new(&c, a.map.map.as_deref(), a.map.resample)?;
        let mut files = project::vectors(&c, &scene)?;
        files.retain(|f, _| own.is_empty() || own.iter().any(|dir| f.starts_with(dir)));
        files
    } else {
        alone.iter().flat_map(|m| project::alone_vectors(&c, m, &over, campaign)).collect()
    };
    if files.is_empty() {
        return Err(Error::NothingRan(crate::catalogue::without_vectors(&c.design(), &a.unit)));
    }
    let own: Vec<&str> = if own.is_empty() { vec!["golden/"] } else { own.iter().map(String::as_str).collect() };
    let part = Part { config: c.hash(), replaces: &own, alone_in: &[] };
    super::output::fill(dir.only(part), &files)?;
    bar.finish_and_clear();
    if cli.json {
        println!("{}", json!({"out": a.out, "files": files.keys().collect::<Vec<_>>()}));
    } else {
        println!("{} files in {}", files.len(), a.out.join("golden").display());
    }
    Ok(())
}
