//! `multi_level_down`: the level and the child to descend into (PIDM-HW section 3.2).
//!
//! Until the first crossing the step is `levels_down` levels where that many are left, afterwards one.
use super::params::{LevelParams, bindings, index_width};
use crate::quantity::{BIT, LEVELS, TEXELS};
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// Builds `multi_level_down`.
pub fn multi_level_down(d: &Design) -> Arc<Module> {
    let (t, mode, registered) = (&d.traverse, &d.mode, d.latency.has(Register::Descent));
    let what = match mode.levels_down {
        1 => "level and child of a descent by one level".to_string(),
        n => format!("level and child of a descent: {n} levels until the first crossing, then one"),
    };
    let b = Builder::new("multi_level_down", file!(), &what);
    b.choice("levels_down", mode.levels_down);
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    let many = u64::from(mode.levels_down);
    if registered {
        b.clock();
        b.clock_enable();
    }
    let level = b.input("level", &level_w, LEVELS, "1 .. LEVELS (the result is not used at 0)");
    let crossed = (many > 1).then(|| b.input("crossed", 1, BIT, "the ray has crossed a node boundary already"));
    let lod = mode.lod.then(|| b.input("lod", &level_w, LEVELS, "the finest level to go to"));
    let mut axes = Vec::new();
    for axis in ["x", "y"] {
        let low = b.input(&format!("{axis}_low"), &idx, TEXELS, "least texel of the node that the ray has not passed");
        let high =
            b.input(&format!("{axis}_high"), &idx, TEXELS, "greatest texel of the node that the ray has not passed");
        let e = b.input(&format!("{axis}_hit"), &idx, TEXELS, "predicted hit");
        axes.push((axis, low, high, e));
    }
    let out = b.output("level_down", &level_w, LEVELS, "level after the descent");
    let outs: Vec<usize> = axes
        .iter()
        .map(|a| b.output(&format!("{}_down", a.0), &idx, TEXELS, "predicted hit, kept between low and high"))
        .collect();

    let one = b.lit(1, &level_w);
    let next = match crossed {
        None => level - one,
        Some(crossed) => {
            // LEVELS may be less than levels_down at other parameter values, so the count is compared, not assumed.
            let count = b.lit(many, level_w.clone() + 3).named("count");
            let wide = level.zext(level_w.clone() + 3);
            let jump = ((!crossed) & !wide.lt(count)).named("jump");
            let few = (wide - count).named("jumped");
            b.unused(few.slice(level_w.clone(), 3));
            jump.mux(few.slice(0, &level_w), level - one)
        }
    };
    let next = lod.map_or(next, |lod| {
        let next = next.named("next_free");
        next.lt(lod).mux(lod, next)
    });
    b.drive(out, next.named("next_level"));
    for ((axis, low, high, e), out) in axes.into_iter().zip(outs) {
        b.drive(out, clamp(e, low, high, axis, registered));
    }
    b.finish(&bindings())
}

/// Estimate `e`, kept between two texels; with `cut` a register stands after the comparisons.
pub(super) fn clamp<'b>(e: Sig<'b>, low: Sig<'b>, high: Sig<'b>, axis: &str, registered: bool) -> Sig<'b> {
    let below = e.slt(low).named(&format!("{axis}_is_below")).reg_if(registered);
    let above = high.slt(e).named(&format!("{axis}_is_above")).reg_if(registered);
    below.mux(low, above.mux(high, e)).named(&format!("{axis}_child"))
}
