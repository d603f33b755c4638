//! The stages between plane parameters and height memory that a chord trim adds to an iteration.
use super::chord_trim::chord_trim;
use super::loop_state::{Ray, Sizes};
use super::plane_units::{Pair, PlaneUnits};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Sig};

/// The level of the node to be read instead of the ray's own; `bounds` are least and greatest texel of a descent, `times` the parameters of the
/// exit planes, each u first.
pub(super) fn trim<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    units: &PlaneUnits,
    bounds: [Pair<'b>; 2],
    times: Pair<'b>,
) -> Sig<'b> {
    let idx = [("IDX_W", s.idx.clone())];
    b.section(
        "chord",
        "Where the ray is when it leaves by the other axis' plane; which of the two it is, is known meanwhile.",
    );
    let bound = |axis: &str, t: Sig<'b>| {
        let ins = [ray.constants(axis, units.chord_inputs), vec![("t", t)]].concat();
        b.inst(&(units.chord_end)(d), &format!("u_chord_end_{axis}"), &idx, &ins)
            .only()
            .named(&format!("{axis}_bound"))
            .id()
    };
    let ends = [b.sig(bound("x", times[1])), b.sig(bound("y", times[0]))];
    let y_first = (units.leaves_y)(b, d, times).named("exits_y");

    b.section("trim", "The smallest node that holds this texel and the chord's end.");
    let mut ins = vec![("level", ray.get("level")), ("x_first", (!y_first).named("exits_x"))];
    ins.extend(ray.find("descended").map(|v| ("descended", v)));
    ins.extend(ray.find("lod").map(|v| ("lod", v)));
    let [[x_low, x_high], [y_low, y_high]] = bounds;
    ins.extend([("x_at", ray.get("x")), ("x_low", x_low), ("x_high", x_high), ("x_neg", ray.get("neg_x"))]);
    ins.extend([("x_bound", ends[0]), ("x_last", ray.get("le_x"))]);
    ins.extend([("y_at", ray.get("y")), ("y_low", y_low), ("y_high", y_high), ("y_neg", ray.get("neg_y"))]);
    ins.extend([("y_bound", ends[1]), ("y_last", ray.get("le_y"))]);
    let o = b.inst(&chord_trim(d), "u_trim", &idx, &ins);
    b.unused(o["x_chord"].named("x_chord"));
    b.unused(o["y_chord"].named("y_chord"));
    // A stage of its own: leading zeros and memory address are one long path else.
    o["level_read"].named("level_read").reg()
}
