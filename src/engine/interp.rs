//! The interpreter as an engine: it runs what the emitted text is printed from.
use super::run::{Checked, Engine, Replay, SlotLoad, Traced};
use super::stored::{memory, pyramid_of, ray_of};
use crate::catalogue::{CheckReport, check_interp, compare, design_at, takes_rays};
use crate::config::Config;
use crate::error::{Error, Result};
use crate::golden::{Pyramid, RayInput, datapath};
use crate::interp::Traffic;
use crate::trace::{Pipeline, diagnose, images, trace_interp};
use std::time::{Duration, Instant};

/// Copies of the unit that share the rays in rough traffic.
const LANES: usize = 8;
/// Seed of the rough traffic.
const SEED: u64 = 11;

/// The interpreter.
pub(super) struct Interp;

impl Engine for Interp {
    fn name(&self) -> &'static str {
        "interp"
    }

    fn needs(&self) -> Vec<String> {
        Vec::new()
    }

    fn reads_text(&self) -> bool {
        false
    }

    fn replay(&self, r: &Replay<'_>) -> Result<Checked> {
        if takes_rays(r.unit) {
            return rays(r);
        }
        let report = check_interp(r.unit, r.set)?;
        report.verdict(r.set, r.unit)?;
        Ok(Checked { unit: r.unit.name.clone(), rows: report.checked, note: String::new(), slots: None })
    }

    fn trace(&self, c: &Config, pyramid: &Pyramid, rays: &[RayInput]) -> Result<Traced> {
        let start = Instant::now();
        let hits = trace_interp(&c.design(), pyramid, rays)?;
        Ok(Traced { hits, build: Duration::ZERO, run: start.elapsed() })
    }
}

/// The rays of an emitted tree: under full load, and once more in rough traffic.
fn rays(replay: &Replay<'_>) -> Result<Checked> {
    let Replay { design, unit: m, place, over, set, .. } = *replay;
    let image = memory(place)?;
    let p = Pipeline::new(design, over)?;
    let d = &design_at(design, &set.params);
    let words = (datapath(d.datapath.kind).image_words)(d);
    if image.len() != words {
        return Err(Error::input(format!(
            "{}/memory.hex has {} words, the map has {words}",
            place.display(),
            image.len()
        )));
    }
    let images = images(&p.net, &image);
    let stream = p.stream();
    // One copy tells how busy its slots are, as a simulator does; where that is not asked, several are done earlier.
    let lanes = if over.is_empty() { 1 } else { LANES };
    let run = stream.run(&set.stimulus, &images, lanes, Traffic::default())?;
    let r: CheckReport = compare(set, "interp", &run.results)?;
    if let Some(x) = &r.first {
        let told = match diagnose(d, &pyramid_of(d, &image)?, &ray_of(&set.stimulus[x.vector]))? {
            Some(divergence) => divergence.to_string(),
            None => {
                "interpreter and golden model agree in every iteration of this ray: the expected row is what differs"
                    .into()
            }
        };
        return r.verdict(set, m).map(|()| unreachable!("there is a mismatch")).map_err(|e| match e {
            Error::Mismatch(found) => Error::Mismatch(found.and(told)),
            e => e,
        });
    }
    let rough = stream.run(&set.stimulus, &images, LANES, Traffic::rough(SEED))?;
    compare(set, "interp with gaps, stalls and resets", &rough.results)?.verdict(set, m)?;
    let note = format!(
        "slots busy: {} of {} under full load; {} clocks from first ray to last hit",
        run.busy, run.loaded, run.cycles
    );
    let slots = Some(SlotLoad { busy: run.busy, loaded: run.loaded, clocks: run.cycles });
    Ok(Checked { unit: m.name.clone(), rows: r.checked, note, slots })
}
