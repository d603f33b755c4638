//! One entry a unit: its hardware, its model, its vectors. Here alone hardware and golden model meet.
mod check;
mod events;
mod limits;
mod met;
mod models;
mod ray_plan;
mod rays;

pub use check::{CheckReport, Mismatch, check_interp, check_netlist, compare, decoded, fits};
pub use events::count_events;
pub use limits::limit_sets;
pub use models::model;
pub use ray_plan::planned_rays;
pub use rays::{RaySet, ray_columns, ray_set, ray_set_at};

use crate::config::{DatapathKind, Design};
use crate::error::{Error, Result};
use crate::interp::elaborate;
use crate::ir::{Binding, Module};
use crate::units;
use crate::vectors::{Campaign, Column, Counts, Kind, Plan, VectorSet, campaign_rows, plan_rows};
use std::sync::Arc;

/// The units that have vectors of their own, leaves first: all but `traverse` and those that hold a memory, which ray sets exercise.
pub fn units(d: &Design) -> Vec<Arc<Module>> {
    let memories = ["height_memory", "height_banks"];
    let holds = |m: &Module| {
        memories.contains(&m.name.as_str()) || units::traversal::bilinear::WITH_MEMORY.contains(&m.name.as_str())
    };
    units::all(d).into_iter().filter(|m| m.latency.is_some() && !holds(m)).collect()
}

/// A unit by name.
///
/// # Errors
/// An unknown name; the sentence offers the nearest one.
pub fn find(d: &Design, name: &str) -> Result<Arc<Module>> {
    let mut all = units::all(d);
    all.extend(units::available(d));
    let near = all.iter().max_by(|a, b| strsim::jaro(&a.name, name).total_cmp(&strsim::jaro(&b.name, name)));
    let near = near.map(|m| m.name.clone()).unwrap_or_default();
    let miss = || Error::input(format!("no unit is named {name}; did you mean {near}? (`reliefrtl list` shows all)"));
    all.iter().find(|m| m.name == name).cloned().ok_or_else(miss)
}

/// The design that a module's parameter values describe.
pub fn design_at(d: &Design, b: &Binding) -> Design {
    let mut d = *d;
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
    let kinds = kinds(m, &at, &b);
    let (mut rows, mut counts) = plan_rows(&kinds, plan);
    if counts.exhaustive == 0 {
        // Where a ray can come by, half of the rows are what it brings.
        let names: Vec<&str> = m.data_inputs().map(|(_, p)| p.name.as_str()).collect();
        let idx = b.get("IDX_W").map_or(at.traverse.idx_bits(), |v| *v as u32);
        let (free, kept) = plan_rows(&kinds, Plan { rows: plan.rows - plan.rows / 2, ..plan });
        let mut met = free[..plan.rows / 2].to_vec();
        let meet = if at.datapath.kind == DatapathKind::Fixed { met::fixed::meet } else { met::meet };
        if meet(&m.name, &names, &at, idx, plan.seed, &mut met) {
            counts = Counts { rays: met.len(), ..kept };
            rows = [free, met].concat();
        }
    }
    answered(m, &at, b, VectorSet { seed: plan.seed, counts, stimulus: rows, ..VectorSet::default() })
}

/// As [`vector_set`], with tables of corners crossed whole, and the part of it that is asked for.
pub fn campaign_set(d: &Design, m: &Module, over: &Binding, plan: Plan, campaign: Campaign) -> VectorSet {
    let b = m.binding_with(over);
    let at = design_at(d, &b);
    let (rows, counts) = campaign_rows(&kinds(m, &at, &b), plan, campaign);
    let set = VectorSet { seed: plan.seed, counts, campaign: Some(campaign), stimulus: rows, ..VectorSet::default() };
    answered(m, &at, b, set)
}

/// What each input column means.
fn kinds(m: &Module, at: &Design, b: &Binding) -> Vec<Kind> {
    let kind = |p: &crate::ir::Port| match p.unit.starts_with("float") {
        true => Kind::Float(at.format),
        false => Kind::Integer(p.width.eval(b) as u32),
    };
    m.data_inputs().map(|(_, p)| kind(p)).collect()
}

/// A set with unit, columns and the golden model's results; rows that the unit does not allow are made such that it does.
fn answered(m: &Module, at: &Design, b: Binding, set: VectorSet) -> VectorSet {
    let column = |p: &crate::ir::Port| Column { name: p.name.clone(), width: p.width.eval(&b) as u32 };
    let inputs: Vec<Column> = m.data_inputs().map(|(_, p)| column(p)).collect();
    let outputs: Vec<Column> = m.data_outputs().map(|(_, p)| column(p)).collect();
    let stimulus: Vec<Vec<u64>> = set.stimulus.into_iter().map(|r| models::legal(&m.name, at, &b, r)).collect();
    let expected = stimulus.iter().map(|r| model(&m.name, at, &b, r)).collect();
    VectorSet { unit: m.name.clone(), params: b, inputs, outputs, stimulus, expected, ..set }
}

/// Parameter values, besides the defaults, at which a unit's vectors are checked.
pub fn bindings(m: &Module) -> Vec<Binding> {
    let of = |pairs: &[(&str, i64)]| -> Binding { pairs.iter().map(|(k, v)| (k.to_string(), *v)).collect() };
    let has = |p: &str| m.params.iter().any(|q| q.name == p);
    let mut out = Vec::new();
    if has("EXP_W") {
        out.extend([(5, 10), (8, 23), (4, 3)].map(|(e, f)| of(&[("EXP_W", e), ("MAN_W", f)])));
    }
    if has("FRACTION_W") {
        let of =
            |f, w| if has("RECIP_W") { of(&[("FRACTION_W", f), ("RECIP_W", w)]) } else { of(&[("FRACTION_W", f)]) };
        out.extend([of(20, 18), of(12, 10), of(28, 31)]);
    }
    if has("LEVELS") {
        out.extend(
            [2, 5, 12]
                .map(|l| if has("IDX_W") { of(&[("LEVELS", l), ("IDX_W", l + 6)]) } else { of(&[("LEVELS", l)]) }),
        );
    }
    if has("HEIGHT_W") {
        out.push(of(&[("HEIGHT_W", 16)]));
    }
    if has("NUDGE_W") {
        out.extend([0, 1, 12, 16].map(|n| of(&[("NUDGE_W", n)])));
    }
    if m.name == "sqrt_rows" {
        out.extend(
            [(18, 3, 4), (18, 1, 17), (30, 12, 18), (5, 4, 1)]
                .map(|(w, f, n)| of(&[("W", w), ("FIRST", f), ("ROWS", n)])),
        );
    } else if has("W") && m.name != "div_rows" {
        out.extend([1, 2, 3, 7, 17, 32].map(|w| of(&[("W", w)])));
    }
    // Parameters may be legal for the unit and not for one inside of it: a deep divider needs its rows.
    out.retain(|b| m.failed_checks(&m.binding_with(b)).is_empty() && elaborate(m, b).is_ok());
    out
}
