//! What a crossing does to the level of a ray.
use super::level_up::level_up;
use super::loop_state::{Ray, Sizes};
use super::trim_return::trim_return;
use reliefrtl_config::{Design, LevelUp, Trim};
use reliefrtl_ir::{Builder, Sig};

/// What a crossing does to the level: the operand of `level_decision` by its port name, and, where that is counted, whether the level rises (1 bit). `at` and `predicted` are
/// the ray's texel and the predicted one, `even` says whether the crossed plane bounds the parent.
pub(super) fn climb<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    read: Sig<'b>,
    even: &dyn Fn() -> Sig<'b>,
    [at, predicted]: [[Sig<'b>; 2]; 2],
) -> ((&'static str, Sig<'b>), Option<Sig<'b>>) {
    b.section("level up", "");
    let counts = d.gives_crossings();
    if d.mode.trim != Trim::None && d.mode.level_up == LevelUp::None {
        return (("level_across", ray.get("level")), counts.then(|| b.zeros(1)));
    }
    let up = match level_up(d) {
        None => b.zeros(1),
        Some(unit) => {
            let mut ins = vec![("level", read)];
            match d.mode.level_up {
                LevelUp::Coherent => ins.extend(ray.find("prev").map(|p| ("prev_crossed", p))),
                LevelUp::Tevs => ins.push(("even", even())),
                LevelUp::Selective => {
                    // The plane of a trimmed node bounds larger ones too.
                    let leaves = match d.mode.trim {
                        Trim::None => even(),
                        Trim::Descent | Trim::Always => {
                            (even() | read.lt(ray.get("level")).named("is_trimmed")).named("exits_parent")
                        }
                    };
                    ins.push(("even", leaves));
                    ins.extend([("x_at", at[0]), ("x_hit", predicted[0]), ("y_at", at[1]), ("y_hit", predicted[1])]);
                }
                LevelUp::None | LevelUp::Always => {}
            }
            let params = if d.mode.level_up == LevelUp::Selective { vec![("IDX_W", s.idx.clone())] } else { vec![] };
            b.inst(&unit, "u_up", &params, &ins).only().named("up")
        }
    };

    if d.mode.trim == Trim::None {
        return (("up", up), counts.then_some(up));
    }
    let ins = [("level", ray.get("level")), ("level_read", read), ("up", up)];
    let o = b.inst(&trim_return(d), "u_return", &[], &ins);
    let grown = o["grown"].named("grown");
    if !counts {
        b.unused(grown);
    }
    (("level_across", o["level_across"].named("level_across")), counts.then_some(grown))
}
