//! The fixed-point datapath: parameters of integer planes, compared as unsigned integers (`docs/fixed.md`).
mod axis_ends;
mod axis_slope;
mod chord_end;
mod depth_limit;
mod height_test;
mod hit_position;
mod node_crossing;
pub(super) mod params;
mod plane_order;
mod plane_time;
mod predicted_hit;
mod ray_setup;
mod reciprocal;
mod reciprocal_ports;
mod reciprocal_table;

pub use axis_ends::axis_ends;
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
pub use reciprocal::reciprocal;

use super::cells::{self, block_iteration, cell_choice};
use super::datapath::Datapath;
use super::level_decision::{TimeWord, level_decision};
use super::level_up::level_up;
use super::loop_state::{Field, Numbers, Sizes, Start};
use super::plane_iteration::plane_iteration;
use super::plane_units::PlaneUnits;
use super::search::PYRAMID;
use params::{LENGTH, Params, TIME, reach_conditions, shift_width, time_width};
use reliefrtl_config::{Design, Trim};
use reliefrtl_ir::{Builder, Expr, Module};
use std::sync::Arc;

pub(in crate::traversal) static DATAPATH: Datapath = Datapath {
    search: &PYRAMID,
    arithmetic: |d| vec![reciprocal::reciprocal_core(d)],
    steps: |d| {
        let mut list = axis_units(d);
        list.extend(d.mode.start_level.then(|| axis_ends(d)));
        list.extend([plane_time(d), height_test(d), predicted_hit(d), node_crossing(d)]);
        list.extend((d.mode.trim != Trim::None).then(|| chord_end(d)));
        list
    },
    declare: |b, d| {
        let of = Params { b, d };
        of.fraction();
        of.recip();
        None
    },
    numbers,
    constants,
    setup: ray_setup,
    iteration: |b, s, d, ray, source, _| plane_iteration(b, s, d, ray, source, &UNITS),
    level_decision: Some(UNITS.level_decision),
    level_up,
    hit: hit_position,
    hit_inputs: |ray, axis| {
        let of = |name: &str| ray.get(&format!("{name}_{axis}"));
        let mut ins =
            vec![("p", of("p")), ("s", of("s")), ("neg", of("neg")), ("t", ray.get("t")), ("x", ray.get(axis))];
        ins.extend(ray.find("lod").map(|lod| ("lod", lod)));
        ins
    },
    difference: |row| match row {
        "stages" => "fixed-point units are shorter, and nothing is divided in the loop",
        _ => "fixed-point arithmetic instead of floating-point units",
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
        "stages" => "planes of a block, then their order and the choice of a cell; nothing is divided",
        _ => (DATAPATH.difference)(row),
    },
    ..DATAPATH
};

/// What the setup of an axis is made of, whatever is searched, leaves first.
pub(super) fn axis_units(d: &Design) -> Vec<Arc<Module>> {
    vec![reciprocal(d), axis_slope(d)]
}

const UNITS: PlaneUnits = PlaneUnits {
    plane_time,
    plane_inputs: &[("p", "p"), ("neg", "neg"), ("r", "r"), ("z", "z")],
    height_test,
    predicted_hit,
    predicted_inputs: &[("p", "p"), ("s", "s"), ("neg", "neg")],
    chord_end,
    chord_inputs: &[("p", "p"), ("s", "s"), ("neg", "neg")],
    // One comparison beside a multiplication.
    leaves_y: |_, _, [t_x, t_y]| t_y.lt(t_x),
    node_crossing,
    plane_order,
    depth_limit,
    cell_choice: |d| cell_choice(d, &TIME_WORD),
    level_decision: |d| level_decision(d, &TIME_WORD),
};

const TIME_WORD: TimeWord =
    TimeWord { declare: |b, d| (time_width(&Params { b, d }.fraction()), TIME), bindings: Vec::new };

pub(super) fn numbers(
    b: &Builder,
    _: &Design,
    _: Option<crate::float::FormatParams>,
    levels: &Expr,
    height: &Expr,
    tile: &Expr,
) -> Numbers {
    let (f, w) = (Expr::param("FRACTION_W"), Expr::param("RECIP_W"));
    b.require(levels, &f);
    b.require(2, height);
    b.require(height, 16);
    b.require(height, &f);
    reach_conditions(b, &f, tile);
    b.require(&f + tile + &w, 63);
    b.require(levels + tile + 2, 24);
    let travel = &f + tile + 1;
    Numbers { entry: (f.clone(), LENGTH), travel: (travel, LENGTH), time: (time_width(&f), TIME), float: None }
}

/// Per axis: entry point, travel per height code, reciprocal of the travel and its shift, and which way it goes; for a trim, how far at most.
fn constants(s: &Sizes, d: &Design) -> Vec<Field> {
    let (f, w) = (Expr::param("FRACTION_W"), Expr::param("RECIP_W"));
    let (reach, bit) = (&f + &s.tile, Expr::from(1));
    let of = |name, width: &Expr| Field::new(name, width, Start::Setup(name));
    let (long, shift) = (&reach + 1, shift_width(&reach));
    let mut list = vec![
        of("p_x", &f),
        of("s_x", &long),
        of("r_x", &w),
        of("z_x", &shift),
        of("neg_x", &bit),
        of("p_y", &f),
        of("s_y", &long),
        of("r_y", &w),
        of("z_y", &shift),
        of("neg_y", &bit),
    ];
    if d.mode.trim != Trim::None {
        list.extend([of("le_x", &s.idx), of("le_y", &s.idx)]);
    }
    list
}
