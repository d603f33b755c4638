//! `bilinear_window`: between which parameters the surface is looked for: half a texel of the faster axis before and after the hit.
use super::common::negated;
use crate::float::{FormatParams, bindings, fp_add, fp_lt, fp_mul};
use crate::quantity::float;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `bilinear_window`.
pub fn bilinear_window(d: &Design) -> Arc<Module> {
    let b = Builder::new("bilinear_window", file!(), "parameters half a texel before and after a hit, in [0, M]");
    let f = FormatParams::declare(&b, d.format);
    let h = b.param("HEIGHT_W", d.traverse.height_bits, "bits of a height code; M is the largest one");
    b.require(2, &h);
    b.require(&h, 16);
    b.require(&h, &f.man + 1);
    b.require(&h + 2, f.bias());
    b.clock();
    b.clock_enable();
    let r_x = b.input("r_x", &f.width, float("height codes per texel"), "u slope's reciprocal, of either sign");
    let r_y = b.input("r_y", &f.width, float("height codes per texel"), "v slope's reciprocal, of either sign");
    let t = b.input("t", &f.width, float("height codes"), "parameter of the hit");
    let o_begin = b.output("t_begin", &f.width, float("height codes"), "before the hit, not below +0");
    let o_end = b.output("t_end", &f.width, float("height codes"), "after the hit, not above M");
    let lt = fp_lt(d.format, d.latency.compare);
    let add = fp_add(d.format, d.latency.add);

    b.section("half a texel", "Of the axis along which the ray passes more of them.");
    let [x, y] = [(r_x, "x_texel"), (r_y, "y_texel")]
        .map(|(r, name)| b.cat(&[b.zeros(1), r.slice(0, &f.width - 1)]).named(name));
    b.unused(b.cat(&[r_x.msb(), r_y.msb()]));
    let y_faster = b.inst(&lt, "u_faster", &[], &[("a", y), ("b", x)]).only().named("y_is_faster");
    let texel = y_faster.mux(y, x).named("texel");
    // 2^-1: the bias less one in the exponent field.
    let one_half = b.cat(&[
        b.zeros(1),
        b.konst(f.bias() - 1, &f.exp).named("half_exp").doc("biased exponent of 1/2"),
        b.zeros(&f.man),
    ]);
    let mul = fp_mul(d.format, d.latency.mul);
    let half = b.inst(&mul, "u_half", &[], &[("a", texel), ("b", one_half)]).only().named("half");

    b.section("ends", "");
    let minus = negated(&b, half, "minus_half");
    let before = b.inst(&add, "u_less", &[], &[("a", t), ("b", minus)]).only().named("t_less_window");
    let after = b.inst(&add, "u_after", &[], &[("a", t), ("b", half)]).only().named("t_after");

    b.section("clamp", "The planes of full height and of none.");
    let m_exp = b.konst(f.bias() + &h - 1, &f.exp).named("m_exp").doc("biased exponent of M = 2^HEIGHT_W - 1");
    let m_frac = b.konst(f.man.pow2() - (&f.man - &h + 1).pow2(), &f.man).named("m_frac").doc("fraction field of M");
    let bottom = b.cat(&[b.zeros(1), m_exp, m_frac]);
    let zero = b.zeros(&f.width);
    let is_above = b.inst(&lt, "u_top", &[], &[("a", zero), ("b", before)]).only().named("is_inside_top");
    let is_below = b.inst(&lt, "u_floor", &[], &[("a", after), ("b", bottom)]).only().named("is_inside_floor");
    b.drive(o_begin, is_above.mux(before, zero).named("t_clamped_begin"));
    b.drive(o_end, is_below.mux(after, bottom).named("t_clamped_end"));
    b.finish(&bindings())
}
