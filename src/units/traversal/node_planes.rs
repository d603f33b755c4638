//! `node_planes`: along one axis, the texels that a descent may go to, the plane by which the ray can leave,
//! and the texel behind it (PIDM-HW section 3.2, node crossing).
use super::params::{LevelParams, bindings, index_width};
use crate::config::TraverseConfig;
use crate::ir::{Builder, Module};
use std::sync::Arc;

/// Builds `node_planes`, combinational; `parity` adds the output that tevs and selective level-up ask for.
pub fn node_planes(t: &TraverseConfig, parity: bool) -> Arc<Module> {
    let b =
        Builder::new("node_planes", file!(), "extent of a node along one axis, and the plane by which the ray leaves");
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    let level = b.input("level", &level_w, "levels", "0 .. LEVELS");
    let x = b.input("x", &idx, "texels", "any texel of the node");
    let minus = b.input("neg", 1, "bit", "the ray runs toward smaller coordinates");
    let low = b.output("low", &idx, "texels", "least texel that a descent may go to: never behind x");
    let high = b.output("high", &idx, "texels", "greatest texel that a descent may go to: never behind x");
    let plane = b.output("plane", &idx, "texels", "coordinate of the exit plane");
    let beyond = b.output("beyond", &idx, "texels", "the texel just behind the exit plane");
    let even = parity.then(|| b.output("even", 1, "bit", "the plane also bounds the parent node"));

    let keep = b.ones(&idx).shift_left(level).named("keep");
    let first = (x & keep).named("first");
    let last = (x | !keep).named("last");
    let edge = minus.mux(first, last).named("side");
    let exit = (edge + (!minus).zext(&idx)).named("exit_plane");
    let next = minus.mux(first - b.lit(1, &idx), exit).named("next");
    b.drive(low, minus.mux(first, x), None);
    b.drive(high, minus.mux(x, last), None);
    b.drive(plane, exit, None);
    b.drive(beyond, next, None);
    if let Some(even) = even {
        let in_nodes = exit.shift_right(level).named("plane_in_nodes");
        b.unused(in_nodes);
        b.drive(even, !in_nodes.bit(0), None);
    }
    b.finish(Some(0), &bindings())
}
