//! A whole project from one configuration: scene, Verilog, benches, vectors, manifest; and its check by any engine.
mod alone;
mod check;
mod digests;
mod same;
mod scene;
mod stored;

pub use alone::{alone, alone_files, alone_text, alone_vectors};
pub use check::{Canary, Checked, check_tree};
pub use same::same_config;
pub use scene::{Scene, encode, ray};

use crate::bench::bench_files;
use crate::catalogue::{count_events, ray_set, units, vector_set};
use crate::config::Config;
use crate::emit::{self, Files};
use crate::error::Result;
use crate::ir::{Binding, Module};
use crate::proofs::proof_files;
use crate::units::all;
use crate::units::traversal::{Traverse, traverse};
use crate::vectors::{Plan, set_files};
use std::sync::Arc;

/// Everything that `build` writes but the picture.
pub struct Project {
    /// Modules, leaves first.
    pub modules: Vec<Arc<Module>>,
    /// The traverse unit and its schedule.
    pub traverse: Traverse,
    /// Files by their path from the output directory.
    pub files: Files,
}

/// The Verilog and the manifest.
///
/// # Errors
/// A configuration that its own modules refuse.
pub fn hardware(c: &Config) -> Result<Project> {
    let d = c.design();
    let modules = emit::modules(&all(&d))?;
    let mut files = emit::rtl(c, &modules);
    let manifest = emit::manifest(c, &modules, &files);
    files.insert("manifest.json".into(), serde_json::to_string_pretty(&manifest).expect("plain data") + "\n");
    let traverse = traverse(&d);
    files.extend(emit::flow(c, std::slice::from_ref(&traverse.module), &files));
    Ok(Project { modules, traverse, files })
}

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
    let rays = scene.sample(c)?;
    let set = ray_set(&d, &scene.pyramid, &rays, c.vectors.seed)?;
    files.extend(set_files(&set.set).into_iter().map(|(n, t)| (format!("golden/traverse/{n}"), t)));
    files.extend(set.memory_files().map(|(n, t)| (format!("golden/traverse/{n}"), t.clone())));
    files.insert("golden/traverse/trace.csv".into(), set.trace);
    files.extend(digests::digests(&files));
    Ok(files)
}

/// The Verilog with its benches and proof harnesses, and the manifest.
///
/// # Errors
/// As [`hardware`].
pub fn text(c: &Config) -> Result<Project> {
    let mut p = hardware(c)?;
    let d = c.design();
    let depth = p.traverse.setup + p.traverse.slots + p.traverse.finish;
    p.files.extend(bench_files(&units(&d), Some((&p.traverse.module, depth)), &c.emit));
    let names: Vec<String> = p.files.keys().filter_map(|f| f.strip_prefix("rtl/")).map(str::to_string).collect();
    let names: Vec<String> = names.into_iter().filter(|f| f.ends_with(".v")).collect();
    p.files.extend(proof_files(&d, &all(&d), &p.traverse, &(&c.emit).into(), &names));
    Ok(p)
}

/// The whole project.
///
/// # Errors
/// As [`text`] and [`vectors`].
pub fn project(c: &Config, scene: &Scene) -> Result<Project> {
    let mut p = text(c)?;
    p.files.extend(vectors(c, scene)?);
    Ok(p)
}
