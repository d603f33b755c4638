//! `height_address`: where a node's height stands in the pyramid memory.
//!
//! The address of node (i, j) of level k is base(k) | morton(i, j): the base has its ones above the bits that the
//! index uses, so levels lie without gaps and no adder is needed (`docs/datapath.md`, "The pyramid in memory").
use super::params::{LevelParams, bindings};
use crate::interleave::interleave;
use crate::quantity::{LEVELS, TEXELS, WORDS};
use reliefrtl_config::TraverseConfig;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `height_address`, combinational.
pub fn height_address(t: &TraverseConfig) -> Arc<Module> {
    let b = Builder::new("height_address", file!(), "address of a node's height in the pyramid memory");
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let level = b.input("level", &level_w, LEVELS, "0 .. LEVELS");
    let i = b.input("i", &levels, TEXELS, "u of a texel in the node");
    let j = b.input("j", &levels, TEXELS, "v of a texel in the node");
    let out = b.output("address", levels.clone() * 2 + 1, WORDS, "level 0 first, the root last");

    let root = b.konst(&levels, &level_w).named("root").doc("the root's level");
    let bits = (root - level).named("index_bits");
    let base = b.cat(&[b.ones(&levels).shift_left(bits), b.zeros(1)]).named("base");
    let even = (b.cat(&[b.zeros(1), i.shift_right(level)]) | base).named("even");
    let odd = b.cat(&[b.zeros(1), j.shift_right(level)]).named("odd");
    let morton = interleave(&b, "u_morton", even, odd, "morton");
    b.unused(morton.msb());
    b.drive(out, morton.slice(0, levels * 2 + 1));
    b.finish(&bindings())
}
