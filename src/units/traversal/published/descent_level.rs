//! `descent_level`: the level of a descent (PIDM-HW section 3.2, MLD test): until the first crossing `levels_down` levels
//! where that many are left, afterwards one. The child follows from the position.
use crate::quantity::{BIT, LEVELS};
use crate::traversal::params::{LevelParams, bindings};
use reliefrtl_config::{ModeConfig, TraverseConfig};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `descent_level`, combinational.
pub fn descent_level(t: &TraverseConfig, mode: &ModeConfig) -> Arc<Module> {
    let what = match mode.levels_down {
        1 => "level of a descent by one level".to_string(),
        n => format!("level of a descent: {n} levels down until the first crossing, then one"),
    };
    let b = Builder::new("descent_level", file!(), &what);
    let LevelParams { level_w, .. } = LevelParams::declare(&b, t);
    let many = u64::from(mode.levels_down);
    let level = b.input("level", &level_w, LEVELS, "1 .. LEVELS (the result is not used at 0)");
    let crossed = (many > 1).then(|| b.input("crossed", 1, BIT, "the ray has crossed a node boundary already"));
    let out = b.output("level_down", &level_w, LEVELS, "level after the descent");
    let by_one = level - b.lit(1, &level_w);
    let next = match crossed {
        None => by_one,
        Some(crossed) => {
            // LEVELS may be less than levels_down at other parameter values, so the count is compared, not assumed.
            let count = b.lit(many, level_w.clone() + 3).named("count");
            let wide = level.zext(level_w.clone() + 3);
            let jump = ((!crossed) & !wide.lt(count)).named("jump");
            let few = (wide - count).named("jumped");
            b.unused(few.slice(level_w.clone(), 3));
            jump.mux(few.slice(0, &level_w), by_one)
        }
    };
    b.drive(out, next.named("next_level"));
    b.finish(&bindings())
}
