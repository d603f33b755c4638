//! Latencies for a clock, from a table of measurements, and what those of a configuration are good for.
//!
//! The clocks are those of units alone on an ECP5 (85k, speed grade 8) at 1/7/16: `data/figures.json`, each with the call that measures it
//! ([`reliefrtl_base::measured`]). A traversal around them is slower: a share of the slowest unit's clock is counted on.
mod curves;
mod provenance;

pub use curves::{Part, Timed};

use super::{Design, LatencyConfig, Profile};
use curves::{Curve, LATENCY_KEYS, PLACED, curves, field};
use reliefrtl_base::error::{Error, Result};
use reliefrtl_base::measured::Entry;

/// What stands between the units of a watertight traversal.
#[derive(Clone, Copy)]
struct Tier {
    /// The highest clock that it is taken for, in MHz.
    to: u32,
    /// Whose registers stand between the units; without one, [`BARE`].
    profile: Option<Profile>,
    /// What is counted on for a whole traversal, in percent of the clock of its slowest unit alone.
    share: u32,
}

/// As few registers as work between the units: those of the published pipeline.
const BARE: LatencyConfig = Profile::Published.with_dividers(true);

/// Slowest first. The shares are margins: at most what choices came out at that were placed and routed whole.
const TIERS: [Tier; 4] = [
    Tier { to: 50, profile: None, share: 60 },
    Tier { to: 80, profile: Some(Profile::Published), share: 80 },
    Tier { to: 105, profile: Some(Profile::Balanced), share: 78 },
    Tier { to: 130, profile: Some(Profile::Fast), share: 88 },
];

/// What a clock is asked of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope<'a> {
    /// A whole traversal.
    Traversal,
    /// Units of arithmetic by themselves.
    Alone(&'a [String]),
}

/// Latencies chosen for a clock.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The latencies.
    pub latency: LatencyConfig,
    /// Percent of the slowest unit's clock that is to be expected.
    share: u32,
    /// A profile that was placed and routed as it stands, and its MHz.
    placed: Option<(Profile, u32, &'static Entry)>,
    /// The units of arithmetic whose clocks were looked at.
    timed: Vec<Timed>,
}

/// The smallest latencies that reach `mhz` with the margin that a whole traversal needs; a unit alone needs none. `units` are all of arithmetic.
///
/// # Errors
/// [`Error::Input`] if nothing that was measured reaches it.
pub fn for_clock(mhz: u32, d: &Design, scope: Scope, units: &[Timed]) -> Result<Choice> {
    let Scope::Alone(names) = scope else { return for_traversal(mhz, d, units) };
    let mut latency = d.latency;
    let timed: Vec<Timed> = names.iter().filter_map(|name| units.iter().find(|u| u.unit == name)).copied().collect();
    for name in names {
        if !timed.iter().any(|u| u.unit == name) {
            return Err(Error::input(format!(
                "--clock {mhz}: no clock of {name} was measured; leave out --clock, and set latency.*"
            )));
        }
    }
    for u in &timed {
        *field(&mut latency, u.key) = 0;
    }
    for c in curves(&timed, &d.latency) {
        pick(&mut latency, &c, mhz, mhz)?;
    }
    Ok(Choice { latency, share: 100, placed: None, timed })
}

fn for_traversal(mhz: u32, d: &Design, units: &[Timed]) -> Result<Choice> {
    let kind = d.datapath.kind;
    let tier = kind.facts().clock_by_units.then(|| TIERS.iter().find(|t| mhz <= t.to)).flatten();
    let Some(tier) = tier else {
        let placed = PLACED.iter().filter(|p| p.kind == kind);
        let (key, word) = kind.chosen_by();
        let Some(best) = placed.clone().map(|p| p.mhz).max() else {
            return Err(Error::input(format!(
                "--clock {mhz}: no clock of a whole traversal with {key} = {word} was measured; leave out --clock, and set latency.*"
            )));
        };
        let fits = placed.clone().find(|p| p.mhz >= mhz).ok_or_else(|| {
            Error::input(format!(
                "--clock {mhz} is more than any whole traversal with {key} = {word} reached: at most --clock {best} is legal"
            ))
        })?;
        let latency = fits.profile.latency_for(d);
        return Ok(Choice {
            latency,
            share: 100,
            placed: Some((fits.profile, fits.mhz, fits.entry)),
            timed: Vec::new(),
        });
    };
    let mut latency = tier.profile.map_or(BARE, |p| p.latency(kind));
    latency.divider = d.latency.divider;
    for key in LATENCY_KEYS {
        *field(&mut latency, key) = 0;
    }
    let of = |part: Part| units.iter().filter(move |u| u.part == part).copied().collect::<Vec<Timed>>();
    let timed = of(Part::Traversal);
    for c in curves(&timed, &d.latency) {
        pick(&mut latency, &c, (mhz * 100).div_ceil(tier.share), mhz)?;
    }
    // These follow the same clock, as far as they can.
    for c in curves(&of(Part::Beside), &d.latency) {
        let most = c.points.iter().map(|p| p.mhz).max().unwrap_or_default();
        pick(&mut latency, &c, mhz.min(most), mhz)?;
    }
    Ok(Choice { latency, share: tier.share, placed: None, timed })
}

/// Raises the latency of a curve's unit until it reaches `asked`.
fn pick(latency: &mut LatencyConfig, c: &Curve, asked: u32, mhz: u32) -> Result<()> {
    let best = c.points.iter().map(|p| p.mhz).max().unwrap_or_default();
    let point = c.points.iter().find(|p| p.mhz >= asked).ok_or_else(|| {
        Error::input(format!(
            "--clock {mhz} needs {} at {asked} MHz, and the fastest that was measured is {best} (latency.{})",
            c.of.unit, c.of.key
        ))
    })?;
    let now = field(latency, c.of.key);
    *now = (*now).max(point.clocks);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::TIERS;
    use super::curves::PLACED;
    use std::collections::BTreeSet;

    #[test]
    fn the_tables_are_in_order() {
        let placed: BTreeSet<&str> = PLACED.iter().map(|p| p.kind.word()).collect();
        assert_eq!(placed, BTreeSet::from(["fixed", "published", "watertight"]));
        assert!(TIERS.windows(2).all(|t| t[0].to < t[1].to));
    }
}
