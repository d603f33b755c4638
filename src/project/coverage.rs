//! What the shipped vectors of a tree reach in its Verilog, and what they don't, with the reasons of `src/units/unreached.toml`.
use super::check::FURTHER;
use crate::bench::{Further, Point, PointKind, cover};
use crate::catalogue::{takes_rays, units};
use crate::config::Config;
use crate::error::{Error, Result};
use crate::ir::Module;
use crate::units::all;
use crate::vectors::read_set;
use crate::verilog::delayed_bit;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

/// Points of one file that are reached, and all of them.
#[derive(Clone, Debug, Default)]
pub struct FileCoverage {
    /// Branches reached, and all.
    pub branches: [usize; 2],
    /// Bits that change, and all.
    pub toggles: [usize; 2],
    /// Points not reached for which there is a reason.
    pub reasons: usize,
}

/// What came out.
#[derive(Clone, Debug, Default)]
pub struct Coverage {
    /// Files by the bare name of their module.
    pub files: BTreeMap<String, FileCoverage>,
    /// Points that are not reached, and no reason is listed.
    pub unlisted: Vec<String>,
    /// Entries of the list that name points which are reached, or no point.
    pub stale: Vec<String>,
    /// The list is that of this configuration: it has to be exact.
    pub exact: bool,
}

/// Why points are not reached.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    unreached: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    unit: String,
    points: Vec<String>,
    reason: String,
}

/// Counts branches and toggles of the tree at `dir` in Verilator.
///
/// # Errors
/// As [`cover`]; a vector set that can't be read.
pub fn coverage(c: &Config, dir: &Path) -> Result<Coverage> {
    if !c.vectors.planned {
        return Err(Error::input("coverage is that of the planned rays: it needs vectors.planned = true"));
    }
    let d = c.design();
    let names: Vec<String> = units(&d).iter().map(|m| m.name.clone()).collect();
    let modules: BTreeMap<String, Arc<Module>> = all(&d).into_iter().map(|m| (m.name.clone(), m)).collect();
    let whole = modules.values().find(|m| takes_rays(m)).expect("the vectors of one unit are rays");
    let further = |name: &&str| -> Result<Further> {
        let place = format!("golden/{}/{name}", whole.name);
        let mut over = read_set(&dir.join(&place))?.0.params;
        over.retain(|k, v| whole.params.iter().any(|p| p.name == *k && p.default != *v));
        Ok(Further { place, over })
    };
    let further = FURTHER.iter().map(further).collect::<Result<Vec<_>>>()?;
    let points = cover(dir, &names, &whole.name, &further)?;
    let points = points.into_iter().map(|(p, count)| (by_value(p, &modules), count)).collect();
    Ok(judged(&points, *c == Config::default()))
}

/// A bit of a shift register that delays several values, by the value that it belongs to.
fn by_value(mut p: Point, modules: &BTreeMap<String, Arc<Module>>) -> Point {
    let bit =
        p.name.strip_suffix(']').and_then(|n| n.rsplit_once('[')).and_then(|(net, bit)| Some((net, bit.parse().ok()?)));
    let value = bit.and_then(|(net, bit)| delayed_bit(modules.get(&p.unit)?, net, bit));
    p.name = value.unwrap_or(p.name);
    p
}

/// Sorts points by file, and holds those that are not reached against the list.
fn judged(points: &BTreeMap<Point, u64>, exact: bool) -> Coverage {
    let list: List = toml::from_str(include_str!("../units/unreached.toml")).expect("the list is well formed");
    let mut out = Coverage { exact, ..Coverage::default() };
    let mut used = vec![(0, 0); list.unreached.iter().map(|e| e.points.len()).sum()];
    for (p, count) in points {
        let file = out.files.entry(p.unit.clone()).or_default();
        let of = if p.kind == PointKind::Branch { &mut file.branches } else { &mut file.toggles };
        of[1] += 1;
        of[0] += usize::from(*count > 0);
        let patterns = list.unreached.iter().flat_map(|e| e.points.iter().map(move |x| (e, x))).enumerate();
        let mut listed = false;
        for (k, _) in patterns.filter(|(_, (e, x))| e.unit == p.unit && matches(x, &p.name)) {
            listed = true;
            let (reached, missed) = &mut used[k];
            if *count > 0 { *reached += 1 } else { *missed += 1 }
        }
        match (*count > 0, listed) {
            (false, true) => file.reasons += 1,
            (false, false) => out.unlisted.push(match p.kind {
                PointKind::Branch => format!("{}: branch {:?} of line {}", p.unit, p.name, p.line),
                PointKind::Toggle => format!("{}: {}", p.unit, p.name),
            }),
            (true, _) => {}
        }
    }
    let entries = list.unreached.iter().flat_map(|e| e.points.iter().map(move |x| (e, x)));
    for ((e, x), (reached, missed)) in entries.zip(used) {
        if reached > 0 {
            out.stale.push(format!("{}: {x} names {reached} points that are reached", e.unit));
        } else if missed == 0 {
            out.stale.push(format!("{}: {x} names no point", e.unit));
        }
        assert!(!e.reason.is_empty(), "{}: no reason", e.unit);
    }
    out
}

/// Whether a point is one of a pattern's: `*` stands for any part of a name, `[3]` and `[3..7]` for bits.
fn matches(pattern: &str, name: &str) -> bool {
    let split = |s: &str| -> (String, Option<String>) {
        match s.strip_suffix(']').and_then(|s| s.rsplit_once('[')) {
            Some((name, bits)) => (name.to_string(), Some(bits.to_string())),
            None => (s.to_string(), None),
        }
    };
    let ((want, bits), (have, bit)) = (split(pattern), split(name));
    let within = match (bits, bit.and_then(|b| b.parse::<u32>().ok())) {
        (None, None) => true,
        (Some(bits), Some(bit)) => {
            let (low, high) = bits.split_once("..").unwrap_or((&bits, &bits));
            let number = |s: &str| s.parse::<u32>().ok();
            number(low).zip(number(high)).is_some_and(|(l, h)| (l..=h).contains(&bit))
        }
        _ => false,
    };
    within && glob(&want, &have)
}

fn glob(want: &str, have: &str) -> bool {
    match want.split_once('*') {
        None => want == have,
        Some((first, rest)) => have
            .strip_prefix(first)
            .is_some_and(|have| (0..=have.len()).any(|k| have.is_char_boundary(k) && glob(rest, &have[k..]))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_name_what_they_say() {
        for (pattern, name) in
            [("a", "a"), ("a[3]", "a[3]"), ("s*_ups[5..15]", "s18_ups[5]"), ("*_x[0]", "s0_loop_x[0]")]
        {
            assert!(matches(pattern, name), "{pattern} {name}");
        }
        for (pattern, name) in
            [("a", "ab"), ("a", "a[0]"), ("a[3]", "a"), ("s*_ups[5..15]", "s1_ups[16]"), ("*_x", "x")]
        {
            assert!(!matches(pattern, name), "{pattern} {name}");
        }
    }

    #[test]
    fn a_list_is_held_against_what_was_reached() {
        let point = |name: &str| Point { unit: "none".into(), kind: PointKind::Toggle, name: name.into(), line: 0 };
        let found = judged(&BTreeMap::from([(point("a"), 0), (point("b"), 3)]), true);
        assert_eq!(found.unlisted, ["none: a"]);
        assert_eq!(found.files["none"].toggles, [1, 2]);
        // None of the listed points is there.
        assert!(!found.stale.is_empty());
    }
}
