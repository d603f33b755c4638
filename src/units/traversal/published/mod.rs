//! The published datapath (PIDM-HW sections 4.2 and 4.3, table 1): positions moved in floating point, node boundaries found
//! by dividers in the loop, the ray's end computed on its first trip (`docs/published.md`).
mod boundary_time;
mod crossing_test;
mod descent_level;
mod exit_plane;
mod iteration;
mod level_choice;
mod nearer_plane;
mod ray_point;
mod ray_scale;
mod surface_time;
mod texel_fraction;

pub use boundary_time::boundary_time;
pub use crossing_test::crossing_test;
pub use descent_level::descent_level;
pub use exit_plane::exit_plane;
pub use level_choice::level_choice;
pub use nearer_plane::nearer_plane;
pub use ray_point::ray_point;
pub use ray_scale::ray_scale;
pub use surface_time::surface_time;
pub use texel_fraction::texel_fraction;

use super::datapath::Datapath;
use super::level_up::{level_up_at_once, reads_parity};
use super::loop_state::{Field, Numbers, Sizes, Start};
use super::params::float_sizes;
use super::search::PYRAMID;
use crate::divider::divider_core;
use crate::float::{self, FormatParams};
use crate::quantity::float;
use reliefrtl_config::Design;
use reliefrtl_ir::{Expr, Module};
use std::sync::Arc;

pub(super) static DATAPATH: Datapath = Datapath {
    search: &PYRAMID,
    arithmetic,
    steps: |d| {
        vec![
            exit_plane(&d.traverse, reads_parity(d)),
            boundary_time(d),
            surface_time(d),
            nearer_plane(d, reads_parity(d)),
            ray_point(d),
            crossing_test(d),
            descent_level(&d.traverse, &d.mode),
            level_choice(d),
        ]
    },
    declare: |b, d| {
        let f = FormatParams::declare(b, d.format);
        boundary_time::nudge_width(b, d);
        Some(f)
    },
    numbers: |b, _, f, levels, height, tile| {
        let f = f.expect("declared just before");
        float_sizes(b, &f, levels, height, tile);
        b.require(levels + tile + 2 + Expr::param("NUDGE_W") + &f.man, 60);
        let of = |unit| (f.width.clone(), unit);
        Numbers {
            entry: of(float("tiles")),
            travel: of(float("tiles")),
            time: of(float("height range")),
            float: Some(f),
        }
    },
    constants,
    setup: ray_scale,
    iteration: |b, s, d, ray, source, _| iteration::iteration(b, s, d, ray, source),
    level_decision: None,
    level_up: level_up_at_once,
    hit: texel_fraction,
    hit_inputs: |ray, axis| {
        let of = |name: &str| ray.get(&format!("{name}_{axis}"));
        vec![("p", of("p")), ("d", of("d")), ("t", ray.get("t"))]
    },
    difference: |row| match row {
        "stages" => "latencies other than the published ones: add 2, divide 2, multiply 1, compare 1",
        _ => "",
    },
};

/// Per axis entry point and travel; and whether the trip is the one that finds the start level.
fn constants(s: &Sizes, d: &Design) -> Vec<Field> {
    let float = s.numbers.time.0.clone();
    let mut list: Vec<Field> =
        ["p_x", "d_x", "p_y", "d_y"].map(|name| Field::new(name, &float, Start::Setup(name))).into();
    list.extend(
        d.mode
            .start_level
            .then(|| Field::new("first", &Expr::from(1), Start::One).doc("this iteration finds the start level")),
    );
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
