//! `reliefrtl bench`: speed of the engines on the same rays, in turns, by processor time.
use super::args::{BenchArgs, Cli};
use super::output::{spinner, table};
use super::views::{Pixels, look};
use crate::config::View;
use crate::error::{Error, Result};
use crate::golden::RayInput;
use crate::project::{EngineSpeed, ICARUS_RAYS, Scene, SpeedTask, Speeds, encode, speeds};
use crate::scene::evenly;

/// Runs `bench`.
pub fn run(cli: &Cli, a: &BenchArgs) -> Result<()> {
    let c = super::load::load(cli)?;
    let n = a.scene.count().unwrap_or(20_000);
    if n == 0 {
        return Err(Error::NothingRan("bench needs at least one ray".into()));
    }
    let scene = Scene::new(&c, a.scene.map.map.as_deref(), a.scene.map.resample)?;
    let views = look(&c, &a.scene, &scene, &[View::Oblique], Pixels::Some, None)?;
    let names = views.iter().map(|v| v.set.name.clone()).collect();
    let seen: Vec<RayInput> = views.iter().flat_map(|v| &v.rays).map(|x| encode(&c, x)).collect();
    let rays: Vec<RayInput> = evenly(&seen, Some(n)).into_iter().cycle().take(n).collect();
    let task = SpeedTask::new(&c, scene, rays)?;
    let bar = spinner(cli, "measuring");
    let found = speeds(&c, &task, names, a.turns as usize, &|what| bar.set_message(what.to_owned()))?;
    bar.finish_and_clear();
    found.left_out.iter().for_each(|e| super::output::note(format_args!("left out: {e}")));
    if cli.json {
        println!("{}", serde_json::to_string_pretty(&found).expect("plain data"));
    } else {
        print(&found);
    }
    Ok(())
}

fn print(found: &Speeds) {
    let digits = |x: f64| if x < 0.1 { format!("{x:.4}") } else { format!("{x:.2}") };
    let row = |e: &EngineSpeed| {
        let of = e.of_verilator.map_or_else(
            || ["-".to_owned(), String::new()],
            |r| [format!("{} / {} / {}", digits(r.min), digits(r.median), digits(r.max)), r.pairs.to_string()],
        );
        let [of, pairs] = of;
        let s = e.run_s;
        vec![
            e.engine.clone(),
            e.rays.to_string(),
            format!("{:.2}", e.build_s),
            e.load_s.map_or(String::new(), digits),
            format!("{} / {} / {}", digits(s.min), digits(s.median), digits(s.max)),
            e.time.into(),
            format!("{:.0}", e.rays_per_s),
            of,
            pairs,
        ]
    };
    let head = [
        "engine",
        "rays",
        "build s",
        "load s",
        "run s: min / median / max",
        "time",
        "rays/s",
        "of verilator: min / median / max",
        "pairs",
    ];
    print!("{}", table(&head, &found.engines.iter().map(row).collect::<Vec<_>>()));
    let compared: usize = found.engines.iter().map(|e| e.compared).sum();
    println!("\n0 of {compared} hits differ from the golden model's, in every output");
    let base = found.compared_with.as_ref().map_or("no Verilator is there to compare with".into(), |name| {
        format!("compared with {name}, the faster of its builds (-O3 -march=native, rays from memory), turn by turn")
    });
    println!(
        "map {}, {}: {} iterations a turn; {base}; times of the traversal alone, Icarus, the slowest, once with its bench and {ICARUS_RAYS} rays at most",
        found.map,
        found.views.join(", "),
        found.iterations,
    );
}
