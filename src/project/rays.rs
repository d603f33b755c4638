//! The rays of an emitted tree, replayed by the interpreter: under full load, and once more in rough traffic.
use super::check::Checked;
use super::stored::{memory, pyramid_of, ray_of};
use crate::catalogue::{CheckReport, compare, design_at};
use crate::config::Design;
use crate::error::{Error, Result};
use crate::interp::Traffic;
use crate::ir::{Binding, Module};
use crate::trace::{Pipeline, diagnose, images};
use crate::vectors::VectorSet;
use std::path::Path;

/// Copies of the unit that share the rays in rough traffic.
const LANES: usize = 8;
/// Seed of the rough traffic.
const SEED: u64 = 11;

/// The plusargs with which a bench of `traverse` runs its set once more in rough traffic.
pub(super) fn rough(m: &Module) -> &'static [&'static str] {
    if m.latency.is_none() { &["again"] } else { &[] }
}

/// The traverse unit in the interpreter, with `over` put over its parameters.
pub(super) fn rays(d: &Design, place: &Path, m: &Module, over: &Binding, set: &VectorSet) -> Result<Checked> {
    let image = memory(place)?;
    let p = Pipeline::new(d, over)?;
    let d = &design_at(d, &set.params);
    if image.len() != p.net.mems[0].depth {
        return Err(Error::input(format!(
            "{}/memory.hex has {} words, the pyramid has {}",
            place.display(),
            image.len(),
            p.net.mems[0].depth
        )));
    }
    let images = images(&p.net, &image);
    let stream = p.stream();
    // One copy tells how busy its slots are, as a simulator does; where nobody asks, several are done earlier.
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
    Ok(Checked { unit: m.name.clone(), rows: r.checked, note })
}
