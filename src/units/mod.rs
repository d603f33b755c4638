//! The hardware: one file a unit, named as the unit is.
pub mod div_rows;
pub mod float;
pub mod interleave;
pub mod lzc;
pub mod traversal;

use crate::config::Design;
use crate::ir::Module;
use std::sync::Arc;

/// Every unit of a design, leaves first, `traverse` last. What the modes don't need is left out.
pub fn all(d: &Design) -> Vec<Arc<Module>> {
    let (f, t, l) = (d.format, &d.traverse, &d.latency);
    let fixed = t.idx_bits() + t.frac_bits;
    let parity = matches!(d.mode.level_up, crate::config::LevelUp::Tevs | crate::config::LevelUp::Selective);
    let mut list = vec![
        lzc::lzc_module(8),
        interleave::interleave_module(t.levels + 1),
        div_rows::div_rows_module(f.man + 1, f.man + 3),
        float::fp_add(f, l.add),
        float::fp_mul(f, l.mul),
        float::fp_div(f, l.div),
        float::fp_lt(f, l.compare),
        float::fp_from_int(f, t.idx_bits(), l.from_int),
        float::fp_to_int(f, t.idx_bits(), l.to_int),
        float::fp_from_fixed(f, fixed, t.frac_bits, l.from_int),
        float::fp_to_fixed(f, fixed, t.frac_bits, l.to_int),
        traversal::start_level(t),
        traversal::height_address(t),
        traversal::node_planes(t, parity),
        traversal::plane_time(d),
        traversal::height_test(d),
        traversal::predicted_hit(d),
        traversal::node_crossing(d),
        traversal::multi_level_down(t, &d.mode),
    ];
    list.extend(traversal::level_up(t, d.mode.level_up));
    list.extend([
        traversal::level_decision(d),
        traversal::ray_setup(d),
        traversal::hit_position(d),
        traversal::height_memory(2 * t.levels + 1, t.height_bits, ((1 << (2 * t.levels + 2)) - 1) / 3),
        traversal::traverse(d).module,
    ]);
    if !d.mode.start_level {
        list.retain(|m| m.name != "start_level");
    }
    list
}
