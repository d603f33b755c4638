//! `window_address`: where the word of the window at a texel stands in the memory of its size, row by row.
use super::params::{CELL_W, Widths, bindings};
use crate::quantity::{BIT, TEXELS, WORDS};
use reliefrtl_config::{Design, Window};
use reliefrtl_ir::{Builder, Expr, Module};
use std::sync::Arc;

/// Address bits of the memory of one size: two or more.
pub fn address_width(levels: &Expr, grid: &Expr) -> Expr {
    ((levels - grid) * 2).larger(2)
}

/// The parameters of a size, which an instance passes.
pub fn size(w: Window) -> [(&'static str, Expr); 2] {
    [("GRID_W", w.grid_bits().into()), ("CELLS", w.cells().into())]
}

/// Builds `window_address`, combinational (parameters GRID_W, CELLS beside the map's).
pub fn window_address(d: &Design) -> Arc<Module> {
    let b = Builder::new(
        "window_address",
        file!(),
        "address of the window that begins at a texel, and the texels to its grid",
    );
    let w = d.window_set().sizes()[1];
    let (levels, _) = Widths::new(&b, d).map();
    let grid = b.param("GRID_W", w.grid_bits(), "log2 of the grid on which windows begin, in texels");
    let cells = b.param("CELLS", w.cells(), "cells of the grid a side of the window");
    b.require(&grid, CELL_W);
    b.require(&grid, &levels);
    b.require(1, &cells);
    b.require(&cells, 64);
    // Of a grid as large as the map no bit is left, so there is one more than needed.
    let cell_w = b.local("CellW", &levels - &grid + 1, "bits of a cell index along one axis");
    let addr_w = b.local("AddrW", address_width(&levels, &grid), "bits of the address of a window");
    let axes = ["x", "y"].map(|a| {
        let at = b.input(a, &levels, TEXELS, "texel that the ray is in");
        let neg = b.input(&format!("neg_{a}"), 1, BIT, "the ray runs toward smaller coordinates");
        (a, at, neg)
    });
    let out = b.output("address", &addr_w, WORDS, "the word of the window");
    let borders = ["x", "y"].map(|a| {
        b.output(&format!("border_{a}"), CELL_W, TEXELS, "texels up to the border of the grid's cell, along the ray")
    });
    let last = b.konst((&levels - &grid).pow2() - 1, &cell_w).named("last_cell").doc("the last cell of a row");
    // Modulo the cells of a map, which may be fewer than those of a window.
    let back = b.konst(cells - 1, &cell_w).named("cells_back").doc("cells of a window, less one");
    let mut places = Vec::new();
    for ((a, at, neg), border) in axes.into_iter().zip(borders) {
        let tall = at.zext(&levels + CELL_W).named(&format!("tall_{a}"));
        b.unused(tall);
        let cell = tall.slice(&grid, &cell_w).named(&format!("cell_{a}"));
        let first = (cell - (back & neg.rep(cell_w.clone()))) & last;
        places.push(first.named(&format!("first_{a}")));
        let low = tall.slice(0, CELL_W);
        let left = low ^ (!neg).rep(CELL_W);
        b.drive(
            border,
            (left & b.konst(grid.pow2() - 1, CELL_W).named("in_cell").doc("mask of the texel bits inside a cell"))
                .named(&format!("left_{a}")),
        );
    }
    let rows = b.konst(&levels - &grid, 4).named("row_bits").doc("logarithm of the cells of a row");
    let wide = &addr_w + 2;
    let row = places[1].zext(&wide).shift_left(rows).named("row");
    let address = (row | places[0].zext(&wide)).named("cell_address");
    b.unused(address);
    b.drive(out, address.slice(0, &addr_w).named("word"));
    b.finish(&bindings())
}
