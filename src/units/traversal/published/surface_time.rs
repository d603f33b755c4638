//! `surface_time`: how far the ray may go before it meets the node's height, max(t, (M - height) / M) with M the largest
//! code (PIDM-HW section 2: advance to the height, or stay where the ray is below it).
use crate::float::{FormatParams, fp_from_int, fp_lt, fp_mul};
use crate::quantity::{BIT, CODES, float};
use reliefrtl_config::Design;
use reliefrtl_ir::{Binding, Builder, Module};
use std::sync::Arc;

/// Builds `surface_time`; with a start level it has the input that asks for the end of the ray instead.
pub fn surface_time(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("surface_time", file!(), "parameter at which the ray is in the node and at or below its height");
    let f = FormatParams::declare(&b, d.format);
    let h = b.param("HEIGHT_W", d.traverse.height_bits, "bits of a height code");
    b.require(2, &h);
    b.require(&h, 16);
    b.require(&h + 2, f.bias());
    b.clock();
    b.clock_enable();
    let height = b.input("height", &h, CODES, "largest height in the node");
    let t = b.input("t", &f.width, float("height range"), "parameter so far");
    let first = d.mode.start_level.then(|| b.input("first", 1, BIT, "mode 1: the ray's end is asked for, at 1"));
    let out = b.output("m", &f.width, float("height range"), "the larger of t and the height's parameter");
    let below = b.output("below", 1, BIT, "the ray is below the node's height already: a hit would be on a wall");

    b.section("depth", "The complement of a code is its distance from the top plane.");
    let depth = b.cat(&[b.zeros(1), !height]).named("depth");
    let from = fp_from_int(d.format, d.traverse.height_bits + 1, d.latency.from_int);
    let codes = b.inst(&from, "u_from_int", &[("INT_W", &h + 1)], &[("a", depth)]).only().named("depth_float");

    b.section("scale", "Times 1 / M, M = 2^HEIGHT_W - 1: the ray parameter runs from 0 to 1.");
    let exp = b.konst(f.bias() - &h, &f.exp).named("recip_exp").doc("biased exponent of 1 / M");
    let sig = ((&h + &f.man + 1).pow2() + h.pow2() - 1).div(h.pow2() * 2 - 2);
    let frac = b.konst(sig, &f.man).named("recip_frac").doc("fraction of 1 / M");
    let recip = b.cat(&[b.zeros(1), exp, frac]);
    let mul = fp_mul(d.format, d.latency.mul);
    let t_v = b.inst(&mul, "u_scale", &[], &[("a", codes), ("b", recip)]).only().named("t_v");

    b.section("compare", "");
    let lt = fp_lt(d.format, d.latency.compare);
    let before = b.inst(&lt, "u_lt", &[], &[("a", t), ("b", t_v)]).only().named("t_lt_t_v");
    let after = b.inst(&lt, "u_below", &[], &[("a", t_v), ("b", t)]).only().named("is_below");
    let reach = before.mux(t_v, t);
    let m = match first {
        None => reach,
        Some(first) => {
            let one_exp = b.konst(f.bias(), &f.exp).named("one_exp").doc("biased exponent of 1");
            first.mux(b.cat(&[b.zeros(1), one_exp, b.zeros(&f.man)]), reach)
        }
    };
    b.drive(out, m.named("max_parameter"));
    b.drive(below, after);
    let at = |e: i64, m: i64| Binding::from([("EXP_W".into(), e), ("MAN_W".into(), m)]);
    b.finish(&[at(7, 16), at(5, 10), at(8, 23)])
}
