//! `reliefrtl fit`: the smallest design that keeps an error budget on one scene.
use super::args::{Cli, FitArgs};
use super::output::{spinner, table};
use crate::config::{Config, View};
use crate::error::{Error, Result};
use crate::project::Scene;
use crate::report::{Budget, Fit, Limits, Trial, Truth, fit};
use serde_json::json;

/// Rays of a view that the search uses; as many others check the result.
const RAYS: usize = 6000;

/// Runs `fit`.
pub fn run(cli: &Cli, a: &FitArgs) -> Result<()> {
    let c = super::config::load(cli)?;
    let budget = match (a.max_wrong_texel, a.max_uv_error) {
        (Some(share), None) if (0.0..1.0).contains(&share) => Budget::WrongTexel(share),
        (Some(share), None) => {
            return Err(Error::input(format!("--max-wrong-texel {share} is no share: 0 to below 1 are legal")));
        }
        (None, Some(e)) if e > 0.0 && e <= 4096.0 => Budget::UvError(e),
        (_, Some(e)) => {
            return Err(Error::input(format!("--max-uv-error {e} is no distance in texels: above 0, at most 4096")));
        }
        (None, None) => {
            return Err(Error::input("fit needs a budget: --max-wrong-texel SHARE or --max-uv-error TEXELS"));
        }
    };
    for (key, is_on) in [("mode.lod", c.mode.lod), ("mode.bilinear", c.mode.bilinear)] {
        if is_on {
            return Err(Error::input(format!(
                "fit judges block hits and chooses the modes itself: leave out {key} = true, and set it in the configuration that fit writes"
            )));
        }
    }
    let views = if a.views.is_empty() { c.view.names.clone() } else { a.views.clone() };
    let scene = Scene::new(&c, a.map.map.as_deref(), a.map.resample)?;
    let of = |shift| {
        let rays = rays(&c, &scene, &views, shift)?;
        Truth::new(c.traverse.levels, c.traverse.height_bits, scene.texels.clone(), rays)
    };
    let (seen, fresh) = (of(false)?, of(true)?);
    if seen.rays.is_empty() || fresh.rays.is_empty() {
        return Err(Error::NothingRan("no ray of the views meets the map".into()));
    }
    let bar = spinner(cli, "fitting");
    let limits = Limits { resample: a.allow_resample };
    let found = fit(&c.design(), &seen, budget, limits, &|what| bar.set_message(what.to_string()))?;
    let check = Trial::run(&found.chosen.design, &fresh)?;
    bar.finish_and_clear();
    let kept = check.keeps(budget);
    if let Some(path) = &a.out {
        let text = configuration(&c, &found, a, &views)?.to_commented_toml();
        crate::files::write_atomic(path, text.as_bytes())?;
    }
    print(cli, &found, &check, budget, &views)?;
    if kept {
        return Ok(());
    }
    Err(Error::mismatch(format!("fresh rays break the budget: {}; ask for a tighter one", check.figure(budget))))
}

/// Rays evenly over each view's picture; `shift` takes the ones between.
fn rays(c: &Config, scene: &Scene, views: &[View], shift: bool) -> Result<Vec<[f64; 4]>> {
    let mut out = Vec::new();
    for view in views {
        let all = scene.view(c, *view, 1)?;
        // Two sets that share no ray, each of RAYS where the picture has as many.
        let n = RAYS.min(all.len() / 2);
        let pick = |k: usize| (2 * k + usize::from(shift)) * all.len() / (2 * n);
        out.extend((0..n).map(|k| &all[pick(k)]).map(|r| [r.u, r.v, r.du, r.dv]));
    }
    Ok(out)
}

/// The configuration that was asked for, with the views that were judged and the design that was found.
fn configuration(c: &Config, found: &Fit, a: &FitArgs, views: &[View]) -> Result<Config> {
    let (mut c, d) = (c.clone(), found.chosen.design);
    (c.format.exp, c.format.man) = (d.format.exp, d.format.man);
    (c.traverse, c.mode, c.datapath) = (d.traverse, d.mode, d.datapath);
    c.view.names = views.to_vec();
    c.map.resample |= a.allow_resample || a.map.resample;
    if let Some(file) = &a.map.map {
        c.map.kind = crate::config::MapKind::File;
        c.map.file = Some(file.canonicalize().map_err(|e| Error::file("find", file, e))?);
    }
    c.validate()?;
    Ok(c)
}

fn print(cli: &Cli, f: &Fit, check: &Trial, budget: Budget, views: &[View]) -> Result<()> {
    let c = &f.chosen.cost;
    if cli.json {
        let trial = |t: &Trial| {
            json!({"rays": t.rays, "wrong": t.wrong, "wrong_ray": t.witness, "wrong_on_own_ray": t.wrong_own, "uv_p99": t.uv_p99, "uv_max": t.uv_max.0,
                "uv_max_ray": t.uv_max.1, "steps_mean": t.steps.mean, "steps_max": t.steps.max, "steps_max_ray": t.steps.witness, "given_up": t.steps.limits})
        };
        let d = &f.chosen.design;
        let rejected: Vec<_> = f.rejected.iter().map(|r| json!({"what": r.what, "why": r.why})).collect();
        let all = json!({"traverse": d.traverse, "mode": d.mode, "datapath": d.datapath, "exp": d.format.exp, "man": d.format.man,
            "bits": {"logic": c.logic, "products": c.products, "registers": c.registers, "memory": c.memory},
            "search": trial(&f.chosen), "fresh": trial(check), "reasons": f.reasons, "rejected": rejected, "tried": f.tried});
        println!("{}", serde_json::to_string_pretty(&all).expect("plain data"));
        return Ok(());
    }
    let views: Vec<&str> = views.iter().map(|v| v.word()).collect();
    println!("{} designs tried on {} rays ({}):", f.tried, f.chosen.rays, views.join(", "));
    f.reasons.iter().for_each(|r| println!("  {r}"));
    println!(
        "size: {} bits of logic, {} of products, {} of registers; {} bits of memory",
        c.logic, c.products, c.registers, c.memory
    );
    println!(
        "fresh rays: {}; on the rays as the design reads them {} of {} wrong",
        check.figure(budget),
        check.wrong_own,
        check.rays
    );
    let rows: Vec<Vec<String>> = f.rejected.iter().map(|r| vec![r.what.clone(), r.why.clone()]).collect();
    print!("{}", table(&["not taken", "because"], &rows));
    Ok(())
}
