//! `cell_choice`: the first of four cells in which the ray meets a height, or else the one out of which it leaves the block (`docs/cells.md`).
//!
//! Cells are named by the half along x, then along y: n is the near one, f the far one, seen along the ray. Those that the ray is in for a while lie
//! on different diagonals, so the first hit needs no sorting. Of parameters it sees the order alone, and passes two on.
use crate::quantity::{BIT, CODES};
use crate::traversal::level_decision::TimeWord;
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Binding, Builder, Module, Sig};
use std::sync::Arc;

/// Comparisons of two parameters: the ray's own (`t`), and those of the middle (`mid`) and the exit planes (`far`) along x and y. Each is the net
/// of "the first is less than the second".
pub const ORDER: [(&str, &str, &str); 12] = [
    ("t_lt_mid_x", "t", "mid_x"),
    ("t_lt_mid_y", "t", "mid_y"),
    ("t_lt_far_x", "t", "far_x"),
    ("t_lt_far_y", "t", "far_y"),
    ("mid_x_lt_mid_y", "mid_x", "mid_y"),
    ("mid_y_lt_mid_x", "mid_y", "mid_x"),
    ("mid_x_lt_far_x", "mid_x", "far_x"),
    ("mid_y_lt_far_y", "mid_y", "far_y"),
    ("mid_x_lt_far_y", "mid_x", "far_y"),
    ("mid_y_lt_far_x", "mid_y", "far_x"),
    ("far_y_lt_far_x", "far_y", "far_x"),
    ("far_y_lt_mid_x", "far_y", "mid_x"),
];

/// The cells in the order of their words in memory: the upper half along x, then along y.
pub const CELLS: [&str; 4] = ["height_0", "height_1", "height_2", "height_3"];

/// Builds `cell_choice`.
pub fn cell_choice(d: &Design, time: &TimeWord) -> Arc<Module> {
    let registered = d.latency.has(Register::Parameter);
    let b = Builder::new("cell_choice", file!(), "the cell of a block that a ray hits, or out of which it leaves");
    let (time_w, unit) = (time.declare)(&b, d);
    let h = b.param("HEIGHT_W", d.traverse.height_bits, "bits of a height code");
    b.require(2, &h);
    b.require(&h, 16);
    if registered {
        b.clock();
        b.clock_enable();
    }
    let mut order = Vec::new();
    for (name, first, second) in ORDER {
        order.push((name, b.input(name, 1, BIT, &format!("{first} is less than {second}"))));
    }
    let order = Order(order);
    let less = |name: &str| order.less(name);
    let flag = |name: &str, doc: &str| b.input(name, 1, BIT, doc);
    let past = ["x", "y"].map(|a| flag(&format!("past_{a}"), "the ray is in the far half already"));
    let neg = ["x", "y"].map(|a| flag(&format!("neg_{a}"), "the ray runs toward smaller coordinates"));
    let limit = |name: &str| b.input(name, &h + 1, CODES, "depths below it are met before that plane");
    let [mid, far] = ["mid", "far"].map(|p| ["x", "y"].map(|a| limit(&format!("limit_{p}_{a}"))));
    let heights = CELLS.map(|name| b.input(name, &h, CODES, "largest height in that cell"));
    let parameter = |name: &str, doc: &str| b.input(name, &time_w, unit, doc);
    let t = parameter("t", "parameter so far");
    let t_mid = ["x", "y"].map(|a| parameter(&format!("mid_{a}"), "parameter of the middle plane"));
    let t_far = ["x", "y"].map(|a| parameter(&format!("far_{a}"), "parameter of the exit plane"));
    let o_inside = b.output("is_inside", 1, BIT, "a height is met before the ray leaves its cell");
    let o_half = ["x", "y"].map(|a| b.output(&format!("is_far_{a}"), 1, BIT, "the cell is in the far half"));
    let o_first = b.output("x_first", 1, BIT, "the ray leaves the block by the x plane, also if both come at once");
    let o_height = b.output("height", &h, CODES, "that cell's height");
    let o_enters = b.output("enters", &time_w, unit, "parameter at which the ray enters that cell, at least t");
    let o_next = b.output("t_next", &time_w, unit, "parameter after a crossing, at least t");

    b.section(
        "cells on the way",
        "A cell that the ray is in for a while: each plane of its entry comes before each of its exit. Letters name a cell by its half, near or far, along x and then along y: nn, fn, nf, ff.",
    );
    let [past_x, past_y] = past;
    let on_way = order.on_way(past);

    b.section("heights", "In the order of the memory: the lower half along an axis is the near one, or the far one.");
    let met = met(heights, [mid, far], neg);
    let names = ["hit_nn", "hit_fn", "hit_nf", "hit_ff"];
    let hits: Vec<Sig<'_>> = (0..4).map(|k| (on_way[k] & met[k]).named(names[k])).collect();

    b.section("choice", "The first diagonal with a hit; without one, the cell at which the ray leaves.");
    let inside = (hits[0] | hits[1] | hits[2] | hits[3]).named("is_hit");
    let x_first = (!less("far_y_lt_far_x")).named("x_exits_first");
    let last_x = (x_first | past_x | !less("far_y_lt_mid_x")).named("last_far_x");
    let last_y = (!x_first | past_y | less("mid_y_lt_far_x")).named("last_far_y");
    let hit_x = !hits[0] & (hits[1] | !hits[2]);
    let hit_y = !hits[0] & !hits[1];
    let far_x = inside.mux(hit_x, last_x).named("far_x_chosen");
    let far_y = inside.mux(hit_y, last_y).named("far_y_chosen");

    b.section("entry", "The latest of the ray's own parameter and those of the middle planes that it has to pass.");
    let from_x = (far_x & !past_x & less("t_lt_mid_x")).named("enters_by_x");
    let from_y = (far_y & !past_y & from_x.mux(less("mid_x_lt_mid_y"), less("t_lt_mid_y"))).named("enters_by_y");
    let grows = x_first.mux(less("t_lt_far_x"), less("t_lt_far_y")).named("t_advances");
    let place = [(far_x ^ neg[0]).named("upper_x"), (far_y ^ neg[1]).named("upper_y")];

    // A register between the choice and what is chosen.
    let [h0, h1, h2, h3] = heights.map(|v| v.reg_if(registered));
    let [upper_x, upper_y] = place.map(|v| v.reg_if(registered));
    let ([mid_x, mid_y], [far_x_t, far_y_t]) =
        (t_mid.map(|v| v.reg_if(registered)), t_far.map(|v| v.reg_if(registered)));
    let t = t.reg_if(registered);
    let height = upper_y.mux(upper_x.mux(h3, h2), upper_x.mux(h1, h0)).named("height_chosen");
    let by_x = from_x.reg_if(registered).mux(mid_x, t).named("enters_x");
    let enters = from_y.reg_if(registered).mux(mid_y, by_x).named("enters_cell");
    let exit = x_first.reg_if(registered).mux(far_x_t, far_y_t).named("t_exit");
    let next = grows.reg_if(registered).mux(exit, t).named("t_after");
    b.drive(o_inside, inside);
    o_half.into_iter().zip([far_x, far_y]).for_each(|(o, v)| b.drive(o, v));
    b.drive(o_first, x_first);
    b.drive(o_height, height);
    b.drive(o_enters, enters);
    b.drive(o_next, next);
    let heights = [2, 16].map(|h| Binding::from([("HEIGHT_W".to_string(), h)]));
    let mut at = heights.to_vec();
    at.extend((time.bindings)());
    b.finish(&at)
}

