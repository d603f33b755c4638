//! `exit_plane`: along one axis, the plane by which the ray can leave a node (PIDM-HW section 3.2, node crossing).
use crate::quantity::{BIT, LEVELS, TEXELS};
use crate::traversal::params::{LevelParams, bindings, index_width};
use reliefrtl_config::TraverseConfig;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `exit_plane`, combinational; `parity` adds the output that tevs and selective level-up ask for.
pub fn exit_plane(t: &TraverseConfig, parity: bool) -> Arc<Module> {
    let b = Builder::new("exit_plane", file!(), "the plane by which the ray can leave a node along one axis");
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    let level = b.input("level", &level_w, LEVELS, "0 .. LEVELS");
    let x = b.input("x", &idx, TEXELS, "any texel of the node");
    let minus = b.input("neg", 1, BIT, "the ray runs toward smaller coordinates");
    let plane = b.output("plane", &idx, TEXELS, "coordinate of the plane");
    let even = parity.then(|| b.output("even", 1, BIT, "the plane also bounds the parent node"));

    let keep = b.ones(&idx).shift_left(level).named("keep");
    let side = minus.mux(x & keep, x | !keep).named("side");
    let exit = (side + (!minus).zext(&idx)).named("exit");
    b.drive(plane, exit);
    if let Some(even) = even {
        // The least bit of the plane's index in nodes: what the paper's AND looks at.
        let in_nodes = exit.shift_right(level).named("plane_in_nodes");
        b.unused(in_nodes);
        b.drive(even, !in_nodes.bit(0));
    }
    b.finish(&bindings())
}
