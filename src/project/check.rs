//! Checks an emitted tree: every unit's vectors replayed by an engine.
use super::same::{same_config, same_rows, same_text};
use crate::catalogue::{check_interp, compare, design_at, fits, takes_rays, units, without_vectors};
use crate::config::{Config, Design};
use crate::emit::Files;
use crate::engine::stored::{memory, pyramid_of, ray_of};
use crate::engine::{Checked, Engine, EngineName, Replay};
use crate::error::{Error, Result};
use crate::files::Sink;
use crate::interp::{Traffic, Wave, WaveFormat, elaborate};
use crate::ir::{Binding, Module};
use crate::trace::{Pipeline, images, record_mismatch, record_ray, record_rows};
use crate::units::traversal::traverse;
use crate::vectors::{VectorSet, read_set};
use rayon::prelude::*;
use std::path::Path;
use std::sync::Arc;

/// A fault put into the vectors, to see the check fail.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Canary {
    /// One bit of one expected word is flipped: exit code 1.
    Flip,
    /// One input never enters, so its result never comes: exit code 6.
    Drop,
    /// One input enters twice, so a result comes that is not expected: exit code 7.
    Extra,
    /// No vectors at all: exit code 5.
    Empty,
}

impl Canary {
    /// All, in the order of the help.
    pub const ALL: [Self; 4] = [Self::Flip, Self::Drop, Self::Extra, Self::Empty];

    /// Puts the fault into a set.
    pub fn spoil(self, s: &mut VectorSet) {
        if s.stimulus.is_empty() || s.expected.is_empty() {
            return;
        }
        let middle = s.expected.len().min(s.stimulus.len()) / 2;
        match self {
            Self::Flip => s.expected[middle][0] ^= 1,
            Self::Drop => drop(s.stimulus.pop()),
            Self::Extra => s.stimulus.push(s.stimulus[middle].clone()),
            Self::Empty => {
                s.stimulus.clear();
                s.expected.clear();
            }
        }
    }
}

/// Checks the tree at `dir` (as `build` writes it): all units, or `only` those.
/// `wave` is where the clocks around the first mismatch are recorded. `seen` is called after each unit.
///
/// # Errors
/// The first unit that fails, by order of the units.
pub fn check_tree(
    c: &Config,
    dir: &Path,
    engine: EngineName,
    only: &[String],
    canary: Option<Canary>,
    wave: Option<&(Sink, WaveFormat)>,
    seen: &(dyn Fn(&Checked) + Sync),
) -> Result<Vec<Checked>> {
    check_tree_at(c, dir, engine, only, &Binding::new(), canary, wave, seen)
}

/// As [`check_tree`], of vectors that were made for the parameter values `over`.
///
/// # Errors
/// As [`check_tree`].
#[allow(clippy::too_many_arguments)]
pub fn check_tree_at(
    c: &Config,
    dir: &Path,
    engine: EngineName,
    only: &[String],
    over: &Binding,
    canary: Option<Canary>,
    wave: Option<&(Sink, WaveFormat)>,
    seen: &(dyn Fn(&Checked) + Sync),
) -> Result<Vec<Checked>> {
    let engine = engine.engine();
    let mut c = c.clone();
    // Names and directives in a tree are the tree's own; what it computes is the configuration's.
    if let Some(e) = crate::emit::manifest_emit(dir) {
        (c.emit.prefix, c.emit.timescale, c.emit.default_nettype) = (e.prefix, e.timescale, e.default_nettype);
    }
    let c = &c;
    let d = c.design();
    let alone: Option<Vec<_>> = only.iter().map(|name| super::alone(c, name)).collect();
    let list = match alone.filter(|units| !units.is_empty()) {
        Some(units) => units,
        None => {
            let mut list = units(&d);
            list.push(traverse(&d).module);
            let names = only.iter().map(|name| Ok(crate::catalogue::find(&d, name)?.name.clone()));
            let names = names.collect::<Result<Vec<_>>>()?;
            list.retain(|x| names.is_empty() || names.contains(&x.name));
            list
        }
    };
    if list.is_empty() {
        return Err(Error::NothingRan(format!("nothing was checked: {}", without_vectors(&d, only))));
    }
    same_config(c, dir)?;
    if !engine.reads_text() {
        let whole = list.iter().any(|m| takes_rays(m));
        let text = if whole { super::hardware(c)?.files } else { text_of(c, &list)? };
        same_text(&text, dir)?;
    }
    let further = if c.vectors.planned { &FURTHER[..] } else { &[] };
    let one = |m: &Arc<Module>| {
        let r = vouched(dir, m, canary, unit(&d, dir, m, further, over, engine, canary));
        if let Ok(c) = &r {
            seen(c);
        }
        r
    };
    let all: Vec<Result<Checked>> = list.par_iter().map(one).collect();
    let failed = all.iter().position(|r| matches!(r, Err(Error::Mismatch(_))));
    let recorded = failed.map(|k| &list[k]).zip(wave).map_or(Ok(()), |(m, (sink, format))| {
        mismatch_wave(&design_at(&d, over), dir, m, canary)?.write(sink, *format, &m.name)
    });
    match (all.into_iter().collect(), recorded) {
        // A waveform that can't be written takes nothing from the verdict.
        (Err(Error::Mismatch(found)), Err(e)) => Err(Error::Mismatch(found.and(e))),
        (verdict, _) => verdict,
    }
}

