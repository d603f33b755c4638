//! One entry a unit ([`UNITS`]): its model, legal operands, stimulus, bindings, proofs. Here alone hardware and golden model meet.
mod bindings;
mod check;
mod clocked;
mod datapath;
mod entries;
mod events;
mod found;
mod limits;
mod modelled;
mod ray_plan;
mod ray_stimulus;
mod rays;
mod row;
mod table;
mod unit;

pub use bindings::bindings;
pub use check::{CheckReport, Mismatch, check_interp, check_netlist, compare, decoded, fits};
pub use clocked::{Clocked, Step};
pub use events::count_events;
pub use limits::limit_sets;
pub use modelled::Modelled;
pub use ray_plan::planned_rays;
pub use ray_stimulus::RaySample;
pub use rays::{RaySet, ray_columns, ray_set, ray_set_at};
pub use row::{Context, Row};
pub use table::{UNITS, entry, proofs, timed, unit_entries};
pub use unit::{Counted, Legal, Model, Stimulus, Unit};

use crate::alike::nearest;
use crate::config::{Config, Design, searches};
use crate::error::{Error, Result};
use crate::ir::{Binding, Module, Port};
use crate::units;
use crate::vectors::{Campaign, Column, Counts, Kind, Plan, VectorSet, campaign_rows, plan_rows};
use found::found_rows;
use ray_stimulus::sample_rows;
use std::sync::Arc;

/// The units that have rows of their own, leaves first: those whose entry has a model.
pub fn units(d: &Design) -> Vec<Arc<Module>> {
    units::all(d).into_iter().filter(|m| !takes_rays(m) && has_vectors(d, m)).collect()
}

/// Whether the vectors of a unit are rays through the whole traversal.
pub fn takes_rays(m: &Module) -> bool {
    unit_entries().any(|u| u.takes_rays && u.name == m.name)
}

/// The names of the units whose vectors are rays: figures of these are figures of a whole design.
pub fn ray_units() -> Vec<&'static str> {
    unit_entries().filter(|u| u.takes_rays).map(|u| u.name).collect()
}

/// Whether a unit has vectors of its own: rays, or rows with the results of its model.
pub fn has_vectors(d: &Design, m: &Module) -> bool {
    takes_rays(m) || entry(d, &m.name).is_some_and(|u| u.model.is_some() || u.clocked.is_some())
}

/// That these units have no vectors, and what checks them instead.
pub fn without_vectors(d: &Design, names: &[String]) -> String {
    let top = units::traversal::traverse(d).module;
    let one = |name: &String| {
        let inside = top.hierarchy().iter().any(|m| m.name == *name);
        let rays = "rays through traverse check it (`check --unit traverse`)";
        let proved: Vec<&str> = entry(d, name).into_iter().flat_map(|u| u.proofs).map(|proof| proof.name).collect();
        let proved = (!proved.is_empty()).then(|| format!("`prove` has proofs of it ({})", proved.join(", ")));
        let how: Vec<String> = inside.then(|| rays.to_owned()).into_iter().chain(proved).collect();
        let how = if how.is_empty() { String::new() } else { format!(": {}", how.join(", and ")) };
        format!("{name} has no vectors of its own{how}")
    };
    names.iter().map(one).collect::<Vec<_>>().join("; ")
}

/// Settings that bring units which another configuration has not: those of the default, and those that another default would lack.
pub const SETTINGS: [&str; 12] = [
    "emit.units",
    "latency.divider=table",
    "mode.trim=always",
    "mode.lod=true",
    "mode.bilinear=true",
    "fetch.cells=4",
    "latency.divider=rows",
    "latency.memory=1",
    "latency.memory=2",
    "latency.handshake=1",
    "latency.handshake=3",
    "latency.delay_line=3",
];

/// The first of [`SETTINGS`], or another datapath, with which there is a module of this name.
fn setting_of(d: &Design, name: &str) -> Option<String> {
    unit_entries().find(|u| u.name == name)?;
    let setting = |(key, word): &(&str, &str)| format!("{key}={word}");
    let kinds = searches().map(|kind| kind.facts().chosen_by.iter().map(setting).collect::<Vec<_>>().join(" --set "));
    SETTINGS.map(String::from).into_iter().filter(|s| s.contains('=')).chain(kinds).find(|set| {
        let mut c = Config::default();
        (c.mode, c.latency, c.datapath) = (d.mode, d.latency, d.datapath);
        let set = set.split(" --set ").try_for_each(|one| c.apply_set(one)).and_then(|()| c.validate()).is_ok();
        set && units::all(&c.design()).iter().any(|m| m.name == name)
    })
}

/// A unit by name.
///
/// # Errors
/// An unknown name; the sentence names the nearest one.
pub fn find(d: &Design, name: &str) -> Result<Arc<Module>> {
    let mut all = units::all(d);
    all.extend(units::available(d));
    if let Some(setting) = (!all.iter().any(|m| m.name == name)).then(|| setting_of(d, name)).flatten() {
        return Err(Error::input(format!("the configuration has no unit {name}: it comes with --set {setting}")));
    }
    all.iter().find(|m| m.name == name).cloned().ok_or_else(|| {
        let near = nearest(name, all.iter().map(|m| m.name.as_str()));
        let guess = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
        Error::input(format!("no unit is named {name}{guess} (`reliefrtl list` shows all)"))
    })
}

