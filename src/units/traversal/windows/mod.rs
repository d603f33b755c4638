//! The fixed-point datapath with a search by windows: no node, no level; all windows ahead of the ray are read in one iteration
//! (`docs/windows.md`).
mod iteration;
mod params;
mod plane_product;
mod plane_sum;
mod search;
mod window_address;
mod window_advance;
mod window_choice;
mod window_constants;
mod window_end;
mod window_exit;
mod window_index;
mod window_setup;
mod window_span;
mod window_texel;
mod window_way;

pub use plane_product::plane_product;
pub use plane_sum::plane_sum;
pub use window_address::window_address;
pub use window_advance::window_advance;
pub use window_choice::window_choice;
pub use window_constants::window_constants;
pub use window_end::window_end;
pub use window_exit::window_exit;
pub use window_index::window_index;
pub use window_setup::window_setup;
pub use window_span::window_span;
pub use window_texel::window_texel;
pub use window_way::window_way;

use super::datapath::Datapath;
use super::fixed::{self, axis_units, hit_position, ray_setup};

pub(super) static DATAPATH: Datapath = Datapath {
    search: &search::WINDOWS,
    arithmetic: fixed::DATAPATH.arithmetic,
    steps: |d| {
        let mut list = axis_units(d);
        list.extend([
            ray_setup(d),
            window_constants(d),
            window_texel(d),
            window_address(d),
            plane_product(d),
            plane_sum(d),
            window_span(d),
            window_end(d),
            window_exit(d),
            window_choice(d),
            window_advance(d),
            window_way(d),
            window_index(d),
        ]);
        list
    },
    declare: fixed::DATAPATH.declare,
    numbers: fixed::numbers,
    constants: |_, _| Vec::new(),
    setup: window_setup,
    iteration: iteration::iteration,
    level_decision: None,
    level_up: |_| None,
    hit: hit_position,
    hit_inputs: fixed::DATAPATH.hit_inputs,
    difference: |row| match row {
        "stages" => "one iteration reads all windows, and nothing is divided in the loop",
        _ => "fixed-point arithmetic instead of floating-point units",
    },
};
