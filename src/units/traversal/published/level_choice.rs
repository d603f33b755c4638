//! `level_choice`: hit, descend or cross; the level, position and parameter of the next iteration (PIDM-HW section 4.2,
//! level decision). The texel follows by address conversion.
use crate::float::{FormatParams, bindings as formats};
use crate::quantity::{BIT, LEVELS, float};
use crate::traversal::params::{LevelParams, bindings};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `level_choice`, combinational; with a start level it has the input that picks the ray's end.
pub fn level_choice(d: &Design) -> Arc<Module> {
    let b = Builder::new("level_choice", file!(), "hit, descend or cross: the next level, position and parameter");
    let f = FormatParams::declare(&b, d.format);
    let LevelParams { level_w, .. } = LevelParams::declare(&b, &d.traverse);
    let crossing = b.input("exits", 1, BIT, "the predicted hit is in another node");
    let first = d.mode.start_level.then(|| b.input("first", 1, BIT, "mode 1: the hit position is the ray's end"));
    let up = b.input("up", 1, BIT, "a crossing goes one level up");
    let level = b.input("level", &level_w, LEVELS, "level of this node");
    let down = b.input("level_down", &level_w, LEVELS, "level of a descent");
    let m = b.input("m", &f.width, float("height range"), "parameter of a hit or a descent");
    let t_next = b.input("t_next", &f.width, float("height range"), "parameter of a crossing");
    let mut axes = Vec::new();
    for axis in ["x", "y"] {
        let hit = b.input(&format!("{axis}_hit"), &f.width, float("texels"), "hit position");
        let cross = b.input(&format!("{axis}_cross"), &f.width, float("texels"), "node-crossing position");
        axes.push((axis, hit, cross));
    }
    let o_hit = b.output("hit", 1, BIT, "the ray ends here");
    let o_cross = b.output("crosses", 1, BIT, "the ray goes to the neighbour");
    let o_level = b.output("level_next", &level_w, LEVELS, "level of the next iteration");
    let o_axes = ["x", "y"].map(|a| b.output(&format!("{a}_next"), &f.width, float("texels"), "where it goes on"));
    let o_t = b.output("t_out", &f.width, float("height range"), "parameter of the next iteration, or of the hit");

    let crosses = first.map_or(crossing, |f| (crossing & !f).named("is_crossing"));
    let hit = (!crosses & level.none()).named("is_hit");
    let risen = (level + up.zext(&level_w)).named("risen");
    b.drive(o_hit, hit);
    b.drive(o_cross, crosses);
    b.drive(o_level, crosses.mux(risen, hit.mux(level, down)).named("level_chosen"));
    for ((axis, hit, cross), out) in axes.into_iter().zip(o_axes) {
        b.drive(out, crosses.mux(cross, hit).named(&format!("{axis}_chosen")));
    }
    b.drive(o_t, crosses.mux(t_next, m).named("t_chosen"));
    let mut at = bindings();
    at.extend(formats());
    b.finish(&at)
}
