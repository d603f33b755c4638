//! `reliefrtl trace`: rays from a table, hits into a table, by any engine; the bytes are the same.
use super::args::{Cli, RaysArg, TraceArgs};
use super::output::spinner;
use super::views::Pixels;
use crate::config::Config;
use crate::error::{Error, Result};
use crate::golden::RayInput;
use crate::project::{self, Lost, Scene, without_border_hits};
use crate::scene::border::enter_border;
use crate::scene::{RaySet, RaySource, evenly};
use crate::trace::{hits_csv, record, refused};
use crate::units::traversal::TRAVERSE;

/// Runs `trace`.
pub fn run(cli: &Cli, a: &TraceArgs) -> Result<()> {
    let c = super::load::load(cli)?;
    let mut seen = a.scene.clone();
    if let Some(RaysArg::Count(n)) = seen.rays
        && seen.view.is_empty()
    {
        // Without a view there is nothing to count: a number is a file's name, too.
        seen.rays = Some(RaysArg::File(n.to_string().into()));
    }
    let named = super::views::inputs(&seen);
    let inputs = named.iter().map(|p| Some(p.as_path())).chain([c.map.file.as_deref(), cli.config.as_deref()]);
    let inputs: Vec<_> = inputs.collect();
    super::output::keep_inputs(&a.out, &inputs)?;
    a.wave.as_deref().map_or(Ok(()), |wave| super::output::keep_inputs(wave, &inputs))?;
    let out = super::output::sink(&a.out)?;
    let wave = a.wave.as_deref().map(|path| super::output::wave_sink(path, Some(&out))).transpose()?;
    if !seen.chosen() {
        return Err(Error::input("trace needs rays: --rays R.csv, or --view NAME|CAMERA.toml,..."));
    }
    let scene = Scene::new(&c, seen.map.map.as_deref(), seen.map.resample)?;
    let mut entered: Vec<[f64; 4]> = Vec::new();
    let mut rays: Vec<RayInput> = Vec::new();
    for set in super::views::sets(&seen, &[], c.mode.lod)? {
        let (numbers, lods) = numbers(&c, &scene, &set, seen.count())?;
        let lod = |k: usize| lods.get(k).map_or(0, |l| (*l).min(c.traverse.levels));
        rays.extend(numbers.iter().enumerate().map(|(k, r)| RayInput { lod: lod(k), ..project::ray(&c, *r) }));
        entered.extend(numbers);
    }
    let bar = spinner(cli, format!("tracing {} rays", rays.len()));
    let mut hits = a.engine.engine().trace(&c, &scene.pyramid, &rays)?.hits;
    bar.finish_and_clear();
    let mut refused = refused(&c.design(), &scene.pyramid, &rays, &hits)?;
    let beyond = without_border_hits(&c, &entered, &mut hits, &mut refused);
    let recorded = match &wave {
        None => None,
        Some((sink, format)) => {
            let ray = rays
                .get(a.wave_ray)
                .ok_or_else(|| Error::input(format!("--wave-ray {} is none of the {} rays", a.wave_ray, rays.len())))?;
            Some((record(&c.design(), &scene.pyramid, ray)?.1, sink, *format))
        }
    };
    // Each is written, even if the other can't be: no reader may be left waiting at a pipe.
    let written = out.write(hits_csv(&c.design(), c.map.border, &hits, &refused).as_bytes());
    let waved = recorded.map_or(Ok(()), |(wave, sink, format)| wave.write(sink, format, TRAVERSE));
    written.and(waved)?;
    let lost = Lost { beyond, ..Lost::of(&hits, &refused) };
    if cli.json {
        println!(
            "{}",
            serde_json::json!({"rays": hits.len(), "refused": lost.refused, "beyond": lost.beyond, "given_up": lost.given_up, "out": a.out})
        );
    } else {
        let rays = if hits.len() == 1 { "ray" } else { "rays" };
        println!("{} {rays} traced into {}", hits.len(), a.out.display());
        super::lost::print(&lost, &c, hits.len());
    }
    lost.verdict(hits.len())
}

/// A set's rays in tiles of the design, and their levels of detail. A table's rays stay all, whatever lies beyond the border, for each has
/// its line of hits.
fn numbers(c: &Config, scene: &Scene, set: &RaySet, most: Option<usize>) -> Result<(Vec<[f64; 4]>, Vec<u32>)> {
    let RaySource::Table(table) = &set.source else {
        if most == Some(0) {
            return Err(super::views::none_asked());
        }
        let rays = evenly(&scene.set(c, set, Pixels::Drawn.stride(c, set))?, most);
        if rays.is_empty() {
            return Err(super::views::no_ray(&set.given));
        }
        return Ok((rays.iter().map(|r| [r.u, r.v, r.du, r.dv]).collect(), Vec::new()));
    };
    let entered = enter_border(c.map.border, &table.rays).map_err(|e| Error::input(format!("{}: {e}", set.given)))?;
    let lods = table.lods.clone().unwrap_or_default();
    if !c.mode.lod && lods.iter().any(|l| *l > 0) {
        let name = &set.given;
        return Err(Error::input(format!("{name} has levels of detail (column lod): they need mode.lod = true")));
    }
    Ok((entered, lods))
}
