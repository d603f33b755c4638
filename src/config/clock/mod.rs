//! Latencies for a clock, from a table of measurements, and what those of a configuration are good for.
//!
//! The clocks are those of units alone on an ECP5 (85k, speed grade 8) at 1/7/16: `data/figures.json`, each with the call that measures it
//! ([`reliefrtl_base::measured`]). A traversal around them is slower: a share of the slowest unit's clock is counted on.
mod curves;
mod provenance;

pub use curves::latency_key;

use super::{Design, LatencyConfig, Profile};
use curves::{BESIDE, CURVES, Curve, LATENCY_KEYS, PLACED, TRAVERSAL, curve_of, field};
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
}

/// The smallest latencies that reach `mhz` with the margin that a whole traversal needs; a unit alone needs none.
///
/// # Errors
/// [`Error::Input`] if nothing that was measured reaches it.
pub fn for_clock(mhz: u32, d: &Design, scope: Scope) -> Result<Choice> {
    let Scope::Alone(units) = scope else { return for_traversal(mhz, d) };
    let mut latency = d.latency;
    for name in units {
        if let Some(c) = curve_of(name, &latency) {
            *field(&mut latency, c.key) = 0;
        }
    }
    for name in units {
        let c = curve_of(name, &latency).ok_or_else(|| {
            Error::input(format!(
                "--clock {mhz}: no clock of {name} was measured; leave out --clock, and set latency.*"
            ))
        })?;
        pick(&mut latency, c, mhz, mhz)?;
    }
    Ok(Choice { latency, share: 100, placed: None })
}

fn for_traversal(mhz: u32, d: &Design) -> Result<Choice> {
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
        return Ok(Choice { latency, share: 100, placed: Some((fits.profile, fits.mhz, fits.entry)) });
    };
    let mut latency = tier.profile.map_or(BARE, |p| p.latency(kind));
    latency.divider = d.latency.divider;
    for key in LATENCY_KEYS {
        *field(&mut latency, key) = 0;
    }
    for c in TRAVERSAL.iter().filter_map(|name| curve_of(name, &d.latency)) {
        pick(&mut latency, c, (mhz * 100).div_ceil(tier.share), mhz)?;
    }
    // These follow the same clock, as far as they can.
    for c in CURVES.iter().filter(|c| BESIDE.contains(&c.unit)) {
        let most = c.points.iter().map(|p| p.mhz).max().unwrap_or_default();
        pick(&mut latency, c, mhz.min(most), mhz)?;
    }
    Ok(Choice { latency, share: tier.share, placed: None })
}

