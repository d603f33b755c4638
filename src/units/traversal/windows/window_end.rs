//! `window_end`: the parameter of the plane that ends a window along one axis, from that of the texel's plane.
use super::params::{FINE, SPAN_W, Widths, bindings};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `window_end`.
pub fn window_end(d: &Design) -> Arc<Module> {
    let b = Builder::new("window_end", file!(), "parameter of the plane that ends a window along an axis");
    let p = Widths::new(&b, d).planes();
    let wide = &p.plane + SPAN_W;
    b.clock();
    b.clock_enable();
    let plane = b.input("plane", &p.plane + 1, FINE, "parameter of the plane ahead of the texel");
    let span = b.input("span", &wide, FINE, "from there to the end of the window, at most 78 planes");
    let out = b.output("ends_at", &wide, FINE, "parameter of that plane");
    b.at_least(d.latency.add.min(1));
    b.drive(out, (plane.zext(&wide) + span).named("end_plane"));
    b.finish(&bindings())
}
