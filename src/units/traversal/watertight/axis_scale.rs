//! `axis_scale`: a ray along one axis, from tiles to texels, and whether it can be traced.
use crate::float::{Fields, FormatParams, bindings};
use crate::quantity::{BIT, float};
use crate::traversal::params::LevelParams;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `axis_scale`, combinational.
pub fn axis_scale(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b = Builder::new("axis_scale", file!(), "a ray along one axis, from tiles to texels: times 2^LEVELS");
    let f = FormatParams::declare(&b, d.format);
    let levels = LevelParams::declare(&b, t).levels;
    let tile = b.param("TILE_W", t.tile_bits, "a ray travels less than 2^TILE_W tiles along each axis");
    b.require(1, &tile);
    b.require(&tile, 8);
    b.require(&levels + &tile + 1, f.bias());
    let p = b.input("p", &f.width, float("tiles"), "entry point at the top plane");
    let travel = b.input("d", &f.width, float("tiles"), "travel while the height falls from 1 to 0");
    let o_ok = b.output("ok", 1, BIT, "can be traced: 0 <= p < 1 and |d| < 2^TILE_W");
    let o_p = b.output("p_texels", &f.width, float("texels"), "entry point, without its sign");
    let o_travel = b.output("d_texels", &f.width, float("texels"), "travel");

    b.section("range", "Compares exponents alone: those of 1 and of 2^TILE_W are the least that are too large.");
    let (fp, fd) = (Fields::of(&f, p, "p"), Fields::of(&f, travel, "d"));
    let one = b.konst(f.bias(), &f.exp).named("one_exp").doc("biased exponent of 1");
    let far = b.konst(f.bias() + &tile, &f.exp).named("far_exp").doc("biased exponent of 2^TILE_W");
    let ok = ((fp.is_zero | (!fp.sign & fp.exp.lt(one))) & fd.exp.lt(far)).named("in_range");
    b.unused(b.cat(&[fp.is_inf, fp.is_nan, fd.is_inf, fd.is_nan]));

    b.section(
        "scale",
        "LEVELS is added to the exponent; zeros stay zeros. Of a refused ray (ok = 0) the sum may wrap.",
    );
    let grow = b.konst(&levels, &f.exp).named("grow").doc("added to an exponent: times 2^LEVELS");
    let axes = [(b.zeros(1), &fp, "p_scaled"), (fd.sign, &fd, "d_scaled")];
    let [p, travel] = axes.map(|(sign, x, net)| {
        let keep = (!x.is_zero).rep(&f.exp + &f.man);
        b.cat(&[sign, b.cat(&[x.exp + grow, x.frac]) & keep]).named(net)
    });
    b.drive(o_ok, ok);
    b.drive(o_p, p);
    b.drive(o_travel, travel);
    b.finish(&bindings())
}
