//! `plane_order`: which of the planes of a block of four cells comes before which (`docs/cells.md`).
use super::params::{Params, TIME, bindings, time_width};
use crate::quantity::BIT;
use crate::traversal::cells::ORDER;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `plane_order`, `latency.compare` clocks.
pub fn plane_order(d: &Design) -> Arc<Module> {
    let b = Builder::new("plane_order", file!(), "order of a ray's parameter and those of a block's four planes");
    let f = Params { b: &b, d }.fraction();
    let time = b.local("TimeW", time_width(&f), "bits of a ray parameter");
    b.clock();
    b.clock_enable();
    let parameter = |name: &'static str, doc: &str| (name, b.input(name, &time, TIME, doc));
    let parameters = [
        parameter("t", "parameter so far"),
        parameter("mid_x", "parameter of the x middle plane"),
        parameter("mid_y", "parameter of the y middle plane"),
        parameter("far_x", "parameter of the x exit plane"),
        parameter("far_y", "parameter of the y exit plane"),
    ];
    let of = |name: &str| parameters.iter().find(|p| p.0 == name).expect("a parameter").1;
    let outs = ORDER.map(|(name, first, second)| b.output(name, 1, BIT, &format!("{first} is less than {second}")));
    b.section("compare", "");
    b.at_least(d.latency.compare);
    for ((_, first, second), out) in ORDER.into_iter().zip(outs) {
        let less = of(first).lt(of(second)).named(&format!("{first}_lt_{second}"));
        b.drive(out, less);
    }
    b.finish(&bindings())
}
