//! `surface_gap`: how high a ray is over the surface interpolated between the centres of four texels.
use super::common::negated;
use crate::float::{FormatParams, fp_add, fp_from_fixed};
use crate::quantity::{CODES, float, integer};
use reliefrtl_config::Design;
use reliefrtl_ir::{Binding, Builder, Module, Sig};
use std::sync::Arc;

/// Builds `surface_gap`.
pub fn surface_gap(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b = Builder::new(
        "surface_gap",
        file!(),
        "depth of the bilinear surface between four texel centres, less the ray's own",
    );
    let f = FormatParams::declare(&b, d.format);
    let h = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
    let frac = b.param("FRAC_W", t.frac_bits, "fraction bits of the weights");
    b.require(2, &h);
    b.require(&h, 16);
    b.require(1, &frac);
    b.require(&frac, 16);
    // The exact depth and what its conversion works with fit a word.
    b.require(&h + frac.clone() * 2 + &f.man, 60);
    b.clock();
    b.clock_enable();
    let codes = [
        ("00", "first column, first row"),
        ("10", "second column, first row"),
        ("01", "first column, second row"),
        ("11", "second column, second row"),
    ]
    .map(|(name, doc)| b.input(&format!("code_{name}"), &h, CODES, doc));
    let wx = b.input("weight_x", &frac, integer("1/2^FRAC_W texel"), "distance from the first column");
    let wy = b.input("weight_y", &frac, integer("1/2^FRAC_W texel"), "distance from the first row");
    let time = b.input("t", &f.width, float("height codes"), "ray parameter: its own depth");
    let out = b.output("gap", &f.width, float("height codes"), "above 0: the ray is above the surface");
    let m = d.latency.mul;
    let one_less = |w: Sig<'_>, name: &str| {
        let one = b.cat(&[b.lit(1, 1), b.zeros(&frac)]);
        (one - w.zext(&frac + 1)).named(name).id()
    };

    b.section("rows", "Exact. The complement of a code is its depth below the top plane.");
    let rest = b.sig(one_less(wx, "rest_x"));
    let row = |k: usize| {
        let first = (!codes[2 * k]).product(rest);
        let second = (!codes[2 * k + 1]).product(wx).zext(&h + &frac + 1);
        let sum = (first + second).named(&format!("sum_{k}"));
        b.unused(sum.msb());
        sum.slice(0, &h + &frac).named(&format!("row_{k}")).at(m).id()
    };
    let rows = [row(0), row(1)].map(|id| b.sig(id));

    b.section("columns", "");
    let wy = wy.at(m);
    let rest = b.sig(one_less(wy, "rest_y"));
    let wide = frac.clone() * 2 + &h + 1;
    let depth = (rows[0].product(rest) + rows[1].product(wy).zext(&wide)).named("depth");

    b.section("gap", "");
    let from = fp_from_fixed(d.format, t.height_bits + 2 * t.frac_bits + 1, 2 * t.frac_bits, d.latency.from_int);
    let int = [("INT_W", wide), ("FRAC_W", frac.clone() * 2)];
    // At most M, so the top bit is 0: not negative.
    let depth = b.inst(&from, "u_from_fixed", &int, &[("a", depth.at(2 * m))]).only().named("surface");
    let minus = negated(&b, time, "minus_t");
    let add = fp_add(d.format, d.latency.add);
    let gap = b.inst(&add, "u_sub", &[], &[("a", depth), ("b", minus)]).only().named("height_over");
    b.drive(out, gap);
    let at = |e: i64, m: i64, h: i64, k: i64| {
        let of = [("EXP_W", e), ("MAN_W", m), ("HEIGHT_W", h), ("FRAC_W", k)];
        of.into_iter().map(|(k, v)| (k.to_string(), v)).collect::<Binding>()
    };
    b.finish(&[at(5, 10, 2, 1), at(8, 23, 8, 14), at(7, 16, 16, 12), at(4, 3, 8, 16)])
}
