//! Latencies for a clock, from a table of measurements, and what those of a configuration are good for.
//!
//! The clocks are those of units alone on an ECP5 (85k, speed grade 8) at 1/7/16: medians of three seeds, `docs/clocks.md` has the commands. A
//! traversal around them is slower, by the share that those came out at which were placed and routed whole.
use super::{DatapathConfig, DatapathKind, Design, Divider, LatencyConfig, Profile};
use crate::error::{Error, Result};
use crate::format::FloatFormat;

/// Clocks of one unit: latency and MHz, the fewest clocks first.
struct Curve {
    unit: &'static str,
    /// Its key in the table `latency`.
    key: &'static str,
    points: &'static [(u32, u32)],
}

const fn curve(unit: &'static str, key: &'static str, points: &'static [(u32, u32)]) -> Curve {
    Curve { unit, key, points }
}

/// Every unit of arithmetic, at the latencies that were measured.
const CURVES: [Curve; 12] = [
    curve("fp_add", "add", &[(1, 74), (2, 125), (3, 162), (4, 197), (5, 221), (6, 256), (8, 296)]),
    curve("fp_mul", "mul", &[(1, 100), (2, 176), (3, 176), (4, 183), (5, 184), (6, 180)]),
    curve("fp_div", "div", &[(2, 34), (4, 68), (6, 82), (8, 108), (10, 114), (14, 153), (17, 152), (20, 262)]),
    curve("fp_lt", "compare", &[(1, 224), (2, 256)]),
    curve("fp_from_int", "from_int", &[(1, 134), (2, 137), (3, 193), (4, 189), (5, 258)]),
    curve("fp_to_int", "to_int", &[(1, 119), (2, 201), (3, 213), (4, 259), (5, 270)]),
    curve("fp_to_fixed", "to_int", &[(1, 117), (2, 192), (3, 217), (4, 232), (5, 268)]),
    curve("fp_from_fixed", "from_int", &[(1, 74), (2, 109), (3, 145), (4, 146), (5, 187)]),
    curve("fp_recip", "div", &[(2, 35), (3, 49), (4, 54), (6, 83), (8, 109), (12, 154), (20, 195)]),
    curve("fp_compare", "compare", &[(1, 204), (2, 270)]),
    curve("fp_sqrt", "sqrt", &[(2, 41), (3, 58), (4, 60), (6, 91), (8, 110), (12, 162), (20, 270)]),
    curve("fp_add3", "add3", &[(2, 62), (3, 82), (4, 98), (6, 118), (8, 160), (12, 173)]),
];

/// `fp_div` by table.
const BY_TABLE: Curve =
    curve("fp_div", "div", &[(2, 42), (3, 75), (4, 106), (5, 125), (6, 146), (7, 148), (8, 177), (10, 173), (13, 182)]);

/// Units of a watertight traversal whose clock its own depends on.
const TRAVERSAL: [&str; 7] = ["fp_add", "fp_mul", "fp_div", "fp_lt", "fp_from_int", "fp_to_int", "fp_to_fixed"];

/// What stands between the units of a watertight traversal, which needs no table: each step was seen to be needed by the profile that has it.
#[derive(Clone, Copy)]
struct Tier {
    /// The highest clock that it is taken for, in MHz.
    to: u32,
    /// Whose registers stand between the units; without one, [`BARE`].
    profile: Option<Profile>,
    /// Around it a whole traversal runs at this share of the clock of its slowest unit alone or better, in percent.
    share: u32,
}

/// As few registers as work between the units: those of the published pipeline.
const BARE: LatencyConfig = Profile::Published.latency(DatapathKind::Published);

/// Slowest first. The shares are those of choices that were placed and routed whole (`docs/clocks.md`, "Latencies for a clock"), rounded down.
const TIERS: [Tier; 4] = [
    Tier { to: 50, profile: None, share: 60 },
    Tier { to: 80, profile: Some(Profile::Published), share: 80 },
    Tier { to: 105, profile: Some(Profile::Balanced), share: 78 },
    Tier { to: 130, profile: Some(Profile::Fast), share: 88 },
];

