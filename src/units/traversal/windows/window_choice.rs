//! `window_choice`: hit, or how far the windows are empty: the exit of the largest window that can't hold the hit, and the depth of the next one.
use super::params::{CELL_W, SPAN_W, Widths, bindings, set_word};
use crate::quantity::{BIT, CODES, TEXELS};
use crate::traversal::fixed::params::TIME;
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// What one size brings.
struct Channel<'b> {
    exit: Sig<'b>,
    x_first: Sig<'b>,
    fraction: Sig<'b>,
    is_in: Sig<'b>,
    depth: Sig<'b>,
}

/// Builds `window_choice`.
pub fn window_choice(d: &Design) -> Arc<Module> {
    let b = Builder::new("window_choice", file!(), "which windows are empty, and what they say of the way ahead");
    let set = d.window_set();
    b.choice("windows", set_word(&set));
    let widths = Widths::new(&b, d);
    let h = widths.of.height(&widths.f);
    let time = widths.time();
    b.clock();
    b.clock_enable();
    let stays = b.input("stays", 1, BIT, "a finished ray: it moves no more");
    let open = b.input("is_open", 1, BIT, "the texel's exit lies after t");
    let borders = ["x", "y"].map(|a| {
        b.input(&format!("border_{a}"), CELL_W, TEXELS, "texels up to the border of the coarsest grid's cell")
    });
    let channel = |c: usize| {
        let bit = |n: &str, doc: &str| b.input(&format!("{n}_{c}"), 1, BIT, doc);
        Channel {
            exit: b.input(&format!("exit_{c}"), &time, TIME, "where the ray leaves the window"),
            x_first: bit("x_first", "by the plane of u"),
            fraction: bit("fraction", "the exit is no whole height code"),
            is_in: bit("is_in", "the window can hold the hit, and so can all larger ones"),
            depth: b.input(&format!("depth_{c}"), &h, CODES, "of its highest code"),
        }
    };
    b.at_least(u32::from(d.latency.has(Register::WindowChoice)));
    let list: Vec<Channel<'_>> = (0..set.sizes().len()).map(channel).collect();
    let o_hit = b.output("hit", 1, BIT, "the ray ends in this texel");
    let o_exit = b.output("exit", &time, TIME, "exit of the largest empty window");
    let o_first = b.output("x_first", 1, BIT, "by the plane of u");
    let o_fraction = b.output("fraction", 1, BIT, "the exit is no whole height code");
    let o_depth = b.output("depth", &h, CODES, "of a hit, or of the next larger window");
    let o_takes_exit = b.output("takes_exit", 1, BIT, "the exit counts: the ray is there at least");
    let o_takes_depth = b.output("takes_depth", 1, BIT, "the depth counts: the ray is there at least");
    let o_crosses = b.output("crosses", 1, BIT, "the ray goes beyond the exit");
    let o_past =
        ["x", "y"].map(|a| b.output(&format!("past_{a}"), SPAN_W, TEXELS, "texels of the window beyond this one"));

    b.section("largest empty window", "One-hot; of none it is the texel itself.");
    let last = list.len() - 1;
    let mut above: Option<Sig<'_>> = None;
    let mut picks = vec![];
    for (c, one) in list.iter().enumerate().rev() {
        let pick = match (c, above) {
            (0, above) => above.expect("two sizes or more"),
            (_, None) => !one.is_in,
            (_, Some(above)) => !one.is_in & above,
        };
        picks.push(pick.named(&format!("picks_{c}")).id());
        if c > 0 {
            above = Some(above.map_or(one.is_in, |a| a & one.is_in).named(&format!("all_in_from_{c}")));
        }
    }
    picks.reverse();
    let picks: Vec<Sig<'_>> = picks.into_iter().map(|id| b.sig(id)).collect();
    let exit = picked(&picks, "exit_chosen", |c| Some(list[c].exit));
    let x_first = picked(&picks, "x_first_chosen", |c| Some(list[c].x_first));
    let fraction = picked(&picks, "fraction_chosen", |c| Some(list[c].fraction));
    let next_depth = picked(&picks, "next_depth", |c| list.get(c + 1).map(|next| next.depth));
    b.section("hit", "");
    let inside = list[0].is_in;
    let goes = (!stays).named("is_active");
    let ends = (inside & open).named("ends");
    let hit = (ends & goes).named("is_hit");
    b.drive(o_hit, hit);
    b.drive(o_exit, exit);
    b.drive(o_first, x_first);
    b.drive(o_fraction, fraction);
    b.drive(o_depth, inside.mux(list[0].depth, next_depth).named("depth_chosen"));
    b.drive(o_takes_exit, (!inside & goes).named("exit_counts"));
    b.drive(o_takes_depth, (hit | (!inside & list[last].is_in & goes)).named("depth_counts"));
    b.drive(o_crosses, (goes & !ends).named("continues"));
    b.section("texels", "");
    for ((a, border), out) in ["x", "y"].into_iter().zip(borders).zip(o_past) {
        let past = picked(&picks, &format!("{a}_past"), |c| {
            let w = set.sizes()[c];
            // The texels in the cell and those ahead of it have no bit in common: "or" is their sum.
            let in_cell = || (border & b.lit(u64::from(w.grid - 1), CELL_W)).zext(SPAN_W);
            let ahead = || b.lit(u64::from(w.ahead()), SPAN_W);
            match (w.grid, w.ahead()) {
                (1, 0) => None,
                (1, _) => Some(ahead()),
                _ => Some(in_cell() | ahead()),
            }
        });
        b.drive(out, past);
        if set.sizes().iter().all(|w| w.grid == 1) {
            b.unused(border);
        }
    }
    b.finish(&bindings())
}

/// What the size picked one-hot has; sizes that have nothing give 0.
fn picked<'b>(picks: &[Sig<'b>], name: &str, of: impl Fn(usize) -> Option<Sig<'b>>) -> Sig<'b> {
    let terms = picks.iter().enumerate().filter_map(|(c, pick)| Some((pick, of(c)?)));
    let words =
        terms.map(|(pick, v)| if v.width().as_const() == Some(1) { *pick & v } else { pick.rep(v.width()) & v });
    words.reduce(|a, v| a | v).expect("two sizes or more").named(name)
}
