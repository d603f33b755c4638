//! The watertight datapath: parameters of integer planes, compared in floating point (`docs/datapath.md`).
mod axis_ends;
mod axis_scale;
mod axis_slope;
mod chord_end;
mod depth_limit;
mod height_test;
mod hit_position;
mod node_crossing;
mod plane_order;
mod plane_time;
mod predicted_hit;
mod ray_setup;

pub use axis_ends::axis_ends;
pub use axis_scale::axis_scale;
pub use axis_slope::axis_slope;
pub use chord_end::chord_end;
pub use depth_limit::depth_limit;
pub use height_test::height_test;
pub use hit_position::hit_position;
pub use node_crossing::node_crossing;
pub use plane_order::plane_order;
pub use plane_time::plane_time;
pub use predicted_hit::predicted_hit;
pub use ray_setup::ray_setup;

use super::cells::{self, block_iteration, cell_choice};
use super::datapath::Datapath;
use super::level_decision::{TimeWord, level_decision};
use super::level_up::level_up;
use super::loop_state::{Field, Numbers, Sizes, Start};
use super::params::ray_conditions;
use super::plane_iteration::plane_iteration;
use super::plane_units::PlaneUnits;
use super::search::PYRAMID;
use crate::divider::divider_core;
use crate::float::{self, FormatParams};
use crate::quantity::float;
use reliefrtl_config::{Design, Trim};
use reliefrtl_ir::{Expr, Module};
use std::sync::Arc;

pub(in crate::traversal) static DATAPATH: Datapath = Datapath {
    search: &PYRAMID,
    arithmetic,
    steps: |d| {
        let mut list = vec![plane_time(d), height_test(d), predicted_hit(d), node_crossing(d)];
        list.extend((d.mode.trim != Trim::None).then(|| chord_end(d)));
        list.extend([axis_scale(d), axis_slope(d)]);
        list.extend(d.mode.start_level.then(|| axis_ends(d)));
        list
    },
    declare: |b, d| Some(FormatParams::declare(b, d.format)),
    numbers: |b, d, f, levels, height, tile| {
        let f = f.expect("declared just before");
        ray_conditions(b, d, &f, levels, height, tile);
        let of = |unit| (f.width.clone(), unit);
        Numbers {
            entry: of(float("tiles")),
            travel: of(float("tiles")),
            time: of(float("height codes")),
            float: Some(f),
        }
    },
    constants,
    setup: ray_setup,
    iteration: |b, s, d, ray, source, _| plane_iteration(b, s, d, ray, source, &UNITS),
    level_decision: Some(UNITS.level_decision),
    level_up,
    hit: hit_position,
    hit_inputs: |ray, axis| {
        let of = |name: &str| ray.get(&format!("{name}_{axis}"));
        let mut ins = vec![("p", of("p")), ("d", of("d")), ("t", ray.get("t")), ("x", ray.get(axis))];
        ins.extend(ray.find("lod").map(|lod| ("lod", lod)));
        ins
    },
    difference: |row| match row {
        "adders" => "only the hit is predicted; a crossing steps an integer index and needs no position",
        "multipliers" => "planes times a reciprocal, and the hit; t counts height codes, so heights are not scaled",
        "dividers" => "the reciprocal of the travel is found once per ray, in setup",
        "stages" => "no division, and no position after the nearer plane is known",
        _ => "",
    },
};

/// The same with four cells an iteration.
pub(in crate::traversal) static BLOCKS: Datapath = Datapath {
    search: &cells::BLOCKS,
    steps: |d| {
        let mut list = (DATAPATH.steps)(d);
        // The choice of a cell says what a node's crossing does.
        list.retain(|m| m.name != node_crossing(d).name);
        list.extend([plane_order(d), depth_limit(d), (UNITS.cell_choice)(d)]);
        list
    },
    iteration: |b, s, d, ray, source, _| block_iteration(b, s, d, ray, source, &UNITS),
    difference: |row| match row {
        "comparators" => "twelve put the planes of a block in order, two meet a height",
        "multipliers" => "four planes times a reciprocal, and the hit",
        "stages" => "planes of a block, then their order and the choice of a cell; no division",
        _ => (DATAPATH.difference)(row),
    },
    ..DATAPATH
};

const UNITS: PlaneUnits = PlaneUnits {
    plane_time,
    plane_inputs: &[("p", "p"), ("r", "r"), ("never", "never")],
    height_test,
    predicted_hit,
    predicted_inputs: &[("p_back", "pb"), ("d", "d")],
    chord_end,
    chord_inputs: &[("p_ahead", "pf"), ("d", "d"), ("neg", "neg")],
    leaves_y: |b, d, [t_x, t_y]| {
        let lt = float::fp_lt(d.format, d.latency.compare);
        b.inst(&lt, "u_exit_order", &[], &[("a", t_y), ("b", t_x)]).only()
    },
    node_crossing,
    plane_order,
    depth_limit,
    cell_choice: |d| cell_choice(d, &TIME),
    level_decision: |d| level_decision(d, &TIME),
};

const TIME: TimeWord = TimeWord {
    declare: |b, d| (FormatParams::declare(b, d.format).width, float("height codes")),
    bindings: float::bindings,
};

/// Per axis: entry point, the same biased backwards, direction, reciprocal, and how it runs.
fn constants(s: &Sizes, d: &Design) -> Vec<Field> {
    let (float, bit) = (s.numbers.time.0.clone(), Expr::from(1));
    let of = |name, width| Field::new(name, width, Start::Setup(name));
    let mut list = vec![
        of("p_x", &float),
        of("pb_x", &float),
        of("d_x", &float),
        of("r_x", &float),
        of("never_x", &bit),
        of("neg_x", &bit),
        of("p_y", &float),
        of("pb_y", &float),
        of("d_y", &float),
        of("r_y", &float),
        of("never_y", &bit),
        of("neg_y", &bit),
    ];
    if d.mode.trim != Trim::None {
        list.extend([of("pf_x", &float), of("le_x", &s.idx), of("pf_y", &float), of("le_y", &s.idx)]);
    }
    list
}

fn arithmetic(d: &Design) -> Vec<Arc<Module>> {
    let (f, l) = (d.format, &d.latency);
    let (int, [from, to]) = d.conversions();
    vec![
        divider_core(d),
        float::fp_add(f, l.add),
        float::fp_mul(f, l.mul),
        float::fp_div(f, l),
        float::fp_lt(f, l.compare),
        float::fp_from_int(f, int, l.from_int),
        float::fp_to_int(f, int, l.to_int),
        float::fp_from_fixed(f, from.0, from.1, l.from_int),
        float::fp_to_fixed(f, to.0, to.1, l.to_int),
    ]
}
