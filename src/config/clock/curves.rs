//! What was measured: clocks of units alone by latency, and of whole traversals by profile.
use super::super::{DatapathConfig, DatapathKind, Divider, LatencyConfig, Profile};
use reliefrtl_base::measured::{Entry, all};
use std::sync::LazyLock;

/// What the clock of a unit of arithmetic counts for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A watertight traversal, whose clock depends on this one.
    Traversal,
    /// No traversal has it, but it is emitted beside one and follows the same clock.
    Beside,
    /// Itself.
    Alone,
}

/// A unit of arithmetic, as the table of units has it: which latency is its own, and what depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timed {
    /// Its name, under which it was measured.
    pub unit: &'static str,
    /// Its key in the table `latency`.
    pub key: &'static str,
    /// What its clock counts for.
    pub part: Part,
}

/// Clocks of one unit.
pub(super) struct Curve {
    pub(super) of: Timed,
    /// The fewest clocks first.
    pub(super) points: Vec<Point>,
}

/// A unit as it was measured at one latency.
#[derive(Clone, Copy)]
pub(super) struct Point {
    pub(super) clocks: u32,
    /// Whole MHz, rounded down.
    pub(super) mhz: u32,
    pub(super) entry: &'static Entry,
}

/// What all entries of a unit alone have in common.
fn curve(of: Timed, more: &[&str]) -> Curve {
    let point = |entry: &'static Entry| {
        let clock = entry.clock.as_ref().filter(|_| entry.target == "ecp5" && entry.is_alone(of.unit, more))?;
        Some(Point { clocks: entry.latency?, mhz: clock.median as u32, entry })
    };
    let mut points: Vec<Point> = all().iter().filter_map(point).collect();
    points.sort_by_key(|p| p.clocks);
    Curve { of, points }
}

/// The curve of each of these units, as it is built at these latencies.
pub(super) fn curves(units: &[Timed], latency: &LatencyConfig) -> Vec<Curve> {
    let table = Divider::Table;
    let one = |of: &Timed| {
        // One divider was measured by table, too; what has no such figures is built in rows.
        let set = format!("latency.divider={}", table.word());
        let by_table = (of.key == "div" && latency.divider == table).then(|| curve(*of, &["--set", &set]));
        by_table.filter(|c| !c.points.is_empty()).unwrap_or_else(|| curve(*of, &[]))
    };
    units.iter().map(one).collect()
}

/// A whole traversal of the default design, placed and routed at a profile's latencies.
pub(super) struct Placed {
    pub(super) kind: DatapathKind,
    pub(super) profile: Profile,
    pub(super) mhz: u32,
    pub(super) entry: &'static Entry,
}

/// Profiles that were placed as they stand (`docs/clocks.md`, "The whole traversal"), slowest first.
pub(super) static PLACED: LazyLock<Vec<Placed>> = LazyLock::new(|| {
    let mut placed = Vec::new();
    for entry in all().iter().filter(|e| e.target == "ecp5") {
        let Some(clock) = &entry.clock else { continue };
        let words = entry.words();
        // Units of arithmetic are measured at latencies of their own: a profile is asked of a whole traversal alone.
        let ["--unit", _, "--profile", profile, rest @ ..] = words.as_slice() else { continue };
        let Some(profile) = Profile::ALL.into_iter().find(|p| p.word() == *profile) else { continue };
        // Where the call says nothing of it, it is the usual one.
        let named = match rest {
            ["--set", set, rest @ ..] => set.strip_prefix("datapath.kind=").and_then(|w| Some((w.parse().ok()?, rest))),
            _ => None,
        };
        let (kind, rest) = named.unwrap_or((DatapathConfig::default().kind, rest));
        if !rest.iter().any(|w| ["--set", "--copies", "--clock"].contains(w)) {
            placed.push(Placed { kind, profile, mhz: clock.median as u32, entry });
        }
    }
    placed.sort_by_key(|p| p.mhz);
    placed
});

/// Keys of the table `latency` that are units of arithmetic.
pub(super) const LATENCY_KEYS: [&str; 8] = ["add", "mul", "div", "compare", "from_int", "to_int", "sqrt", "add3"];

/// The latency of one of [`LATENCY_KEYS`].
pub(super) fn field<'a>(l: &'a mut LatencyConfig, key: &str) -> &'a mut u32 {
    match key {
        "add" => &mut l.add,
        "mul" => &mut l.mul,
        "div" => &mut l.div,
        "compare" => &mut l.compare,
        "from_int" => &mut l.from_int,
        "to_int" => &mut l.to_int,
        "sqrt" => &mut l.sqrt,
        "add3" => &mut l.add3,
        _ => unreachable!("no curve has the key {key}"),
    }
}
