//! `reliefrtl fit`: the smallest design that keeps an error budget on one scene.
use super::args::{Cli, FitArgs};
use super::output::{spinner, table};
use super::views::{Pixels, Viewed, look};
use crate::config::check::plain;
use crate::config::{Config, View};
use crate::error::{Error, Result};
use crate::fit::{Budget, CHOSEN, Fit, FitFigures, Limits, SETS, Trial, Truth, fit_checked};
use crate::project::Scene;

/// Runs `fit`.
pub fn run(cli: &Cli, a: &FitArgs) -> Result<()> {
    let c = super::load::load(cli)?;
    let budget = match (a.max_wrong_texel, a.max_uv_error) {
        (Some(share), None) if (FEWEST..1.0).contains(&share) => Budget::WrongTexel(share),
        (Some(share), None) => {
            return Err(Error::input(format!(
                "--max-wrong-texel {} is no share that rays can show: at least {}, below 1",
                plain(share),
                plain(FEWEST)
            )));
        }
        (None, Some(e)) if e > 0.0 && e <= 4096.0 => Budget::UvError(e),
        (_, Some(e)) => {
            let e = plain(e);
            return Err(Error::input(format!("--max-uv-error {e} is no distance in texels: above 0, at most 4096")));
        }
        (None, None) => {
            return Err(Error::input("fit needs a budget: --max-wrong-texel SHARE or --max-uv-error TEXELS"));
        }
    };
    let key = |set: &String| set.split('=').next().unwrap_or_default().trim().to_owned();
    if let Some(set) = cli.sets.iter().find(|set| CHOSEN.contains(&key(set).as_str())) {
        return Err(Error::input(format!("fit chooses {} itself: leave out --set {set}", key(set))));
    }
    for (key, is_on) in [("mode.lod", c.mode.lod), ("mode.bilinear", c.mode.bilinear)] {
        if is_on {
            return Err(Error::input(format!(
                "fit judges block hits and chooses the modes itself: leave out {key} = true, and set it in the configuration that fit writes"
            )));
        }
    }
    if c.fetch.blocks() {
        return Err(Error::input(format!(
            "fit chooses among designs that read one cell an iteration: leave out fetch.cells = {}",
            c.fetch.cells
        )));
    }
    if let Some(out) = &a.out {
        let named = super::views::inputs(&a.scene);
        let inputs = named.iter().map(|p| Some(p.as_path())).chain([c.map.file.as_deref(), cli.config.as_deref()]);
        super::output::keep_inputs(out, &inputs.collect::<Vec<_>>())?;
    }
    let out = a.out.as_deref().map(super::output::sink).transpose()?;
    let each = a.scene.count().unwrap_or(6000);
    if each == 0 {
        return Err(super::views::none_asked());
    }
    let scene = Scene::new(&c, a.scene.map.map.as_deref(), a.scene.map.resample)?;
    let views = look(&c, &a.scene, &scene, &c.view.names, Pixels::All, None)?;
    if let Some(few) = views.iter().find(|v| v.rays.len() < SETS) {
        let (name, n) = (&few.set.given, few.rays.len());
        return Err(Error::input(format!(
            "{name} has {n} rays: at least {SETS} are needed, a quarter to search with and the others to check with"
        )));
    }
    let truth = |sets: &[usize]| {
        let rays = sets.iter().flat_map(|set| rays(&views, each, *set)).collect();
        Truth::new(c.traverse.levels, c.traverse.height_bits, scene.texels.clone(), rays)
    };
    let seen = truth(&[0])?;
    if seen.rays.is_empty() {
        return Err(Error::NothingRan("no ray of the views meets the map".into()));
    }
    let tables = views.iter().filter(|v| v.set.camera(1, 1).is_none()).count();
    enough(budget, seen.rays.len(), each.saturating_mul(views.len() - tables), (views.len() - tables, tables))?;
    let bar = spinner(cli, "fitting");
    let limits = Limits { resample: a.allow_resample, block_memories: a.block_memories };
    let found = fit_checked(&c.design(), seen, &truth, budget, limits, &|what| bar.set_message(what.to_string()));
    bar.finish_and_clear();
    let found = found?;
    if let Some(out) = &out {
        let text = configuration(&c, &found.fit, a, &views)?.to_commented_toml();
        out.write(text.as_bytes())?;
    }
    let alone = |k: usize| {
        let own = rays(&views[k..=k], each, found.set);
        let truth = Truth::new(c.traverse.levels, c.traverse.height_bits, scene.texels.clone(), own)?;
        Ok((views[k].set.name.clone(), Trial::run(&found.fit.chosen.design, &truth)?))
    };
    let by_view = (0..views.len()).map(alone).collect::<Result<Vec<_>>>()?;
    print(cli, &found.fit, &found.check, budget, &by_view)
}