/// Raises the latency of a curve's unit until it reaches `asked`.
fn pick(latency: &mut LatencyConfig, c: &Curve, asked: u32, mhz: u32) -> Result<()> {
    let best = c.points.iter().map(|p| p.mhz).max().unwrap_or_default();
    let point = c.points.iter().find(|p| p.mhz >= asked).ok_or_else(|| {
        Error::input(format!(
            "--clock {mhz} needs {} at {asked} MHz, and the fastest that was measured is {best} (latency.{})",
            c.unit, c.key
        ))
    })?;
    let now = field(latency, c.key);
    *now = (*now).max(point.clocks);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::curves::{BY_TABLE, CURVES, PLACED, UNITS};
    use super::{Scope, TIERS, for_clock};
    use crate::{DatapathConfig, Design};
    use std::collections::BTreeSet;

    /// The fastest watertight traversal.
    fn best() -> u32 {
        PLACED.iter().filter(|p| p.kind == DatapathConfig::default().kind).map(|p| p.mhz).max().unwrap()
    }

    /// What a unit reaches at a latency.
    fn of(unit: &str, clocks: u32) -> u32 {
        let curve = CURVES.iter().find(|c| c.unit == unit).unwrap();
        curve.points.iter().find(|p| p.clocks == clocks).unwrap().mhz
    }

    /// Of units it may: where more registers stand between them, fewer in them reach the same clock.
    #[test]
    fn a_faster_clock_never_takes_fewer_registers_between_the_units() {
        let total = |mhz| {
            let l = for_clock(mhz, &Design::default(), Scope::Traversal).unwrap().latency;
            [l.compare, l.to_int, l.decision, l.node, l.memory, l.handshake]
        };
        for mhz in 2..=best() {
            let (slow, fast) = (total(mhz - 1), total(mhz));
            assert!(slow.iter().zip(&fast).all(|(a, b)| a <= b), "{mhz} MHz: {slow:?}, {fast:?}");
        }
    }

    #[test]
    fn the_tables_are_in_order() {
        assert_eq!(CURVES.len(), UNITS.len());
        for c in CURVES.iter().chain([&*BY_TABLE]) {
            assert!(c.points.len() > 1, "{} was not measured", c.unit);
            assert!(c.points.windows(2).all(|p| p[0].clocks < p[1].clocks), "{}: one latency twice", c.unit);
        }
        let placed: BTreeSet<&str> = PLACED.iter().map(|p| p.kind.word()).collect();
        assert_eq!(placed, BTreeSet::from(["fixed", "published", "watertight"]));
        assert!(TIERS.windows(2).all(|t| t[0].to < t[1].to));
    }

    /// Each choice expects what was asked, until something is changed that it rests on.
    #[test]
    fn a_choice_is_judged_by_what_it_became() {
        for mhz in 1..=130 {
            let mut d = Design::default();
            let choice = for_clock(mhz, &d, Scope::Traversal).unwrap();
            d.latency = choice.latency;
            assert!(!choice.provenance(mhz, &d, Scope::Traversal).contains("less than"), "{mhz}");
            d.latency.add = 1;
            let said = choice.provenance(mhz, &d, Scope::Traversal);
            let counted = of("fp_add", 1) * choice.share / 100;
            assert_eq!(said.contains("less than"), counted < mhz, "{said}");
            assert!(counted >= mhz || said.contains("fp_add in 1 clock,"), "{said}");
        }
        let mut d = Design::default();
        let choice = for_clock(160, &d, Scope::Traversal).unwrap();
        d.latency = choice.latency;
        assert!(choice.provenance(160, &d, Scope::Traversal).contains("profile fast"));
        d.latency.mul = 0;
        assert!(choice.provenance(160, &d, Scope::Traversal).contains("nothing is promised"));
        d.latency = choice.latency;
        assert!(choice.provenance(160, &d, Scope::Traversal).contains("profile fast"));
        d.datapath.fraction_bits += 1;
        assert!(choice.provenance(160, &d, Scope::Traversal).contains("this design: place it"));
        d.datapath = Design::default().datapath;
        d.mode.bilinear = true;
        assert!(choice.provenance(160, &d, Scope::Traversal).contains("this design: place it"));
    }

    /// A promise is of what was measured, not of a latency near it, nor of other registers between the units.
    #[test]
    fn what_was_not_measured_is_not_promised() {
        let mut d = Design::default();
        let choice = for_clock(120, &d, Scope::Traversal).unwrap();
        (d.latency, d.latency.handshake) = (choice.latency, 0);
        assert!(choice.provenance(120, &d, Scope::Traversal).contains("registers between the units were changed"));
        let unit = ["fp_div".to_string()];
        let mhz = of("fp_div", 20);
        let choice = for_clock(mhz, &d, Scope::Alone(&unit)).unwrap();
        (d.latency, d.latency.div) = (choice.latency, 22);
        assert!(choice.provenance(mhz, &d, Scope::Alone(&unit)).contains("fp_div in 22 clocks was not measured"));
        let unit = ["fp_from_int".to_string()];
        let choice = for_clock(130, &d, Scope::Alone(&unit)).unwrap();
        (d.latency, d.traverse.levels) = (choice.latency, 10);
        assert!(choice.provenance(130, &d, Scope::Alone(&unit)).contains("nor was this format or width"));
    }

    #[test]
    fn a_unit_alone_needs_no_margin() {
        let unit = ["fp_add".to_string()];
        let mut d = Design::default();
        let mhz = of("fp_add", 8);
        let choice = for_clock(mhz, &d, Scope::Alone(&unit)).unwrap();
        d.latency = choice.latency;
        let said = choice.provenance(mhz, &d, Scope::Alone(&unit));
        assert_eq!(choice.latency.add, 8, "{said}");
        assert!(said.contains(&format!("fp_add in 8 clocks alone reached {mhz} MHz")), "{said}");
    }

    #[test]
    fn what_nothing_reaches_is_refused() {
        let e = for_clock(400, &Design::default(), Scope::Traversal).unwrap_err().to_string();
        assert!(e.contains("--clock 400") && e.contains(&format!("at most --clock {}", best())), "{e}");
        let mut d = Design::default();
        d.datapath.kind = "published".parse().unwrap();
        let e = for_clock(120, &d, Scope::Traversal).unwrap_err().to_string();
        assert!(e.contains("datapath.kind = published"), "{e}");
        let unit = ["fp_add3".to_string()];
        let e = for_clock(300, &d, Scope::Alone(&unit)).unwrap_err().to_string();
        assert!(e.contains("fp_add3 at 300 MHz") && e.contains(&of("fp_add3", 12).to_string()), "{e}");
    }
}
