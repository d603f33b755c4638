//! `window_setup`: once per ray, from texture coordinates to what a search by windows reads: `ray_setup`, then the constants of each axis.
use super::params::{Estimate, FINE, Widths, bindings};
use super::window_constants::window_constants;
use crate::quantity::{BIT, Quantity, integer};
use crate::traversal::fixed::params::LENGTH;
use crate::traversal::fixed::ray_setup;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Module};
use std::sync::Arc;

/// Builds `window_setup`.
pub fn window_setup(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("window_setup", file!(), "a ray's constants for a search by windows, from texture coordinates");
    b.note("A ray that can't be traced (see ok) has p, s and neg 0, as one that does not move.");
    let widths = Widths::new(&b, d);
    let f = widths.f.clone();
    let planes = widths.planes();
    widths.of.height(&f);
    let e = Estimate::of(&b, &f, &planes.levels, &planes.tile);
    let reach = &f + &planes.tile;
    b.clock();
    b.clock_enable();
    let ray = [
        ("u", b.input("u", &f, LENGTH, "entry point at the top plane")),
        ("v", b.input("v", &f, LENGTH, "entry point at the top plane")),
        ("du", b.input("du", &reach + 1, LENGTH, "u travelled while the height falls from 1 to 0, signed")),
        ("dv", b.input("dv", &reach + 1, LENGTH, "v travelled while the height falls from 1 to 0, signed")),
    ];
    let o_ok = b.output("ok", 1, BIT, "the ray can be traced: no travel is the most negative word");
    let ports = |a: &str| {
        let of = |n: &str, w: &Expr, unit: Quantity, doc: &str| b.output(&format!("{n}_{a}"), w, unit, doc);
        [
            of("p", &f, LENGTH, "entry point"),
            of("s", &(&reach + 1), integer("2^-(FRACTION_W+HEIGHT_W) tiles"), "travel per height code, its magnitude"),
            of("neg", &Expr::from(1), BIT, "the ray runs toward smaller coordinates"),
            of("q", &planes.plane, FINE, "parameter from plane to plane"),
            of("c", &planes.plane, FINE, "parameter of the first plane; all ones: never"),
            of("travel", &e.travel, integer("2^-(EstimateW+HEIGHT_W) texels"), "travel per height code, less its bias"),
            of("offset", &e.offset, integer("2^-EstimateW texels"), "how far in its texel the ray begins"),
        ]
    };
    let outs = [("x", ports("x")), ("y", ports("y"))];
    b.section("ray", "");
    let ray = b.inst(&ray_setup(d), "u_ray", &[], &ray);
    b.drive(o_ok, ray["ok"].named("is_ok"));
    for (a, outs) in outs {
        b.section(&format!("axis {a}"), "");
        let of = |n: &str| ray[format!("{n}_{a}").as_str()].named(&format!("{a}_{n}"));
        let ins = ["p", "s", "r", "z", "neg"].map(|n| (n, of(n)));
        let found = b.inst(&window_constants(d), &format!("u_{a}_constants"), &[], &ins);
        let given = ["p", "s", "neg"].map(of);
        let made = ["q", "c", "travel", "offset"].map(|n| found[n].named(&format!("{a}_{n}")));
        for (port, v) in outs.into_iter().zip(given.into_iter().chain(made)) {
            b.drive(port, v);
        }
    }
    b.finish(&bindings())
}