/// What holds of the near half and of the far one, seen along the ray, of what holds of the lower and of the upper one.
fn near_far<'b>(low: Sig<'b>, high: Sig<'b>, minus: Sig<'b>) -> [Sig<'b>; 2] {
    [minus.mux(high, low), minus.mux(low, high)]
}

/// The comparisons, by their names.
struct Order<'b>(Vec<(&'static str, Sig<'b>)>);

impl<'b> Order<'b> {
    fn less(&self, name: &str) -> Sig<'b> {
        self.0.iter().find(|o| o.0 == name).expect("a comparison").1
    }

    /// Whether the ray is in a cell for a while: of nn, fn, nf and ff.
    fn on_way(&self, [past_x, past_y]: [Sig<'b>; 2]) -> [Sig<'b>; 4] {
        let less = |name: &str| self.less(name);
        let before_x = (past_x | less("mid_x_lt_far_x")).named("x_halves_differ");
        let before_y = (past_y | less("mid_y_lt_far_y")).named("y_halves_differ");
        [
            !past_x & !past_y & less("t_lt_mid_x") & less("t_lt_mid_y"),
            !past_y & less("t_lt_far_x") & less("t_lt_mid_y") & (past_x | less("mid_x_lt_mid_y")) & before_x,
            !past_x & less("t_lt_mid_x") & less("t_lt_far_y") & (past_y | less("mid_y_lt_mid_x")) & before_y,
            less("t_lt_far_x")
                & less("t_lt_far_y")
                & before_x
                & before_y
                & (past_x | less("mid_x_lt_far_y"))
                & (past_y | less("mid_y_lt_far_x")),
        ]
    }
}

/// Whether the height of a cell is met before the planes of its exit: of nn, fn, nf and ff, along the ray. `limits`: of the middle planes, and of the
/// exit planes.
fn met<'b>(heights: [Sig<'b>; 4], limits: [[Sig<'b>; 2]; 2], neg: [Sig<'b>; 2]) -> [Sig<'b>; 4] {
    let [mid, far] = limits;
    let halves = [0, 1].map(|k| {
        let axis = ["x", "y"][k];
        let low = neg[k].mux(far[k], mid[k]).named(&format!("{axis}_limit_low"));
        [low, neg[k].mux(mid[k], far[k]).named(&format!("{axis}_limit_high"))]
    });
    let met = [0, 1, 2, 3].map(|cell| {
        let limit: [Sig<'b>; 2] = [halves[0][cell % 2], halves[1][cell / 2]];
        let depth = (!heights[cell]).zext(limit[0].width()).named(&format!("depth_{cell}"));
        (depth.lt(limit[0]) & depth.lt(limit[1])).named(&format!("is_met_{cell}"))
    });
    // The bits of the place in memory turn where the ray runs toward smaller coordinates.
    let [near_0, far_0] = near_far(met[0], met[1], neg[0]);
    let [near_1, far_1] = near_far(met[2], met[3], neg[0]);
    let ([nn, nf], [fn_, ff]) = (near_far(near_0, near_1, neg[1]), near_far(far_0, far_1, neg[1]));
    [nn, fn_, nf, ff]
}
