//! `ray_scale`: once per ray, before the loop: from tiles to texels, and the texel of the entry point.
//!
//! All else that a ray needs is computed in the loop (PIDM-HW section 4.2): the end A = P + D on its first trip, by the
//! units of the hit position. What each output is, to the bit: `docs/published.md`, "Once per ray".

use crate::float::{Fields, FormatParams, fp_to_int};
use crate::quantity::{BIT, LEVELS, Quantity, TEXELS, float};
use crate::traversal::params::{LevelParams, float_sizes};
use reliefrtl_config::Design;
use reliefrtl_ir::{Binding, Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Builds `ray_scale`.
pub fn ray_scale(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b = Builder::new("ray_scale", file!(), "a ray's entry point and travel in texels, and its first node");
    b.note("A ray that can't be traced (see ok) has all other outputs 0.");
    let f = FormatParams::declare(&b, d.format);
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let height = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
    let tile = b.param("TILE_W", t.tile_bits, "a ray travels less than 2^TILE_W tiles along each axis");
    float_sizes(&b, &f, &levels, &height, &tile);
    let idx = b.local("IdxW", &levels + &tile + 2, "bits of a signed, unwrapped texel coordinate");
    b.clock();
    b.clock_enable();
    let u = b.input("u", &f.width, float("tiles"), "entry point at the top plane, 0 <= u < 1");
    let v = b.input("v", &f.width, float("tiles"), "entry point at the top plane, 0 <= v < 1");
    let du = b.input("du", &f.width, float("tiles"), "u travelled while the height falls from 1 to 0");
    let dv = b.input("dv", &f.width, float("tiles"), "v travelled while the height falls from 1 to 0");
    let o_ok = b.output("ok", 1, BIT, "the ray can be traced: finite, entry in the tile, travel below 2^TILE_W");
    let o_level = b.output("level", &level_w, LEVELS, "the root; a start level replaces it after the first trip");
    let outs = ["x", "y"].map(|a| {
        let of = |n: &str, w: &Expr, unit: Quantity, doc: &str| b.output(&format!("{n}_{a}"), w, unit, doc);
        [
            of("p", &f.width, float("texels"), "entry point"),
            of("d", &f.width, float("texels"), "travel over the height range; +0 if there is none"),
            of("first", &idx, TEXELS, "texel of the entry point"),
        ]
    });
    let mut oks = Vec::new();
    let mut values = Vec::new();
    for (axis, p, dir) in [("x", u, du), ("y", v, dv)] {
        let n = |what: &str| format!("{axis}_{what}");
        b.section(&n("scale"), "Times 2^LEVELS: the exponent grows; zeros become +0.");
        let (fp, fd) = (Fields::of(&f, p, &n("p_in")), Fields::of(&f, dir, &n("d_in")));
        let one = b.konst(f.bias(), &f.exp).named("one_exp").doc("biased exponent of 1");
        let far = b.konst(f.bias() + &tile, &f.exp).named("far_exp").doc("biased exponent of 2^TILE_W");
        oks.push(((fp.is_zero | (!fp.sign & fp.exp.lt(one))) & fd.exp.lt(far)).named(&n("ok")).id());
        b.unused(b.cat(&[fp.is_inf, fp.is_nan, fd.is_inf, fd.is_nan]));
        let grow = b.konst(&levels, &f.exp).named("grow").doc("added to an exponent: times 2^LEVELS");
        let scaled = |x: &Fields<'_>, sign: Sig<'_>, net: &str| {
            let keep = (!x.is_zero).rep(&f.exp + &f.man + 1);
            (b.cat(&[sign, x.exp + grow, x.frac]) & keep).named(&n(net)).id()
        };
        let (p, dir) = (b.sig(scaled(&fp, b.zeros(1), "p")), scaled(&fd, fd.sign, "d"));
        let to = fp_to_int(d.format, d.traverse.idx_bits(), d.latency.to_int);
        let first = b.inst(&to, &format!("u_{axis}_first"), &[("INT_W", idx.clone())], &[("a", p)]).only();
        values.push([p.id(), dir, first.named(&n("first")).id()]);
    }
    b.section("result", "");
    // Of unknown words it is not known whether they are a ray: then it is refused. The register is the one clock at least that keeps a ready from
    // following from a valid in the same clock.
    let ok = (b.sig(oks[0]) & b.sig(oks[1])).named("is_ok").decided(false);
    let l = b.latest(values.iter().flatten().map(|v| b.sig(*v)).chain([ok]));
    let ok = ok.at(l);
    b.drive(o_ok, ok);
    let gate = |v: Sig<'_>| (v.at(l) & ok.rep(v.width())).id();
    b.drive(o_level, b.sig(gate(b.konst(&levels, &level_w).named("root").doc("the root's level"))));
    for (values, outs) in values.into_iter().zip(outs) {
        for (v, out) in values.into_iter().zip(outs) {
            b.drive(out, b.sig(gate(b.sig(v))));
        }
    }
    let at = |l: i64, h: i64| Binding::from([("LEVELS".into(), l), ("HEIGHT_W".into(), h)]);
    let fmt = Binding::from([("EXP_W".into(), 8), ("MAN_W".into(), 23)]);
    b.finish(&[at(2, 8), at(12, 8), at(12, 16), at(2, 2), fmt])
}
