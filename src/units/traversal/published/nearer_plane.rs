//! `nearer_plane`: which exit plane the ray meets first (PIDM-HW section 3.2, node crossing).
use crate::float::{FormatParams, bindings, fp_lt};
use crate::quantity::{BIT, float};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `nearer_plane`; `parity` adds the output that tevs and selective level-up ask for.
pub fn nearer_plane(d: &Design, parity: bool) -> Arc<Module> {
    let b = Builder::new("nearer_plane", file!(), "the exit plane that the ray meets first, and its parameter");
    let f = FormatParams::declare(&b, d.format);
    b.clock();
    b.clock_enable();
    let t_x = b.input("t_x", &f.width, float("height range"), "parameter of the u exit plane");
    let t_y = b.input("t_y", &f.width, float("height range"), "parameter of the v exit plane");
    let out = b.output("t_exit", &f.width, float("height range"), "the smaller of the two");
    let x_first = parity.then(|| b.output("x_first", 1, BIT, "the u plane comes first, or both at once"));
    let lt = fp_lt(d.format, d.latency.compare);
    let y_less = b.inst(&lt, "u_ty_tx", &[], &[("a", t_y), ("b", t_x)]).only().named("y_lt_x");
    b.drive(out, y_less.mux(t_y, t_x).named("nearer"));
    if let Some(port) = x_first {
        b.drive(port, !y_less);
    }
    b.finish(&bindings())
}
