//! `finest_level`: the level at which a ray may end, and the level at which it starts, which is no finer (PDM section 3.4).
use super::params::{LevelParams, bindings};
use crate::quantity::LEVELS;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `finest_level`, combinational.
pub fn finest_level(d: &Design) -> Arc<Module> {
    let b = Builder::new("finest_level", file!(), "a ray's finest level, and its first one, which is no finer");
    let LevelParams { levels, level_w } = LevelParams::declare(&b, &d.traverse);
    // Four cells that are read at once have the root for their block at most.
    let (levels, most) = if d.fetch.blocks() { (levels - 1, "LEVELS - 1") } else { (levels, "LEVELS") };
    let asked = b.input("lod", &level_w, LEVELS, &format!("the finest level that was asked for; above {most}: {most}"));
    let start = b.input("start", &level_w, LEVELS, "the first level without that choice");
    let o_finest = b.output("finest", &level_w, LEVELS, "the finest level");
    let o_level = b.output("level", &level_w, LEVELS, "the first level");
    let root = b.konst(&levels, &level_w).named("root").doc("the root's level");
    // The sign of a difference: a comparison would be constant where LEVELS fills its word.
    let room = (root.zext(&level_w + 1) - asked.zext(&level_w + 1)).named("levels_above");
    b.unused(room.slice(0, &level_w));
    let finest = room.msb().mux(root, asked).named("finest_legal");
    let level = start.lt(finest).mux(finest, start).named("first_level");
    b.drive(o_finest, finest);
    b.drive(o_level, level);
    b.finish(&bindings())
}

/// What a setup says of the level that a ray brings.
pub(super) fn finest_doc(d: &Design) -> &'static str {
    if d.fetch.blocks() {
        "finest level; above LEVELS - 1 it is LEVELS - 1"
    } else {
        "finest level; above LEVELS it is LEVELS"
    }
}
