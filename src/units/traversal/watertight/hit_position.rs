//! `hit_position`: where in its texel a ray hit, along one axis, as a fraction that never leaves the texel.
use crate::float::{FormatParams, fp_add, fp_mul, fp_to_fixed};
use crate::quantity::{LEVELS, TEXELS, float, integer};
use crate::traversal::node_hit;
use crate::traversal::params::{LevelParams, index_width};
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Binding, Builder, Module, Sig};
use std::sync::Arc;

/// Formats at which the unit is verified besides its own.
const BINDINGS: [(i64, i64); 3] = [(8, 23), (5, 10), (6, 12)];

fn at(exp: i64, man: i64) -> Binding {
    Binding::from([("EXP_W".into(), exp), ("MAN_W".into(), man)])
}

/// Builds `hit_position`. With a level of detail the hit is kept in its node, else in its texel.
pub fn hit_position(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("hit_position", file!(), "position of the hit inside its texel: p + d * t - x, kept in [0, 1)");
    let f = FormatParams::declare(&b, d.format);
    let levels = d.mode.lod.then(|| LevelParams::declare(&b, &d.traverse));
    let idx = index_width(&b, &d.traverse, levels.as_ref().map(|l| &l.levels));
    let frac = b.param("FRAC_W", d.traverse.frac_bits, "fraction bits of the position");
    b.require(1, &frac);
    b.require(&frac, 16);
    b.require(2, &idx);
    b.require(&idx + &frac + &f.man, 60);
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f.width, float("texels"), "entry point");
    let dir = b.input("d", &f.width, float("texels per height code"), "direction");
    let t = b.input("t", &f.width, float("height codes"), "parameter of the hit");
    let x = b.input("x", &idx, TEXELS, "hit texel, unwrapped");
    let lod = levels.as_ref().map(|l| b.input("lod", &l.level_w, LEVELS, "level of the node that is hit"));
    let out = b.output("fraction", &frac, integer("1/2^FRAC_W texel"), "position inside the texel");
    let o_texel = levels.as_ref().map(|l| b.output("texel", &l.levels, TEXELS, "texel of the hit, wrapped"));
    let coarse = lod.zip(o_texel);
    b.section("position", "");
    let way =
        b.inst(&fp_mul(d.format, d.latency.mul), "u_mul", &[], &[("a", dir), ("b", t)]).only().named("displacement");
    let pos = b.inst(&fp_add(d.format, d.latency.add), "u_add", &[], &[("a", p), ("b", way)]).only().named("position");
    let to =
        fp_to_fixed(d.format, d.traverse.idx_bits() + d.traverse.frac_bits, d.traverse.frac_bits, d.latency.to_int);
    let int = [("INT_W", &idx + &frac), ("FRAC_W", frac.clone())];
    let fixed = b.inst(&to, "u_to_fixed", &int, &[("a", pos)]).only().named("fixed");

    // The valid bit beside it decides whether the pipeline moves: it waits for a clock at least.
    b.at_least(1);
    b.section("clamp", "A hit on a wall lies exactly on a border: the integer texel decides, the fraction follows.");
    let wide = &idx + &frac + 1;
    if let Some((lod, o_texel)) = coarse {
        let ins = [("at", fixed), ("x", x.beside(fixed)), ("lod", lod.beside(fixed))];
        let kept = b.inst(&node_hit(&d.traverse), "u_node_hit", &[("IDX_W", idx)], &ins);
        let late = |v: Sig<'_>| {
            let v = v.reg_if(d.latency.has(Register::HitOffset));
            v.reg_if(d.latency.has(Register::HitFraction)).id()
        };
        b.drive(out, b.sig(late(kept["fraction"].named("kept"))));
        b.drive(o_texel, b.sig(late(kept["texel"].named("hit_texel"))));
        return b.finish(&BINDINGS.map(|(e, m)| at(e, m)));
    }
    let corner = b.cat(&[x.beside(fixed), b.zeros(&frac)]).named("corner");
    let off = (fixed.sext(&wide) - corner.sext(&wide)).named("offset");
    let off = off.reg_if(d.latency.has(Register::HitOffset));
    let past = off.slice(&frac, &idx + 1).any().named("past");
    let inside = off.slice(0, &frac).named("low_part");
    let kept = off.msb().mux(b.zeros(&frac), past.mux(b.ones(&frac), inside)).named("kept");
    b.drive(out, kept.reg_if(d.latency.has(Register::HitFraction)));
    b.finish(&BINDINGS.map(|(e, m)| at(e, m)))
}
