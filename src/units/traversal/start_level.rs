//! `start_level`: the lowest pyramid level at which one node holds both ends of the ray (PIDM-HW section 3.1).
//!
//! XOR of the texel coordinates, then the position of the topmost 1. The paper takes the maximum of the two axes'
//! XORs before counting; their OR has the same topmost 1 and needs no comparator.
use super::params::{LevelParams, bindings, index_width};
use crate::lzc::lzc;
use crate::quantity::{LEVELS, TEXELS};
use reliefrtl_config::TraverseConfig;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `start_level`, combinational.
pub fn start_level(t: &TraverseConfig) -> Arc<Module> {
    let b = Builder::new("start_level", file!(), "lowest level at which one node holds both ends of the ray");
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    let x = b.input("x", &idx, TEXELS, "u of the entry");
    let y = b.input("y", &idx, TEXELS, "v of the entry");
    let x_end = b.input("x_end", &idx, TEXELS, "u of the exit");
    let y_end = b.input("y_end", &idx, TEXELS, "v of the exit");
    let out = b.output("level", &level_w, LEVELS, "0: both in one texel; LEVELS: the root (also across tiles)");

    let differ = ((x ^ x_end) | (y ^ y_end)).named("differ");
    let other_tile = differ.slice(levels.clone(), &idx - &levels).any().named("other_tile");
    let inside = differ.slice(0, levels.clone()).named("low_part");
    let count = lzc(&b, "u_lzc", inside, "lz_count");
    let root = b.konst(&levels, &level_w).named("root").doc("the root's level");
    let level = other_tile.mux(root, root - count).named("start");
    b.drive(out, level);
    b.finish(&bindings())
}
