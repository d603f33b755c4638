//! What latencies that were chosen for a clock are good for, in one sentence.
use super::super::{DatapathConfig, Design, LatencyConfig};
use super::curves::{Curve, LATENCY_KEYS, Point, curves, field};
use super::{Choice, Scope};
use reliefrtl_base::format::FloatFormat;
use reliefrtl_base::measured::Entry;

impl Choice {
    /// One sentence about the latencies that a design ended up with, which `--set` may have changed since: what they were measured at, and what
    /// is not known.
    pub fn provenance(&self, mhz: u32, d: &Design, scope: Scope) -> String {
        let how = |e: &Entry| format!("on an ECP5, speed grade 8, at 1/7/16, {}", seeds(e));
        let mut said = match self.placed {
            None if scope == Scope::Traversal && between(self.latency) != between(d.latency) => format!(
                "latencies for {mhz} MHz: registers between the units were changed, and with the change nothing was placed and routed, so nothing is promised"
            ),
            Some((profile, ..)) if self.latency != d.latency => format!(
                "latencies for {mhz} MHz: those of profile {}, and with the changes to them nothing was placed and routed, so nothing is promised",
                profile.word()
            ),
            Some((profile, whole, entry)) => format!(
                "latencies for {mhz} MHz: those of profile {}, which was placed and routed whole at {whole} MHz on an ECP5, speed grade 8, {}",
                profile.word(),
                seeds(entry)
            ),
            None => {
                let alone = |c: Curve| {
                    let clocks = *field(&mut d.latency.clone(), c.of.key);
                    (c.of.unit, clocks, c.points.into_iter().find(|p| p.clocks == clocks))
                };
                let all: Vec<_> = curves(&self.timed, &d.latency).into_iter().map(alone).collect();
                match all.iter().min_by_key(|u| u.2.map(|p| p.mhz)) {
                    None => format!("latencies for {mhz} MHz: nothing of this was measured, so nothing is promised"),
                    Some((unit, clocks, None)) => format!(
                        "latencies for {mhz} MHz: {unit} in {} was not measured, so nothing is promised",
                        counted(*clocks)
                    ),
                    Some((unit, clocks, Some(Point { mhz: reached, entry, .. }))) => {
                        let expected = reached * self.share / 100;
                        let short = if expected < mhz { format!(", which is less than {mhz}") } else { String::new() };
                        match scope {
                            Scope::Alone(_) => format!(
                                "latencies for {mhz} MHz: {unit} in {} alone reached {reached} MHz {}{short}",
                                counted(*clocks),
                                how(entry)
                            ),
                            Scope::Traversal => format!(
                                "latencies for {mhz} MHz: the slowest unit alone, {unit} in {}, reached {reached} MHz {}; {} % of that are counted on for a whole traversal, {expected} MHz{short}",
                                counted(*clocks),
                                how(entry),
                                self.share
                            ),
                        }
                    }
                }
            }
        };
        said += "; other devices were not measured";
        let default = Design::default();
        let other = match scope {
            // The widths of a conversion come from the traversal's.
            Scope::Alone(_) => {
                let converts = self.timed.iter().any(|u| ["from_int", "to_int"].contains(&u.key));
                d.format != FloatFormat::FP24 || (converts && d.traverse != default.traverse)
            }
            Scope::Traversal => {
                let datapath = DatapathConfig { kind: d.datapath.kind, ..default.datapath };
                (d.format, d.traverse, d.mode, d.datapath) != (default.format, default.traverse, default.mode, datapath)
            }
        };
        if other {
            let what = if scope == Scope::Traversal { "design" } else { "format or width" };
            said += &format!(", nor was this {what}: place it (`reliefrtl synth`) before you rely on it");
        }
        said
    }
}

/// How far a figure can be relied on.
fn seeds(entry: &Entry) -> String {
    let mhz: Vec<f64> = entry.clock.iter().flat_map(|c| &c.mhz).map(|m| m.1).collect();
    let least = mhz.iter().copied().fold(f64::INFINITY, f64::min);
    match mhz.len() {
        _ if entry.digest.is_none() => "with an earlier text, and was not measured since".into(),
        0 | 1 => "one seed of the placer".into(),
        n => format!("median of {n} seeds, of which the slowest was at {}", least as u32),
    }
}

/// Latencies of what is no unit of arithmetic.
fn between(mut l: LatencyConfig) -> LatencyConfig {
    LATENCY_KEYS.iter().for_each(|key| *field(&mut l, key) = 0);
    l
}

fn counted(clocks: u32) -> String {
    if clocks == 1 { "1 clock".into() } else { format!("{clocks} clocks") }
}