/// A unit's result, with what is not as it was generated in the directory of its vectors: an engine tells of a mismatch first.
fn vouched(dir: &Path, m: &Module, canary: Option<Canary>, result: Result<Checked>) -> Result<Checked> {
    let place = dir.join("golden").join(&m.name);
    let (false, Ok(_) | Err(Error::Mismatch(_))) = (canary.is_some(), &result) else { return result };
    let altered = super::digests::altered(&place)?.join("; ");
    match result {
        _ if altered.is_empty() => result,
        Err(Error::Mismatch(found)) => Err(Error::Mismatch(found.and(altered))),
        Ok(_) => Err(Error::input(format!("{}: every row agrees, but {altered}: emit the vectors anew", m.name))),
        other => other,
    }
}

/// The Verilog of some units and what they are made of.
fn text_of(c: &Config, units: &[Arc<Module>]) -> Result<Files> {
    Ok(crate::emit::rtl(c, &crate::emit::modules(units)?))
}

/// Clocks around the first mismatch of a unit, from power-up.
fn mismatch_wave(d: &Design, dir: &Path, m: &Arc<Module>, canary: Option<Canary>) -> Result<Wave> {
    const MARGIN: usize = 8;
    let place = dir.join("golden").join(&m.name);
    let mut set = read_set(&place)?.0;
    if let Some(canary) = canary {
        canary.spoil(&mut set);
    }
    let nothing = || Error::NothingRan(format!("{}: the mismatch did not come again", m.name));
    if !takes_rays(m) {
        let first = check_interp(m, &set)?.first.ok_or_else(nothing)?;
        let net = elaborate(m, &set.params)?;
        let ports: Vec<&str> = set.inputs.iter().map(|c| c.name.as_str()).collect();
        return Ok(record_rows(&net, m.latency(), &ports, &set.stimulus, first.vector, MARGIN));
    }
    let (p, image) = (Pipeline::new(d, &Binding::new())?, memory(&place)?);
    let stream = p.stream();
    let run = stream.run(&set.stimulus, &images(&p.net, &image), 1, Traffic::default())?;
    let first = compare(&set, "interp", &run.results)?.first.ok_or_else(nothing)?;
    let ray = ray_of(&set.stimulus[first.vector]);
    let pyramid = pyramid_of(d, &image)?;
    match record_mismatch(d, &pyramid, &ray, MARGIN, MARGIN)? {
        Some((_, wave)) => Ok(wave),
        // The pipeline is right and the expected row is not: the clocks in which the hit comes out.
        None => Ok(record_ray(&p, d, &pyramid, &ray, Wave::new(&p.net).window(MARGIN), None)?.1),
    }
}

/// Directories of `traverse`'s further sets, below that of its first: step limits that rays reach.
pub(super) const FURTHER: [&str; 2] = ["limit", "limit_1"];

fn unit(
    d: &Design,
    dir: &Path,
    m: &Arc<Module>,
    further: &[&str],
    given: &Binding,
    engine: &dyn Engine,
    canary: Option<Canary>,
) -> Result<Checked> {
    let place = dir.join("golden").join(&m.name);
    let mut checked = one_set(d, dir, m, &place, (given, &[]), engine, canary)?;
    if takes_rays(m) && canary.is_none() && given.is_empty() {
        for name in further {
            let place = dir.join("golden").join(&m.name).join(name);
            checked.rows += one_set(d, dir, m, &place, (given, &["LEVELS", "STEP_LIMIT"]), engine, None)?.rows;
        }
    }
    Ok(checked)
}

/// One vector set of a unit at the parameter values `given`, of which the parameters `own` may have values of their own.
fn one_set(
    d: &Design,
    dir: &Path,
    m: &Arc<Module>,
    place: &Path,
    (given, own): (&Binding, &[&str]),
    engine: &dyn Engine,
    canary: Option<Canary>,
) -> Result<Checked> {
    let (mut set, whole) = read_set(place)?;
    let mut over = set.params.clone();
    over.retain(|name, _| own.contains(&name.as_str()) || given.contains_key(name));
    let others = given.iter().any(|(name, value)| over.get(name) != Some(value));
    if others || set.params != m.binding_with(&over) || !m.failed_checks(&set.params).is_empty() {
        return Err(Error::input(format!(
            "{}: the vectors were made for other parameter values than the configuration, or --param, has",
            place.display()
        )));
    }
    // What an engine says about a spoiled row tells more than that two files differ.
    let exports = same_rows(place, &set);
    fits(m, &set).map_err(|e| Error::input(format!("{}: {e}", place.display())))?;
    if let Some(canary) = canary {
        canary.spoil(&mut set);
    }
    let (unit, over, spoiled) = (&**m, &over, canary.is_some());
    let replay = Replay { design: d, tree: dir, unit, place, over, set: &set, spoiled };
    let edited = (!whole && canary.is_none())
        .then(|| format!("{} does not hold the rows that vectors.json describes (blake3 differs)", place.display()));
    let checked = engine.replay(&replay).map_err(|e| match (e, &edited) {
        (Error::Mismatch(found), Some(edited)) => {
            let why = format!("{edited}, so it is the vectors that were changed, if the unit was not");
            Error::Mismatch(found.and(why))
        }
        (e, _) => e,
    })?;
    exports?;
    if let Some(edited) = edited {
        return Err(Error::input(edited));
    }
    Ok(checked)
}
