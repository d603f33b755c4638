//! `block_middle`: along one axis, the plane between the two halves of a block of four cells, and how the ray stands to it (`docs/cells.md`).
use crate::quantity::{BIT, LEVELS, TEXELS};
use crate::traversal::params::{LevelParams, bindings, index_width};
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `block_middle`.
pub fn block_middle(d: &Design) -> Arc<Module> {
    let (t, registered) = (&d.traverse, d.latency.has(Register::NodeExtent));
    let b = Builder::new("block_middle", file!(), "middle plane of a block of four cells along one axis");
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    if registered {
        b.clock();
        b.clock_enable();
    }
    let level = b.input("level", &level_w, LEVELS, "level of the cells, 0 .. LEVELS - 1");
    let x = b.input("x", &idx, TEXELS, "the ray's texel, in the block");
    let minus = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let middle = b.output("middle", &idx, TEXELS, "coordinate of the plane between the halves");
    let past = b.output("past", 1, BIT, "the texel is in the far half, seen along the ray");
    let first = b.output("first", &idx, TEXELS, "where the ray enters the far half: its first texel, or the ray's own");

    // As in `node_planes`, a shift and a sum.
    let keep = b.ones(&idx).shift_left(level).named("keep");
    // The lowest bit that a cell's index keeps tells the halves apart.
    let side = (keep & !b.cat(&[keep.slice(0, &idx - 1), b.zeros(1)])).named("side_length");
    let upper = (x & side).any().named("is_upper").reg_if(registered);
    let corner = ((x & keep) | side).named("middle_plane").reg_if(registered);
    let (x, minus) = (x.reg_if(registered), minus.reg_if(registered));
    let is_past = (upper ^ minus).named("is_past");
    let edge = (corner - minus.zext(&idx)).named("border");
    b.drive(middle, corner);
    b.drive(past, is_past);
    b.drive(first, is_past.mux(x, edge).named("first_far"));
    b.finish(&bindings())
}
