//! Making all measurements, each into a file of its own: what is there already is taken, so that a run can be stopped and resumed.
use super::measurement::{Measurement, MeasurementSpec, Reference, canonical, probe};
use super::plan::{Job, Plan};
use crate::error::Result;
use crate::files::{read_inside, write_inside};
use crate::scene::RaySource;
use serde::{Deserialize, Serialize};
use std::collections::btree_map::{BTreeMap, Entry};
use std::path::Path;

/// Digest of the sources of the program: one that another program made is made again.
const PROGRAM: &str = env!("RELIEFRTL_SOURCES");

/// Bytes of the largest file of a measurement that is read.
const MOST: u64 = 1 << 20;

/// A measurement as its file holds it.
#[derive(Serialize, Deserialize)]
struct Stored {
    /// Digest of the sources of the program that measured.
    program: String,
    #[serde(rename = "cell")]
    measurement: Measurement,
    /// Digest of the two above, as they stand in the file.
    digest: String,
}

impl Stored {
    fn new(measurement: &Measurement) -> Result<Self> {
        let (program, measurement) = (PROGRAM.to_owned(), measurement.clone());
        Ok(Self { digest: Self::digest(&program, &measurement)?, program, measurement })
    }

    fn digest(program: &str, measurement: &Measurement) -> Result<String> {
        Ok(blake3::hash(format!("{program}\n{}", canonical(measurement)?).as_bytes()).to_hex().to_string())
    }

    /// What is stored, unless it was altered.
    fn read(text: &str) -> Option<Self> {
        let stored: Self = serde_json::from_str(text).ok()?;
        let whole = Self::digest(&stored.program, &stored.measurement).ok()? == stored.digest;
        (whole && canonical(&stored).ok()? == text.trim_end()).then_some(stored)
    }
}

/// How many measurements were made, and how many came from an earlier run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Measured now.
    pub measured: usize,
    /// Taken from files.
    pub taken: usize,
    /// Of those measured, the files that were altered, or that hold no measurement.
    pub altered: Vec<String>,
}

fn spec(plan: &Plan, job: &Job) -> MeasurementSpec {
    let of = &plan.rays[job.view];
    let (camera, table) = match &of.set.source {
        RaySource::View(_) => (None, None),
        RaySource::Camera(camera) => (Some(*camera), None),
        RaySource::Table(table) => {
            let bytes: Vec<u8> = table.rays.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
            (None, Some(blake3::hash(&bytes).to_hex()[..12].to_owned()))
        }
    };
    MeasurementSpec {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        map: plan.maps[job.map].spec.clone(),
        view: of.set.name.clone(),
        camera: if of.elevation.is_some() { None } else { camera },
        table,
        most: plan.selection.most.filter(|_| of.elevation.is_none() && of.set.camera(1, 1).is_some()),
        elevation: of.elevation,
        picture: [plan.config.view.width, plan.config.view.height],
        stride: of.stride,
        design: plan.designs[job.design].clone(),
    }
}

/// Name of a measurement's file: the digest of its canonical description.
///
/// # Errors
/// Never: a description is plain data.
pub fn name(spec: &MeasurementSpec) -> Result<String> {
    Ok(format!("{}.json", blake3::hash(canonical(spec)?.as_bytes()).to_hex()))
}

/// All measurements of a plan in its order; `progress` is told after each.
///
/// # Errors
/// If the directory can't be written.
pub fn measurements(plan: &Plan, out: &Path, progress: &dyn Fn(usize, usize)) -> Result<(Vec<Measurement>, Work)> {
    let (mut found, mut work) = (Vec::new(), Work::default());
    let mut references: BTreeMap<(usize, usize), Reference> = BTreeMap::new();
    for at in &plan.jobs {
        let map = &plan.maps[at.map];
        let spec = spec(plan, at);
        let path = format!("cells/{}", name(&spec)?);
        // One map's rays at a time: those of a large map take room.
        references.retain(|key, _| key.0 == at.map);
        let reference = match references.entry((at.map, at.view)) {
            Entry::Occupied(there) => there.into_mut(),
            Entry::Vacant(free) => free.insert(Reference::new(plan, map, at)?),
        };
        let design = spec.design.design(&plan.config, map.spec.levels)?;
        let text = read_inside(out, &path, MOST);
        let stored = text.as_deref().and_then(Stored::read);
        if (text.is_some() || out.join(&path).exists()) && stored.is_none() {
            work.altered.push(path.clone());
        }
        let fresh = match stored.filter(|s| s.program == PROGRAM) {
            Some(Stored { measurement, .. }) => (measurement.spec == spec
                && measurement.probe == probe(&design, map, &reference.rays)?.1)
                .then_some(measurement),
            None => None,
        };
        found.push(match fresh {
            Some(measurement) => {
                work.taken += 1;
                measurement
            }
            None => {
                work.measured += 1;
                let measurement = Measurement::measure(plan, map, spec, reference)?;
                write_inside(out, &path, (canonical(&Stored::new(&measurement)?)? + "\n").as_bytes())?;
                measurement
            }
        });
        progress(found.len(), plan.jobs.len());
    }
    Ok((found, work))
}
