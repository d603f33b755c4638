//! `ray_place`: along one axis, the texel of a map that repeats in which the ray is at a parameter, and where in it.
use crate::float::{FormatParams, fp_add, fp_mul, fp_to_fixed};
use crate::quantity::{TEXELS, float, integer};
use crate::traversal::params::{LevelParams, index_width};
use reliefrtl_config::Design;
use reliefrtl_ir::{Binding, Builder, Module};
use std::sync::Arc;

/// Builds `ray_place`.
pub fn ray_place(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b = Builder::new("ray_place", file!(), "texel, wrapped, and fraction of p + d * t along one axis");
    let f = FormatParams::declare(&b, d.format);
    let levels = LevelParams::declare(&b, t).levels;
    let idx = index_width(&b, t, Some(&levels));
    let frac = b.param("FRAC_W", t.frac_bits, "fraction bits of the position");
    b.require(1, &frac);
    b.require(&frac, 16);
    b.require(&idx + &frac + &f.man, 60);
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f.width, float("texels"), "entry point");
    let dir = b.input("d", &f.width, float("texels per height code"), "direction");
    let time = b.input("t", &f.width, float("height codes"), "parameter");
    let o_texel = b.output("texel", &levels, TEXELS, "texel, wrapped into the map");
    let o_fraction = b.output("fraction", &frac, integer("1/2^FRAC_W texel"), "position inside the texel");

    b.section("position", "");
    let way = b.inst(&fp_mul(d.format, d.latency.mul), "u_mul", &[], &[("a", dir), ("b", time)]).only().named("way");
    let at = b.inst(&fp_add(d.format, d.latency.add), "u_add", &[], &[("a", p), ("b", way)]).only().named("position");
    let to = fp_to_fixed(d.format, t.idx_bits() + t.frac_bits, t.frac_bits, d.latency.to_int);
    let int = [("INT_W", &idx + &frac), ("FRAC_W", frac.clone())];
    let fixed = b.inst(&to, "u_to_fixed", &int, &[("a", at)]).only().named("fixed");

    b.section("wrap", "The map repeats: the bits above a texel's are the tile.");
    b.unused(fixed.slice(&levels + &frac, &idx - &levels));
    b.drive(o_texel, fixed.slice(frac.clone(), &levels));
    b.drive(o_fraction, fixed.slice(0, &frac));
    let at = |n: i64, e: i64, m: i64| {
        let of = [("LEVELS", n), ("IDX_W", n + 6), ("EXP_W", e), ("MAN_W", m)];
        of.into_iter().map(|(k, v)| (k.to_string(), v)).collect::<Binding>()
    };
    b.finish(&[at(2, 5, 10), at(12, 8, 23), at(8, 4, 3)])
}
