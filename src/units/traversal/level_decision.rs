//! `level_decision`: hit, descend or cross; the node, level and parameter of the next iteration (PIDM-HW section 4.2).
use super::params::{LevelParams, bindings, index_width};
use crate::quantity::{BIT, LEVELS, Quantity, TEXELS};
use reliefrtl_config::{Design, Trim};
use reliefrtl_ir::{Binding, Builder, Expr, Module};
use std::sync::Arc;

/// A datapath's ray parameter, as `level_decision` passes it on.
pub struct TimeWord {
    /// Declares what its width follows from; returns width and unit.
    pub declare: fn(&Builder, &Design) -> (Expr, Quantity),
    /// Parameter values at which the module is verified besides those of every datapath.
    pub bindings: fn() -> Vec<Binding>,
}

/// Builds `level_decision`, combinational.
pub fn level_decision(d: &Design, time: &TimeWord) -> Arc<Module> {
    let t = &d.traverse;
    let b = Builder::new("level_decision", file!(), "hit, descend or cross: the next node, level and parameter");
    let (time_w, time_unit) = (time.declare)(&b, d);
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    let inside = b.input("is_inside", 1, BIT, "the node's height is met before the ray leaves");
    let x_first = b.input("x_first", 1, BIT, "it leaves by the u plane");
    let trims = d.mode.trim != Trim::None;
    let up = (!trims).then(|| b.input("up", 1, BIT, "a crossing goes one level up"));
    let level = b.input(
        "level",
        &level_w,
        LEVELS,
        if trims { "level of the node that was read" } else { "level of this node" },
    );
    let across = trims.then(|| b.input("level_across", &level_w, LEVELS, "level of a crossing"));
    let lod = d.mode.lod.then(|| b.input("lod", &level_w, LEVELS, "the level at which the ray ends"));
    let level_down = b.input("level_down", &level_w, LEVELS, "level of a descent");
    let m = b.input("m", &time_w, time_unit, "parameter of a hit or a descent");
    let t_next = b.input("t_next", &time_w, time_unit, "parameter of a crossing");
    let mut axes = Vec::new();
    for axis in ["x", "y"] {
        let at = b.input(&format!("{axis}_at"), &idx, TEXELS, "a texel of this node");
        let down = b.input(&format!("{axis}_down"), &idx, TEXELS, "texel of the child");
        let beyond = b.input(&format!("{axis}_beyond"), &idx, TEXELS, "first texel beyond the exit plane");
        axes.push((at, down, beyond));
    }
    let o_hit = b.output("hit", 1, BIT, "the ray ends here");
    let o_cross = b.output("crosses", 1, BIT, "the ray goes to the neighbour");
    let o_level = b.output("level_next", &level_w, LEVELS, "level of the next iteration");
    let o_x = b.output("x_next", &idx, TEXELS, "texel of the next node");
    let o_y = b.output("y_next", &idx, TEXELS, "texel of the next node");
    let o_t = b.output("t_out", &time_w, time_unit, "parameter of the next iteration, or of the hit");

    let finest = lod.map_or_else(|| level.none(), |lod| level.eq(lod));
    let hit = (inside & finest).named("is_hit");
    let risen = match (across, up) {
        (Some(across), _) => across,
        (None, Some(up)) => (level + up.zext(&level_w)).named("risen"),
        (None, None) => unreachable!("one of the two is an input"),
    };
    let next = inside.mux(hit.mux(level, level_down), risen).named("level_chosen");
    let keep_x = (!x_first).named("keep_x");
    let x = inside.mux(hit.mux(axes[0].0, axes[0].1), keep_x.mux(axes[0].0, axes[0].2)).named("x_chosen");
    let y = inside.mux(hit.mux(axes[1].0, axes[1].1), x_first.mux(axes[1].0, axes[1].2)).named("y_chosen");
    b.drive(o_hit, hit);
    b.drive(o_cross, !inside);
    b.drive(o_level, next);
    b.drive(o_x, x);
    b.drive(o_y, y);
    b.drive(o_t, inside.mux(m, t_next));
    let mut at = bindings();
    at.extend((time.bindings)());
    b.finish(&at)
}
