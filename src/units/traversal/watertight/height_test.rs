//! `height_test`: how far the ray may go before it meets the node's height: max(t, M - height), M the largest code.
use crate::float::{FormatParams, bindings, fp_from_int, fp_lt};
use crate::quantity::{BIT, CODES, float};
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `height_test`.
pub fn height_test(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("height_test", file!(), "parameter at which the ray is in the node and at or below its height");
    let f = FormatParams::declare(&b, d.format);
    let h = b.param("HEIGHT_W", d.traverse.height_bits, "bits of a height code");
    b.require(2, &h);
    b.require(&h, 16);
    b.clock();
    b.clock_enable();
    let height = b.input("height", &h, CODES, "largest height in the node");
    let t = b.input("t", &f.width, float("height codes"), "parameter so far");
    let out = b.output("m", &f.width, float("height codes"), "the larger of t and the height plane's parameter");
    let below = b.output("below", 1, BIT, "the ray is below the node's height already: a hit would be on a wall");

    b.section("depth", "The complement of a code is its distance from the top plane.");
    let depth = b.cat(&[b.zeros(1), !height]);
    let depth = depth.named("depth");
    let from = fp_from_int(d.format, d.traverse.height_bits + 1, d.latency.from_int);
    let t_v = b.inst(&from, "u_from_int", &[("INT_W", &h + 1)], &[("a", depth)]).only().named("t_v");

    b.section("compare", "");
    let lt = fp_lt(d.format, d.latency.compare);
    let before = b.inst(&lt, "u_lt", &[], &[("a", t), ("b", t_v)]).only().named("t_lt_t_v");
    let after = b.inst(&lt, "u_below", &[], &[("a", t_v), ("b", t)]).only().named("is_below");
    let m = before.mux(t_v, t).named("max_parameter");
    b.drive(out, m.reg_if(d.latency.has(Register::Parameter)));
    b.drive(below, after);
    b.finish(&bindings())
}