/// The smallest share of wrong rays that can be asked for: a thousand views of the most rays show it.
const FEWEST: f64 = 3e-10;

/// Whether so many rays to search with can show that a budget is kept: none wrong of N says less than 3 in N. `asked` are those that were asked for of
/// the pictures of views, each of which has [`SETS`] times as many where it is large enough.
fn enough(budget: Budget, rays: usize, asked: usize, (views, tables): (usize, usize)) -> Result<()> {
    let Budget::WrongTexel(share) = budget else { return Ok(()) };
    let (needed, share) = ((3.0 / share).ceil(), plain(share));
    if rays as f64 >= needed {
        return Ok(());
    }
    let (all, is) = (needed * SETS as f64, "a quarter searches, the others check");
    let more = match (tables, views) {
        (_, 0) => format!("give a table of at least {all} rays ({is})"),
        (0, _) if rays >= asked => format!("give at least --rays {} (of each view)", (needed / views as f64).ceil()),
        (0, _) => {
            format!(
                "let the views' pictures have at least {all} rays in all ({is}): a larger view.width and view.height"
            )
        }
        _ => format!("let table and views have at least {all} rays in all ({is})"),
    };
    Err(Error::input(format!(
        "{rays} rays can't show that at most {share} are wrong, for none wrong says less than 3 of {rays}: {needed} are needed to search with, so {more}"
    )))
}

/// Rays evenly over each view's picture, `each` of a view where the picture has as many for every set; no two sets share one.
fn rays(views: &[Viewed], each: usize, set: usize) -> Vec<[f64; 4]> {
    // Two neighbouring sets lie as far from each other as they can.
    let place = [0, 2, 1, 3][set];
    let of = |view: &Viewed| {
        let all = &view.rays;
        // A table was chosen ray by ray: all of it counts.
        let each = if view.set.camera(1, 1).is_some() { each } else { usize::MAX };
        let n = each.min(all.len() / SETS);
        let pick = |k: usize| (SETS * k + place) * all.len() / (SETS * n);
        (0..n).map(|k| &all[pick(k)]).map(|r| [r.u, r.v, r.du, r.dv]).collect::<Vec<_>>()
    };
    views.iter().flat_map(of).collect()
}

/// The configuration that was asked for, with the views that were judged and the design that was found.
fn configuration(c: &Config, found: &Fit, a: &FitArgs, views: &[Viewed]) -> Result<Config> {
    let (mut c, d) = (c.clone(), found.chosen.design);
    (c.format.exp, c.format.man) = (d.format.exp, d.format.man);
    c.choose_datapath(d.datapath.kind);
    (c.traverse, c.mode, c.datapath, c.windows) = (d.traverse, d.mode, d.datapath, d.windows);
    // A configuration names standard views; camera files and tables are named again where it is judged.
    let names: Vec<View> = views.iter().filter_map(|v| v.set.standard()).collect();
    if !names.is_empty() {
        c.view.names = names;
    }
    c.map.resample |= a.allow_resample || a.scene.map.resample;
    if let Some(file) = &a.scene.map.map {
        c.map.kind = crate::config::MapKind::File;
        c.map.file = Some(file.canonicalize().map_err(|e| Error::file("find", file, e))?);
    }
    c.validate()?;
    Ok(c)
}

fn print(cli: &Cli, f: &Fit, check: &Trial, budget: Budget, by_view: &[(String, Trial)]) -> Result<()> {
    let c = &f.chosen.cost;
    if cli.json {
        let all = FitFigures::new(f, check, by_view);
        println!("{}", serde_json::to_string_pretty(&all).expect("plain data"));
        return Ok(());
    }
    let views: Vec<&str> = by_view.iter().map(|v| v.0.as_str()).collect();
    println!("{} designs tried on {} rays ({}):", f.tried, f.chosen.rays, views.join(", "));
    f.reasons.iter().for_each(|r| println!("  {r}"));
    println!(
        "size: {} bits of logic, {} of products, {} of registers; {} bits of memory, {} block memories of 18 kbit",
        c.logic, c.products, c.registers, c.memory, c.blocks
    );
    println!(
        "fresh rays: {}; on the rays as the design reads them {} of {} wrong",
        check.figure(budget),
        check.wrong_own,
        check.rays
    );
    if by_view.len() > 1 {
        by_view.iter().for_each(|(view, t)| println!("  of these {view}: {}", t.figure(budget)));
    }
    let rows: Vec<Vec<String>> = f.rejected.iter().map(|r| vec![r.what.clone(), r.why.clone()]).collect();
    print!("{}", table(&["not taken", "because"], &rows));
    Ok(())
}
