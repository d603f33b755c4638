//! A whole project from one configuration: scene, Verilog, benches, vectors, manifest; and its check by any engine.
mod alone;
mod bilinear_accuracy;
mod check;
mod corner_cases;
mod coverage;
mod digests;
mod judged;
mod lost;
mod params;
mod picture;
mod published_accuracy;
mod same;
mod scene;
mod soak;
mod speed;
mod steps;

pub use crate::emit::hardware;
pub use alone::{alone, alone_files, alone_text, alone_vectors};
pub use bilinear_accuracy::{REFINED_RAYS, RefinedView, Three, refined_view};
pub use check::{Canary, check_tree, check_tree_at};
pub use corner_cases::{
    HardCase, HardDiffers, HardGivenUp, HardGround, HardOutcome, HardSum, HardTask, HardWatch, HardWrong, hard_cases,
};
pub use coverage::{Coverage, FileCoverage, coverage};
pub use judged::{JudgedView, Uv, Witness, Worst, judge_view};
pub use lost::{Lost, without_border_hits};
pub use params::{accepts, parameters, unit_vectors};
pub use picture::{footprint_picture, surface_picture};
pub use published_accuracy::{Found, Rate, published_rates};
pub use same::same_config;
pub use scene::{Scene, encode, ray};
pub use soak::{EnduredCase, EnduredSum, LongestRay, endure_cases};
pub use speed::{EngineSpeed, ICARUS_RAYS, Range, Ratio, SpeedTask, Speeds, speeds};
pub use steps::{Beside, ModeSteps, SceneSteps, scene_steps, step_rows};

use crate::bench::bench_files;
use crate::catalogue::{RaySet, count_events, limit_sets, planned_rays, proofs, ray_set_at, units, vector_set};
use crate::config::Config;
use crate::emit::{Files, Hardware};
use crate::error::Result;
use crate::ir::Binding;
use crate::proofs::proof_files;
use crate::units::all;
use crate::vectors::{Plan, set_files};

/// The vectors of every unit, and of `traverse` over `scene`.
///
/// # Errors
/// An illegal design.
pub fn vectors(c: &Config, scene: &Scene) -> Result<Files> {
    let d = c.design();
    let plan = Plan { rows: c.vectors.arithmetic as usize, seed: c.vectors.seed };
    let mut files = Files::new();
    for m in units(&d) {
        let mut set = vector_set(&d, &m, &Binding::new(), plan);
        set.events = count_events(&d, &m, &set);
        files.extend(set_files(&set).into_iter().map(|(n, t)| (format!("golden/{}/{n}", m.name), t)));
    }
    for (place, set) in ray_sets(c, scene)? {
        files.extend(set_files(&set.set).into_iter().map(|(n, t)| (format!("{place}/{n}"), t)));
        files.extend(set.memory_files().map(|(n, t)| (format!("{place}/{n}"), t.clone())));
        files.insert(format!("{place}/trace.csv"), set.trace);
    }
    files.extend(digests::digests(&files));
    Ok(files)
}

/// The vector sets of `traverse`, each with its directory: planned rays and those of the configured views at the configured parameter
/// values; and rays that reach a step limit. Without `vectors.planned` only those of the views.
///
/// # Errors
/// An illegal design.
pub fn ray_sets(c: &Config, scene: &Scene) -> Result<Vec<(String, RaySet)>> {
    let (d, seed) = (c.design(), c.vectors.seed);
    let planned = if c.vectors.planned { planned_rays(&d, &scene.pyramid, seed)? } else { Vec::new() };
    let rays = [&planned[..], &scene.sample(c)?];
    let mut sets = vec![("golden/traverse".into(), ray_set_at(&d, &Binding::new(), &scene.pyramid, rays, seed)?)];
    let limits = if c.vectors.planned { limit_sets(&d, &scene.pyramid, seed)? } else { Vec::new() };
    for (name, set) in limits {
        sets.push((format!("golden/traverse/{name}"), set));
    }
    Ok(sets)
}

/// The Verilog with its benches and proof harnesses, and the manifest.
///
/// # Errors
/// As [`hardware`].
pub fn text(c: &Config) -> Result<Hardware> {
    let mut p = hardware(c)?;
    let d = c.design();
    p.files.extend(bench_files(&units(&d), Some((&d, &p.traverse)), &c.emit));
    let names: Vec<String> = p.files.keys().filter_map(|f| f.strip_prefix("rtl/")).map(str::to_string).collect();
    let names: Vec<String> = names.into_iter().filter(|f| f.ends_with(".v")).collect();
    let units = all(&d);
    p.files.extend(proof_files(&d, &proofs(&units), &units, &p.traverse, &(&c.emit).into(), &names));
    Ok(p)
}

/// The whole project.
///
/// # Errors
/// As [`text`] and [`vectors`].
pub fn project(c: &Config, scene: &Scene) -> Result<Hardware> {
    let mut p = text(c)?;
    p.files.extend(vectors(c, scene)?);
    Ok(p)
}