/// The design that a module's parameter values describe.
pub fn design_at(d: &Design, b: &Binding) -> Design {
    let mut d = d.settled();
    let set = |name: &str, slot: &mut u32| {
        if let Some(v) = b.get(name) {
            *slot = *v as u32;
        }
    };
    let (mut exp, mut man) = (d.format.exp, d.format.man);
    set("EXP_W", &mut exp);
    set("MAN_W", &mut man);
    d.format = d.format.resized(exp, man);
    set("LEVELS", &mut d.traverse.levels);
    set("HEIGHT_W", &mut d.traverse.height_bits);
    set("TILE_W", &mut d.traverse.tile_bits);
    set("FRAC_W", &mut d.traverse.frac_bits);
    set("TAG_W", &mut d.traverse.tag_bits);
    set("STEP_LIMIT", &mut d.traverse.step_limit);
    set("NUDGE_W", &mut d.datapath.nudge_bits);
    set("FRACTION_W", &mut d.datapath.fraction_bits);
    set("RECIP_W", &mut d.datapath.reciprocal_bits);
    d
}

/// The vectors of a unit at parameter values `over`, with the golden model's results.
pub fn vector_set(d: &Design, m: &Module, over: &Binding, plan: Plan) -> VectorSet {
    let b = m.binding_with(over);
    let at = design_at(d, &b);
    if let Some(model) = entry(&at, &m.name).and_then(|u| u.clocked) {
        return clocked_set(m, &at, b, model, plan);
    }
    let kinds = kinds(m, &at, &b);
    let (mut rows, mut counts) = plan_rows(&kinds, plan);
    if let Some(stimulus) = entry(&at, &m.name).and_then(|u| u.stimulus).filter(|_| counts.exhaustive == 0) {
        // Where a ray can come by, half of the rows are what it brings.
        let names: Vec<&str> = m.data_inputs().map(|(_, p)| p.name.as_str()).collect();
        let idx_w = Context::new(at, &b).idx_w;
        let (free, kept) = plan_rows(&kinds, Plan { rows: plan.rows - plan.rows / 2, ..plan });
        let mut sampled = free[..plan.rows / 2].to_vec();
        if sample_rows(stimulus, &names, &at, idx_w, plan.seed, &mut sampled) {
            counts = Counts { rays: sampled.len(), ..kept };
            rows = [free, sampled].concat();
        }
    }
    // They take the place of the last random rows.
    let widths: Vec<u32> = kinds.iter().map(|k| k.width()).collect();
    let found = found_rows(&at, &m.name, &widths);
    let first = counts.corners + counts.random - found.len().min(counts.random);
    let taken = rows[first..counts.corners + counts.random].iter_mut().zip(found).map(|(row, f)| *row = f).count();
    counts = Counts { random: counts.random - taken, found: taken, ..counts };
    answered(m, &at, b, VectorSet { seed: plan.seed, counts, stimulus: rows, ..VectorSet::default() })
}

/// As [`vector_set`], with tables of corners crossed whole, and the part of it that is asked for.
pub fn campaign_set(d: &Design, m: &Module, over: &Binding, plan: Plan, campaign: Campaign) -> VectorSet {
    let b = m.binding_with(over);
    let at = design_at(d, &b);
    if let Some(model) = entry(&at, &m.name).and_then(|u| u.clocked) {
        // Corners of a clock say little: what is tried is the load of both sides.
        return clocked_set(m, &at, b, model, plan);
    }
    let (rows, counts) = campaign_rows(&kinds(m, &at, &b), plan, campaign);
    let set = VectorSet { seed: plan.seed, counts, campaign: Some(campaign), stimulus: rows, ..VectorSet::default() };
    answered(m, &at, b, set)
}

/// What each input column means.
fn kinds(m: &Module, at: &Design, b: &Binding) -> Vec<Kind> {
    let kind = |p: &Port| match p.unit.is_float() {
        true => Kind::Float(at.format),
        false => Kind::Integer(p.width.eval(b) as u32),
    };
    m.data_inputs().map(|(_, p)| kind(p)).collect()
}

/// The vectors of a unit whose rows are clocks.
fn clocked_set(m: &Module, at: &Design, b: Binding, model: Clocked, plan: Plan) -> VectorSet {
    let (stimulus, expected) = clocked::clocks(m, &Context::new(*at, &b), model, plan);
    let counts = Counts { random: stimulus.len(), ..Counts::default() };
    let (inputs, outputs) = columns(m, &b);
    VectorSet {
        unit: m.name.clone(),
        params: b,
        seed: plan.seed,
        counts,
        inputs,
        outputs,
        stimulus,
        expected,
        ..VectorSet::default()
    }
}

/// A column for each input and each output.
fn columns(m: &Module, b: &Binding) -> (Vec<Column>, Vec<Column>) {
    let column = |p: &Port| Column { name: p.name.clone(), width: p.width.eval(b) as u32 };
    (m.data_inputs().map(|(_, p)| column(p)).collect(), m.data_outputs().map(|(_, p)| column(p)).collect())
}

/// A set with unit, columns and the golden model's results; rows that the unit does not allow are made such that it does.
fn answered(m: &Module, at: &Design, b: Binding, set: VectorSet) -> VectorSet {
    let (inputs, outputs) = columns(m, &b);
    let (unit, c) = (Modelled::of(at, m), Context::new(*at, &b));
    let stimulus: Vec<Vec<u64>> = set.stimulus.into_iter().map(|r| unit.legal(&c, r)).collect();
    let expected = stimulus.iter().map(|r| unit.results(&c, r)).collect();
    VectorSet { unit: m.name.clone(), params: b, inputs, outputs, stimulus, expected, ..set }
}
