//! `window_span`: from the plane ahead of the texel to that beyond the window: the texels beyond this one times Q, without a multiplier.
//!
//! S - g and the texels up to the border of the grid's cell have no bit in common, so their sum is their bits together.
use super::params::{CELL_W, FINE, SPAN_W, Widths, bindings};
use crate::quantity::TEXELS;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Builds `window_span` (parameter AHEAD beside the map's).
pub fn window_span(d: &Design) -> Arc<Module> {
    let b = Builder::new("window_span", file!(), "steps from the plane ahead to the one that ends a window, times Q");
    let w = d.window_set().sizes()[1];
    let p = Widths::new(&b, d).planes();
    let ahead = b.param("AHEAD", w.ahead(), "texels of the window beyond the grid's cell");
    b.require(&ahead, 63);
    b.clock();
    b.clock_enable();
    let q = b.input("q", &p.plane, FINE, "parameter from plane to plane");
    let border = b.input("border", CELL_W, TEXELS, "texels up to the border of the grid's cell; no bit of AHEAD");
    let wide = &p.plane + SPAN_W;
    let out = b.output("span", &wide, FINE, "parameter between the two planes");
    b.plan(d.latency.add.min(3), &[("pairs", 7), ("fours", 7), ("sum", 7)]);
    b.section("pairs", "Shifted Q of each bit that is set; of a constant one that is not, nothing remains.");
    let tall = q.zext(&wide).named("q_tall");
    let texels = border.zext(SPAN_W)
        | b.konst(ahead, SPAN_W).named("ahead_texels").doc("texels of the window beyond the grid's cell");
    let texels = texels.named("texels");
    let term = |k: i64| -> Sig<'_> {
        b.sig(tall.id()).shift_left(b.lit(k as u64, 3)) & b.sig(texels.id()).bit(k).rep(wide.clone())
    };
    let pair = |k: i64| (term(k) + term(k + 1)).named(&format!("pair_{k}")).id();
    let pairs = [0, 2, 4].map(pair);
    let last = term(6).named("pair_6").id();
    b.section("fours", "");
    let four = |x, y, n: &str| (b.sig(x) + b.sig(y)).named(n).id();
    let fours = [four(pairs[0], pairs[1], "four_0"), four(pairs[2], last, "four_4")];
    b.section("sum", "");
    b.drive(out, (b.sig(fours[0]) + b.sig(fours[1])).named("sum"));
    let at = |ahead: i64| [("AHEAD".to_string(), ahead)].into();
    let mut list = bindings();
    list.extend([at(0), at(63)]);
    b.finish(&list)
}

/// The parameter of a size, which an instance passes.
pub fn size(w: reliefrtl_config::Window) -> [(&'static str, Expr); 1] {
    [("AHEAD", w.ahead().into())]
}
