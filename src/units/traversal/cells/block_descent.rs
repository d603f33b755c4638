//! `block_descent`: the level and the texel of a descent from one of four cells: some levels until the first crossing, others after it.
use crate::quantity::{BIT, LEVELS, TEXELS};
use crate::traversal::multi_level_down::clamp;
use crate::traversal::params::{LevelParams, bindings, index_width};
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Whether it asks if something was crossed.
pub fn reads_crossed(d: &Design) -> bool {
    d.mode.levels_down != d.levels_down_after()
}

/// Builds `block_descent`.
pub fn block_descent(d: &Design) -> Arc<Module> {
    let (t, registered) = (&d.traverse, d.latency.has(Register::Descent));
    let (before, after) = (d.mode.levels_down, d.levels_down_after());
    let b = Builder::new(
        "block_descent",
        file!(),
        &format!("level and texel of a descent: by {before} until the first crossing, then by {after}"),
    );
    b.choice("levels_down", before);
    b.choice("levels_down_after", after);
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    if registered {
        b.clock();
        b.clock_enable();
    }
    let level = b.input("level", &level_w, LEVELS, "level of the cell, 0 .. LEVELS - 1 (the result is not used at 0)");
    let crossed = reads_crossed(d).then(|| b.input("crossed", 1, BIT, "the ray has crossed a boundary already"));
    let lod = d.mode.lod.then(|| b.input("lod", &level_w, LEVELS, "the finest level to go to"));
    let mut axes = Vec::new();
    for axis in ["x", "y"] {
        let of = |what: &str, doc: &str| b.input(&format!("{axis}_{what}"), &idx, TEXELS, doc);
        let low = of("low", "least texel of the cell that the ray has not passed");
        let high = of("high", "greatest texel of the cell that the ray has not passed");
        axes.push((axis, low, high, of("hit", "predicted hit")));
    }
    let out = b.output("level_down", &level_w, LEVELS, "level after the descent");
    let outs: Vec<usize> = axes
        .iter()
        .map(|a| b.output(&format!("{}_down", a.0), &idx, TEXELS, "predicted hit, kept between the two"))
        .collect();

    let levels_of = |n: u32| b.lit(u64::from(n), &level_w);
    let count = match crossed {
        Some(crossed) => crossed.mux(levels_of(after), levels_of(before)).named("count"),
        None => levels_of(before).named("count"),
    };
    // The sign of the difference: there may be fewer levels left.
    let wide = level.zext(&level_w + 1) - count.zext(&level_w + 1);
    let wide = wide.named("difference");
    let next = (wide.slice(0, &level_w) & (!wide.msb()).rep(&level_w)).named("next_free");
    let next = lod.map_or(next, |lod| next.lt(lod).mux(lod, next).named("next_level"));
    b.drive(out, next);
    for ((axis, low, high, e), out) in axes.into_iter().zip(outs) {
        b.drive(out, clamp(e, low, high, axis, registered));
    }
    b.finish(&bindings())
}
