//! Latencies for a clock, from a table of measurements.
//!
//! The clocks are those of units alone on an ECP5 (85k, speed grade 8) at 1/7/16: medians of three seeds, `docs/clocks.md` has the commands. A
//! traversal around them is slower, by the share that the profiles came out at when they were placed and routed whole.
use super::{DatapathKind, Divider, LatencyConfig, Profile};
use crate::error::{Error, Result};

/// Clocks of one kind of unit: latency and MHz, the slowest first.
struct Curve {
    key: &'static str,
    points: &'static [(u32, u32)],
    set: fn(&mut LatencyConfig, u32),
}

/// Every kind of unit; of two that share a key, the slower one.
const CURVES: [Curve; 8] = [
    Curve { key: "add", points: &[(1, 74), (2, 125), (3, 162), (4, 195), (5, 236), (6, 256)], set: |l, n| l.add = n },
    Curve { key: "mul", points: &[(1, 100), (2, 176), (3, 177)], set: |l, n| l.mul = n },
    Curve {
        key: "div",
        points: &[(2, 34), (4, 54), (6, 82), (8, 108), (10, 114), (14, 152), (20, 195)],
        set: |l, n| l.div = n,
    },
    Curve { key: "compare", points: &[(1, 204), (2, 256)], set: |l, n| l.compare = n },
    Curve { key: "from_int", points: &[(1, 134), (2, 137), (3, 193), (5, 258)], set: |l, n| l.from_int = n },
    Curve { key: "to_int", points: &[(1, 117), (2, 192), (3, 213), (4, 232), (5, 268)], set: |l, n| l.to_int = n },
    Curve { key: "sqrt", points: &[(2, 41), (4, 60), (6, 91), (8, 110), (12, 162), (20, 270)], set: |l, n| l.sqrt = n },
    Curve { key: "add3", points: &[(2, 62), (3, 82), (4, 98), (6, 118), (8, 160), (12, 173)], set: |l, n| l.add3 = n },
];

/// A whole traversal runs at this share of the clock of its slowest unit alone or better, in percent: of those that were placed and routed, the
/// lowest came out at 63 % (a former `fast`), `published` at 89 %, `fast` at 96 % (`docs/clocks.md`, "The whole traversal").
const WHOLE: u32 = 63;

/// Latencies chosen for a clock, and how sure the choice is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The latencies.
    pub latency: LatencyConfig,
    /// Key of the unit with the lowest clock, and its MHz alone.
    pub slowest: (&'static str, u32),
    /// MHz that each unit alone had to reach.
    pub asked: u32,
}

impl Choice {
    /// One sentence: what was chosen, from what, and what it does not know.
    pub fn certainty(&self, mhz: u32) -> String {
        let (key, alone) = self.slowest;
        format!(
            "latencies for {mhz} MHz: every unit alone reached {} MHz or more (the slowest: {key}, {alone}) on an ECP5, speed grade 8, at 1/7/16, median of 3 seeds, single seeds differ by up to 8 %; whole traversals came out at {WHOLE} to 96 % of that, so expect {} MHz or more; other devices and formats were not measured",
            self.asked,
            alone * WHOLE / 100
        )
    }
}

/// The smallest latencies whose units alone reach `mhz` with the margin that a whole traversal needs.
///
/// # Errors
/// [`Error::Input`] if a unit does not reach it at any latency that was measured.
pub fn for_clock(mhz: u32, kind: DatapathKind) -> Result<Choice> {
    let asked = (mhz * 100).div_ceil(WHOLE);
    // What stands between the units needs no table: each step was seen to be needed by the profile that has it.
    let profile = match mhz {
        0..=50 => None,
        51..=80 => Some(Profile::Published),
        81..=90 => Some(Profile::Balanced),
        _ => Some(Profile::Fast),
    };
    let mut latency = profile.map_or(LatencyConfig::default(), |p| p.latency(kind));
    latency.divider = Divider::Rows;
    let mut slowest = ("", u32::MAX);
    for c in &CURVES {
        let Some((clocks, alone)) = c.points.iter().find(|p| p.1 >= asked) else {
            let best = c.points.iter().map(|p| p.1).max().unwrap_or_default();
            return Err(Error::input(format!(
                "--clock {mhz} needs latency.{} at {asked} MHz alone, and the fastest that was measured is {best}: at most --clock {} is legal",
                c.key,
                fastest()
            )));
        };
        (c.set)(&mut latency, *clocks);
        if *alone < slowest.1 {
            slowest = (c.key, *alone);
        }
    }
    Ok(Choice { latency, slowest, asked })
}

/// The highest clock that every unit reaches at some latency.
fn fastest() -> u32 {
    let best = CURVES.iter().filter_map(|c| c.points.iter().map(|p| p.1).max()).min();
    best.unwrap_or_default() * WHOLE / 100
}

#[cfg(test)]
mod tests {
    use super::{CURVES, fastest, for_clock};
    use crate::config::DatapathKind;

    #[test]
    fn a_faster_clock_never_takes_fewer_clocks() {
        let total = |mhz| {
            let l = for_clock(mhz, DatapathKind::Watertight).unwrap().latency;
            [l.add, l.mul, l.div, l.compare, l.from_int, l.to_int, l.sqrt, l.add3, l.decision, l.node, l.memory]
        };
        for mhz in 2..=fastest() {
            let (slow, fast) = (total(mhz - 1), total(mhz));
            assert!(slow.iter().zip(&fast).all(|(a, b)| a <= b), "{mhz} MHz: {slow:?}, {fast:?}");
        }
    }

    #[test]
    fn the_table_is_in_order() {
        for c in &CURVES {
            assert!(c.points.windows(2).all(|p| p[0].0 < p[1].0 && p[0].1 <= p[1].1), "{}", c.key);
        }
    }

    #[test]
    fn what_no_unit_reaches_is_refused() {
        let e = for_clock(400, DatapathKind::Watertight).unwrap_err().to_string();
        assert!(e.contains("--clock 400") && e.contains(&format!("at most --clock {}", fastest())), "{e}");
    }
}
