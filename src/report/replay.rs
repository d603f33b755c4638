//! The commands that show a witness again.
use super::measurement::{Measurement, Witness};
use super::plan::{Map, Plan};
use crate::measure::{again, settings};

/// The map's part of a command line.
fn arguments(plan: &Plan, map: &Map, measurement: &Measurement) -> String {
    let mut c = measurement.spec.design.config(&plan.config, map.spec.levels);
    (c.map, c.vectors) = (plan.config.map.clone(), Default::default());
    (c.latency, c.emit) = (Default::default(), Default::default());
    (c.map.kind, c.map.scale, c.map.repeat) = (map.spec.kind, map.spec.scale, map.spec.repeat);
    let map = map.file.as_ref().map_or(String::new(), |f| format!(" --map '{}'", f.display()));
    map + &settings(&c)
}

/// Traces the witness again: its ray as a table, its hit as another.
pub fn command(plan: &Plan, measurement: &Measurement, w: &Witness) -> String {
    let Some(map) = plan.maps.iter().find(|s| s.spec == measurement.spec.map) else {
        return String::new();
    };
    again(w.numbers, &arguments(plan, map, measurement))
}
