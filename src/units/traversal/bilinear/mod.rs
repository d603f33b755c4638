//! The bilinear refinement of a hit (`docs/bilinear.md`; PDM section 3.3): a pipeline after the loop, with a copy of the map for each end of its window.
mod bank_address;
mod bilinear_hit;
mod bilinear_window;
mod common;
mod patch_corner;
mod patch_memory;
mod ray_place;
mod secant_step;
mod surface_gap;

pub use bank_address::bank_address;
pub use bilinear_hit::{NAME, bilinear_hit};
pub use bilinear_window::bilinear_window;
pub use patch_corner::patch_corner;
pub use patch_memory::patch_memory;
pub use ray_place::ray_place;
pub use secant_step::secant_step;
pub use surface_gap::surface_gap;

use reliefrtl_config::Design;
use reliefrtl_ir::Module;
use std::sync::Arc;

/// All of them, leaves first.
pub fn units(d: &Design) -> Vec<Arc<Module>> {
    vec![
        bilinear_window(d),
        ray_place(d),
        patch_corner(&d.traverse),
        bank_address(&d.traverse),
        patch_memory(&d.traverse),
        surface_gap(d),
        secant_step(d),
        bilinear_hit(d),
    ]
}
