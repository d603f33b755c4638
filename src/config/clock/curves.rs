//! What was measured: clocks of units alone by latency, and of whole traversals by profile.
use super::super::{DatapathConfig, DatapathKind, Divider, LatencyConfig, Profile};
use reliefrtl_base::measured::{Entry, all};
use std::sync::LazyLock;

/// Clocks of one unit.
pub(super) struct Curve {
    pub(super) unit: &'static str,
    /// Its key in the table `latency`.
    pub(super) key: &'static str,
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

/// What all entries of units alone have in common.
fn curve(unit: &'static str, key: &'static str, more: &[&str]) -> Curve {
    let point = |entry: &'static Entry| {
        let clock = entry.clock.as_ref().filter(|_| entry.target == "ecp5" && entry.is_alone(unit, more))?;
        Some(Point { clocks: entry.latency?, mhz: clock.median as u32, entry })
    };
    let mut points: Vec<Point> = all().iter().filter_map(point).collect();
    points.sort_by_key(|p| p.clocks);
    Curve { unit, key, points }
}

/// Every unit of arithmetic and its key in the table `latency`.
pub(super) const UNITS: [(&str, &str); 12] = [
    ("fp_add", "add"),
    ("fp_mul", "mul"),
    ("fp_div", "div"),
    ("fp_lt", "compare"),
    ("fp_from_int", "from_int"),
    ("fp_to_int", "to_int"),
    ("fp_to_fixed", "to_int"),
    ("fp_from_fixed", "from_int"),
    ("fp_recip", "div"),
    ("fp_compare", "compare"),
    ("fp_sqrt", "sqrt"),
    ("fp_add3", "add3"),
];

/// Every unit of arithmetic, at the latencies that were measured.
pub(super) static CURVES: LazyLock<Vec<Curve>> =
    LazyLock::new(|| UNITS.iter().map(|(u, key)| curve(u, key, &[])).collect());

/// `fp_div` by table.
pub(super) static BY_TABLE: LazyLock<Curve> =
    LazyLock::new(|| curve("fp_div", "div", &["--set", "latency.divider=table"]));

/// Units of a watertight traversal whose clock its own depends on.
pub(super) const TRAVERSAL: [&str; 7] =
    ["fp_add", "fp_mul", "fp_div", "fp_lt", "fp_from_int", "fp_to_int", "fp_to_fixed"];

/// Units that no traversal has: emitted beside it only where they are named.
pub(super) const BESIDE: [&str; 2] = ["fp_sqrt", "fp_add3"];

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
    for entry in all().iter().filter(|e| e.unit == "traverse" && e.target == "ecp5") {
        let Some(clock) = &entry.clock else { continue };
        let words = entry.words();
        let ["--unit", "traverse", "--profile", profile, rest @ ..] = words.as_slice() else { continue };
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

/// The curve of a unit, as it is built at these latencies.
pub(super) fn curve_of(name: &str, latency: &LatencyConfig) -> Option<&'static Curve> {
    if name == BY_TABLE.unit && latency.divider == Divider::Table {
        return Some(&BY_TABLE);
    }
    CURVES.iter().find(|c| c.unit == name)
}

/// Keys of the table `latency` that are units of arithmetic.
pub(super) const LATENCY_KEYS: [&str; 8] = ["add", "mul", "div", "compare", "from_int", "to_int", "sqrt", "add3"];

/// The key of the table `latency` of a unit of arithmetic.
pub fn latency_key(unit: &str) -> Option<&'static str> {
    UNITS.iter().find(|u| u.0 == unit).map(|u| u.1)
}

/// The latency of a key of [`UNITS`].
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
