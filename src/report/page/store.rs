//! Measuring all cells, each into a file of its own: what is there already is taken, so that a run can be stopped and resumed.
use super::cell::{Cell, CellSpec, Reference, canonical, probe};
use super::plan::{Job, Plan};
use crate::error::{Error, Result};
use crate::files::write_atomic;
use std::collections::btree_map::{BTreeMap, Entry};
use std::path::Path;

/// How many cells were measured, and how many came from an earlier run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Measured now.
    pub measured: usize,
    /// Taken from files.
    pub taken: usize,
}

fn spec(plan: &Plan, job: &Job) -> CellSpec {
    CellSpec {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        map: plan.sites[job.site].spec.clone(),
        view: job.view,
        elevation: job.elevation,
        picture: [plan.config.view.width, plan.config.view.height],
        stride: job.stride,
        design: plan.designs[job.design].clone(),
    }
}

/// Name of a cell's file: the digest of its canonical description.
///
/// # Errors
/// Never: a description is plain data.
pub fn name(spec: &CellSpec) -> Result<String> {
    Ok(format!("{}.json", blake3::hash(canonical(spec)?.as_bytes()).to_hex()))
}

/// All cells of a plan in its order; `progress` is told after each.
///
/// # Errors
/// If the directory can't be written.
pub fn cells(plan: &Plan, out: &Path, progress: &dyn Fn(usize, usize)) -> Result<(Vec<Cell>, Work)> {
    let dir = out.join("cells");
    std::fs::create_dir_all(&dir).map_err(|e| Error::file("create", &dir, e))?;
    let (mut found, mut work) = (Vec::new(), Work::default());
    let mut references: BTreeMap<(usize, String), Reference> = BTreeMap::new();
    for at in &plan.cells {
        let site = &plan.sites[at.site];
        let spec = spec(plan, at);
        let path = dir.join(name(&spec)?);
        // One map's rays at a time: those of a large map take room.
        references.retain(|key, _| key.0 == at.site);
        let reference = match references.entry((at.site, spec.from())) {
            Entry::Occupied(there) => there.into_mut(),
            Entry::Vacant(free) => free.insert(Reference::new(plan, site, at)?),
        };
        let design = spec.design.design(&plan.config, site.spec.levels)?;
        let stored = std::fs::read_to_string(&path).ok().and_then(|text| serde_json::from_str::<Cell>(&text).ok());
        let fresh = match stored {
            Some(cell) => (cell.spec == spec && cell.probe == probe(&design, site, &reference.rays)?.1).then_some(cell),
            None => None,
        };
        found.push(match fresh {
            Some(cell) => {
                work.taken += 1;
                cell
            }
            None => {
                work.measured += 1;
                let cell = Cell::measure(plan, site, spec, reference)?;
                write_atomic(&path, (canonical(&cell)? + "\n").as_bytes())?;
                cell
            }
        });
        progress(found.len(), plan.cells.len());
    }
    Ok((found, work))
}
