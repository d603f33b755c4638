//! The commands that show a witness again.
use super::measurement::{Measurement, Witness};
use super::plan::{Map, Plan};
use crate::measure::{again, settings};

/// The map's part of a command line.
fn arguments(plan: &Plan, site: &Map, cell: &Measurement) -> String {
    let mut c = cell.spec.design.config(&plan.config, site.spec.levels);
    (c.map, c.vectors) = (plan.config.map.clone(), Default::default());
    (c.latency, c.emit) = (Default::default(), Default::default());
    (c.map.kind, c.map.scale, c.map.repeat) = (site.spec.kind, site.spec.scale, site.spec.repeat);
    let map = site.file.as_ref().map_or(String::new(), |f| format!(" --map '{}'", f.display()));
    map + &settings(&c)
}

/// Traces the witness again: its ray as a table, its hit as another.
pub fn command(plan: &Plan, cell: &Measurement, w: &Witness) -> String {
    let Some(site) = plan.sites.iter().find(|s| s.spec == cell.spec.map) else {
        return String::new();
    };
    again(w.numbers, &arguments(plan, site, cell))
}