/// A whole traversal of the default design, placed and routed.
struct Placed {
    kind: DatapathKind,
    profile: Profile,
    mhz: u32,
    /// Of how many seeds that is, and how far the others are.
    seeds: &'static str,
}

const ONE: &str = "one seed of the placer";

/// Profiles that are taken as they stand (`docs/clocks.md`, "The whole traversal"), each datapath's slowest first.
const PLACED: [Placed; 3] = [
    Placed {
        kind: DatapathKind::Watertight,
        profile: Profile::Fast,
        mhz: 170,
        seeds: "median of 3 seeds, of which the slowest was at 152",
    },
    Placed { kind: DatapathKind::Fixed, profile: Profile::Published, mhz: 85, seeds: ONE },
    Placed { kind: DatapathKind::Published, profile: Profile::Published, mhz: 33, seeds: ONE },
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
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The latencies.
    pub latency: LatencyConfig,
    /// Percent of the slowest unit's clock that is to be expected.
    share: u32,
    /// A profile that was placed and routed as it stands, and its MHz.
    placed: Option<(Profile, u32, &'static str)>,
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
    let tier = (kind == DatapathKind::Watertight).then(|| TIERS.iter().find(|t| mhz <= t.to)).flatten();
    let Some(tier) = tier else {
        let placed = PLACED.iter().filter(|p| p.kind == kind);
        let best = placed.clone().map(|p| p.mhz).max().unwrap_or_default();
        let fits = placed.clone().find(|p| p.mhz >= mhz).ok_or_else(|| {
            Error::input(format!(
                "--clock {mhz} is more than any whole traversal with datapath.kind = {} reached: at most --clock {best} is legal",
                kind.word()
            ))
        })?;
        let latency = fits.profile.latency_for(d);
        return Ok(Choice { latency, share: 100, placed: Some((fits.profile, fits.mhz, fits.seeds)) });
    };
    let mut latency = tier.profile.map_or(BARE, |p| p.latency(kind));
    latency.divider = d.latency.divider;
    for key in LATENCY_KEYS {
        *field(&mut latency, key) = 0;
    }
    for c in TRAVERSAL.iter().filter_map(|name| curve_of(name, &d.latency)) {
        pick(&mut latency, c, (mhz * 100).div_ceil(tier.share), mhz)?;
    }
    // Units that no traversal has are emitted beside it only where they are named: they follow the same clock, as far as they can.
    for c in CURVES.iter().filter(|c| ["fp_sqrt", "fp_add3"].contains(&c.unit)) {
        let most = c.points.iter().map(|p| p.1).max().unwrap_or_default();
        pick(&mut latency, c, mhz.min(most), mhz)?;
    }
    Ok(Choice { latency, share: tier.share, placed: None })
}

/// Raises the latency of a curve's unit until it reaches `asked`.
fn pick(latency: &mut LatencyConfig, c: &Curve, asked: u32, mhz: u32) -> Result<()> {
    let best = c.points.iter().map(|p| p.1).max().unwrap_or_default();
    let (clocks, _) = c.points.iter().find(|p| p.1 >= asked).ok_or_else(|| {
        Error::input(format!(
            "--clock {mhz} needs {} at {asked} MHz, and the fastest that was measured is {best} (latency.{})",
            c.unit, c.key
        ))
    })?;
    let now = field(latency, c.key);
    *now = (*now).max(*clocks);
    Ok(())
}

impl Choice {
    /// One sentence about the latencies that a design ended up with, which `--set` may have changed since: what they were measured at, and what
    /// is not known.
    pub fn certainty(&self, mhz: u32, d: &Design, scope: Scope) -> String {
        const SEEDS: &str = "on an ECP5, speed grade 8, at 1/7/16, median of 3 seeds, single seeds differ by up to 8 %";
        let mut said = match self.placed {
            None if scope == Scope::Traversal && between(self.latency) != between(d.latency) => format!(
                "latencies for {mhz} MHz: registers between the units were changed, and with the change nothing was placed and routed, so nothing is promised"
            ),
            Some((profile, ..)) if self.latency != d.latency => format!(
                "latencies for {mhz} MHz: those of profile {}, and with the changes to them nothing was placed and routed, so nothing is promised",
                profile.word()
            ),
            Some((profile, whole, seeds)) => format!(
                "latencies for {mhz} MHz: those of profile {}, which was placed and routed whole at {whole} MHz on an ECP5, speed grade 8, {seeds}",
                profile.word()
            ),
            None => {
                let names: Vec<&str> = match scope {
                    Scope::Traversal => TRAVERSAL.to_vec(),
                    Scope::Alone(units) => units.iter().map(String::as_str).collect(),
                };
                let alone = |name: &&str| {
                    let c = curve_of(name, &d.latency)?;
                    let clocks = *field(&mut d.latency.clone(), c.key);
                    let reached = c.points.iter().find(|p| p.0 == clocks).map(|p| p.1);
                    Some((c.unit, clocks, reached))
                };
                let all: Vec<_> = names.iter().filter_map(alone).collect();
                match all.iter().min_by_key(|u| u.2) {
                    None => format!("latencies for {mhz} MHz: nothing of this was measured, so nothing is promised"),
                    Some((unit, clocks, None)) => format!(
                        "latencies for {mhz} MHz: {unit} in {} was not measured, so nothing is promised",
                        counted(*clocks)
                    ),
                    Some((unit, clocks, Some(reached))) => {
                        let expected = reached * self.share / 100;
                        let short = if expected < mhz { format!(", which is less than {mhz}") } else { String::new() };
                        match scope {
                            Scope::Alone(_) => format!(
                                "latencies for {mhz} MHz: {unit} in {} alone reached {reached} MHz {SEEDS}{short}",
                                counted(*clocks)
                            ),
                            Scope::Traversal => format!(
                                "latencies for {mhz} MHz: the slowest unit alone, {unit} in {}, reached {reached} MHz {SEEDS}; a whole traversal came out at {} % of that or more, so expect {expected} MHz or more{short}",
                                counted(*clocks),
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
            Scope::Alone(units) => {
                let converts = units.iter().any(|name| name.ends_with("int") || name.ends_with("fixed"));
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

/// Latencies of what is no unit of arithmetic.
fn between(mut l: LatencyConfig) -> LatencyConfig {
    LATENCY_KEYS.iter().for_each(|key| *field(&mut l, key) = 0);
    l
}

fn counted(clocks: u32) -> String {
    if clocks == 1 { "1 clock".into() } else { format!("{clocks} clocks") }
}

/// The curve of a unit, as it is built at these latencies.
fn curve_of(name: &str, latency: &LatencyConfig) -> Option<&'static Curve> {
    if name == BY_TABLE.unit && latency.divider == Divider::Table {
        return Some(&BY_TABLE);
    }
    CURVES.iter().find(|c| c.unit == name)
}

/// Keys of the table `latency` that are units of arithmetic.
const LATENCY_KEYS: [&str; 8] = ["add", "mul", "div", "compare", "from_int", "to_int", "sqrt", "add3"];

/// The key of the table `latency` of a unit of arithmetic.
pub fn latency_key(unit: &str) -> Option<&'static str> {
    CURVES.iter().find(|c| c.unit == unit).map(|c| c.key)
}

/// The latency of a key of [`CURVES`].
fn field<'a>(l: &'a mut LatencyConfig, key: &str) -> &'a mut u32 {
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

#[cfg(test)]
mod tests {
    use super::{BY_TABLE, CURVES, PLACED, Scope, TIERS, for_clock};
    use crate::config::{DatapathKind, Design};

    /// Of units it may: where more registers stand between them, fewer in them reach the same clock.
    #[test]
    fn a_faster_clock_never_takes_fewer_registers_between_the_units() {
        let total = |mhz| {
            let l = for_clock(mhz, &Design::default(), Scope::Traversal).unwrap().latency;
            [l.compare, l.to_int, l.decision, l.node, l.memory, l.handshake]
        };
        for mhz in 2..=PLACED[0].mhz {
            let (slow, fast) = (total(mhz - 1), total(mhz));
            assert!(slow.iter().zip(&fast).all(|(a, b)| a <= b), "{mhz} MHz: {slow:?}, {fast:?}");
        }
    }

    #[test]
    fn the_tables_are_in_order() {
        for c in CURVES.iter().chain([&BY_TABLE]) {
            assert!(c.points.windows(2).all(|p| p[0].0 < p[1].0), "{}", c.unit);
        }
        assert!(TIERS.windows(2).all(|t| t[0].to < t[1].to));
    }

    /// Each choice expects what was asked, until something is changed that it rests on.
    #[test]
    fn a_choice_is_judged_by_what_it_became() {
        for mhz in 1..=130 {
            let mut d = Design::default();
            let choice = for_clock(mhz, &d, Scope::Traversal).unwrap();
            d.latency = choice.latency;
            assert!(!choice.certainty(mhz, &d, Scope::Traversal).contains("less than"), "{mhz}");
            d.latency.add = 1;
            let said = choice.certainty(mhz, &d, Scope::Traversal);
            assert_eq!(said.contains("less than"), 74 * choice.share / 100 < mhz, "{said}");
            assert!(mhz <= 66 || said.contains("fp_add in 1 clock,"), "{said}");
        }
        let mut d = Design::default();
        let choice = for_clock(160, &d, Scope::Traversal).unwrap();
        d.latency = choice.latency;
        assert!(choice.certainty(160, &d, Scope::Traversal).contains("profile fast"));
        d.latency.mul = 0;
        assert!(choice.certainty(160, &d, Scope::Traversal).contains("nothing is promised"));
        d.latency = choice.latency;
        assert!(choice.certainty(160, &d, Scope::Traversal).contains("profile fast"));
        d.datapath.fraction_bits += 1;
        assert!(choice.certainty(160, &d, Scope::Traversal).contains("this design: place it"));
        d.datapath = Design::default().datapath;
        d.mode.bilinear = true;
        assert!(choice.certainty(160, &d, Scope::Traversal).contains("this design: place it"));
    }

    /// A promise is of what was measured, not of a latency near it, nor of other registers between the units.
    #[test]
    fn what_was_not_measured_is_not_promised() {
        let mut d = Design::default();
        let choice = for_clock(120, &d, Scope::Traversal).unwrap();
        (d.latency, d.latency.handshake) = (choice.latency, 0);
        assert!(choice.certainty(120, &d, Scope::Traversal).contains("registers between the units were changed"));
        let unit = ["fp_div".to_string()];
        let choice = for_clock(250, &d, Scope::Alone(&unit)).unwrap();
        (d.latency, d.latency.div) = (choice.latency, 22);
        assert!(choice.certainty(250, &d, Scope::Alone(&unit)).contains("fp_div in 22 clocks was not measured"));
        let unit = ["fp_from_int".to_string()];
        let choice = for_clock(130, &d, Scope::Alone(&unit)).unwrap();
        (d.latency, d.traverse.levels) = (choice.latency, 10);
        assert!(choice.certainty(130, &d, Scope::Alone(&unit)).contains("nor was this format or width"));
    }

    #[test]
    fn a_unit_alone_needs_no_margin() {
        let unit = ["fp_add".to_string()];
        let mut d = Design::default();
        let choice = for_clock(296, &d, Scope::Alone(&unit)).unwrap();
        assert_eq!(choice.latency.add, 8);
        d.latency = choice.latency;
        assert!(choice.certainty(296, &d, Scope::Alone(&unit)).contains("fp_add in 8 clocks alone reached 296 MHz"));
    }

    #[test]
    fn what_nothing_reaches_is_refused() {
        let e = for_clock(400, &Design::default(), Scope::Traversal).unwrap_err().to_string();
        assert!(e.contains("--clock 400") && e.contains("at most --clock 170"), "{e}");
        let mut d = Design::default();
        d.datapath.kind = DatapathKind::Published;
        let e = for_clock(120, &d, Scope::Traversal).unwrap_err().to_string();
        assert!(e.contains("datapath.kind = published"), "{e}");
        let unit = ["fp_add3".to_string()];
        let e = for_clock(300, &d, Scope::Alone(&unit)).unwrap_err().to_string();
        assert!(e.contains("fp_add3 at 300 MHz") && e.contains("173"), "{e}");
    }
}
