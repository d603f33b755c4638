//! `trim_return`: the level after a crossing, where the node that was read may have been a trimmed one.
//!
//! A trimmed node has the exit of the untrimmed one, so the crossing leaves both and the ray goes on at the untrimmed level; but where selective
//! level-up sees the predicted hit in a neighbour of the trimmed node, it stays at that node's level.
use super::params::{LevelParams, bindings};
use crate::quantity::{BIT, LEVELS};
use reliefrtl_config::{Design, LevelUp};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `trim_return`, combinational; for every rule but the one that never ascends, whose crossings stay at the untrimmed level.
pub fn trim_return(d: &Design) -> Arc<Module> {
    let b = Builder::new("trim_return", file!(), "level after a crossing: up, or back to what it was before a trim");
    let LevelParams { level_w, .. } = LevelParams::declare(&b, &d.traverse);
    let level = b.input("level", &level_w, LEVELS, "level of the node before it was trimmed");
    let read = b.input("level_read", &level_w, LEVELS, "level of the node that was read; never above it");
    let doc = match d.mode.level_up {
        LevelUp::Selective => "one level up; of a trimmed node: it may return",
        _ => "one level up; of a trimmed node: of no meaning",
    };
    let up = b.input("up", 1, BIT, doc);
    let out = b.output("level_across", &level_w, LEVELS, "level after the crossing");
    let grown = b.output("grown", 1, BIT, "one level above the untrimmed one");

    let trimmed = read.lt(level).named("is_trimmed");
    let grows = (up & !trimmed).named("ascends");
    let risen = (level + grows.zext(&level_w)).named("risen");
    let across = match d.mode.level_up {
        LevelUp::Selective => (trimmed & !up).named("stays").mux(read, risen).named("across"),
        _ => risen,
    };
    b.drive(out, across);
    b.drive(grown, grows);
    b.finish(&bindings())
}
