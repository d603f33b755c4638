//! `node_planes`: along one axis, the texels that a descent may go to, the plane by which the ray can leave,
//! and the texel beyond it (PIDM-HW section 3.2, node crossing).
use super::params::{LevelParams, bindings, index_width};
use crate::quantity::{BIT, LEVELS, TEXELS};
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `node_planes`; `parity` adds the output that tevs and selective level-up ask for.
pub fn node_planes(d: &Design, parity: bool) -> Arc<Module> {
    let (t, registered) = (&d.traverse, d.latency.has(Register::NodeExtent));
    let b =
        Builder::new("node_planes", file!(), "extent of a node along one axis, and the plane by which the ray leaves");
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    if registered {
        b.clock();
        b.clock_enable();
    }
    let level = b.input("level", &level_w, LEVELS, "0 .. LEVELS");
    let x = b.input("x", &idx, TEXELS, "any texel of the node");
    let minus = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let low = b.output("low", &idx, TEXELS, "least texel that a descent may enter: none that the ray has passed");
    let high = b.output("high", &idx, TEXELS, "greatest texel that a descent may enter: none that the ray has passed");
    let plane = b.output("plane", &idx, TEXELS, "coordinate of the exit plane");
    let beyond = b.output("beyond", &idx, TEXELS, "the first texel beyond the exit plane");
    let even = parity.then(|| b.output("even", 1, BIT, "the plane also bounds the parent node"));

    // Extent and planes are a shift and a sum, one after the other.
    let keep = b.ones(&idx).shift_left(level).named("keep");
    let first = (x & keep).named("first").reg_if(registered);
    let last = (x | !keep).named("last").reg_if(registered);
    // The plane lies at the node's number, or at the next one: the last bit of that takes neither a shift nor a sum.
    let is_odd = parity.then(|| {
        let keep = keep.reg_if(registered);
        let side = (keep & !b.cat(&[keep.slice(0, &idx - 1), b.zeros(1)])).named("side_length");
        (first & side).any().named("is_odd")
    });
    let (x, minus) = (x.reg_if(registered), minus.reg_if(registered));
    let edge = minus.mux(first, last).named("side");
    let exit = (edge + (!minus).zext(&idx)).named("exit_plane");
    let next = minus.mux(first - b.lit(1, &idx), exit).named("next");
    b.drive(low, minus.mux(first, x));
    b.drive(high, minus.mux(x, last));
    b.drive(plane, exit);
    b.drive(beyond, next);
    if let Some((even, is_odd)) = even.zip(is_odd) {
        b.drive(even, is_odd ^ minus);
    }
    b.finish(&bindings())
}
