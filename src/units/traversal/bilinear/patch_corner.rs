//! `patch_corner`: along one axis, the first texel of the patch in which a place lies. Heights stand at the centres of texels, so it is half a texel further
//! back.
use crate::quantity::{TEXELS, integer};
use crate::traversal::params::LevelParams;
use reliefrtl_config::TraverseConfig;
use reliefrtl_ir::{Binding, Builder, Module};
use std::sync::Arc;

/// Builds `patch_corner`, combinational.
pub fn patch_corner(t: &TraverseConfig) -> Arc<Module> {
    let b = Builder::new(
        "patch_corner",
        file!(),
        "first texel of the patch that holds a place, and how far from its centre",
    );
    let levels = LevelParams::declare(&b, t).levels;
    let frac = b.param("FRAC_W", t.frac_bits, "fraction bits of the position");
    b.require(1, &frac);
    b.require(&frac, 16);
    let texel = b.input("texel", &levels, TEXELS, "texel of the place, wrapped");
    let fraction = b.input("fraction", &frac, integer("1/2^FRAC_W texel"), "position inside the texel");
    let o_texel = b.output("corner", &levels, TEXELS, "texel whose centre is the last one not beyond the place");
    let o_weight = b.output("weight", &frac, integer("1/2^FRAC_W texel"), "distance from that centre");
    let wide = &levels + &frac;
    let half = b
        .lit(1, &wide)
        .shift_left(b.konst(&frac - 1, 5).named("half_bit").doc("place of the bit that is half a texel"))
        .named("half");
    let at = (b.cat(&[texel, fraction]) - half).named("from_centre");
    b.drive(o_texel, at.slice(frac.clone(), &levels));
    b.drive(o_weight, at.slice(0, &frac));
    let sizes = |l: i64, f: i64| Binding::from([("LEVELS".into(), l), ("FRAC_W".into(), f)]);
    b.finish(&[sizes(2, 1), sizes(3, 16), sizes(12, 8)])
}
