//! `axis_slope`: a ray's constants along one axis, from entry point and travel in texels. What each is, to the bit: `docs/datapath.md`, "Once
//! per ray".
use crate::float::{FormatParams, fp_add, fp_div, fp_mul, fp_to_int};
use crate::quantity::{BIT, TEXELS, float};
use crate::traversal::params::LevelParams;
use reliefrtl_config::{Design, Register, Trim};
use reliefrtl_ir::{Binding, Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Builds `axis_slope`.
pub fn axis_slope(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b =
        Builder::new("axis_slope", file!(), "a ray's constants along one axis: slope, its reciprocal, biased entry");
    let f = FormatParams::declare(&b, d.format);
    let levels = LevelParams::declare(&b, t).levels;
    let height = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
    let idx = (d.mode.trim != Trim::None).then(|| {
        let tile = b.param("TILE_W", t.tile_bits, "a ray travels less than 2^TILE_W tiles along each axis");
        b.require(1, &tile);
        b.require(&tile, 8);
        b.require(&levels + &tile + 2, 24);
        b.require(&levels + &tile + 1, f.bias());
        // What underflows must stay below the bias of a chord's end.
        b.require(&f.man + 4, f.bias());
        b.local("IdxW", &levels + &tile + 2, "bits of a signed, unwrapped texel coordinate")
    });
    b.require(2, &height);
    b.require(&height, 16);
    b.require(&height, &f.man + 1);
    b.require(7, &f.man);
    b.require(&height + 2, f.bias());
    b.require(&f.man, f.bias() + &levels);
    b.require(&levels + 2, f.bias());
    let div = fp_div(d.format, &d.latency);
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f.width, float("texels"), "entry point");
    let dn = b.input("dn", &f.width, float("texels"), "travel down to the bottom plane");
    let o_back = b.output("p_back", &f.width, float("texels"), "entry point, biased against the direction");
    let o_d = b.output("d", &f.width, float("texels per height code"), "direction");
    let o_r = b.output("r", &f.width, float("height codes per texel"), "reciprocal direction");
    let o_never = b.output("never", 1, BIT, "the ray does not move along this axis: dn is zero, or M / dn overflows");
    let o_ahead = idx.as_ref().map(|idx| {
        let p = b.output("p_ahead", &f.width, float("texels"), "entry point, biased in the direction");
        (p, b.output("farthest", idx, TEXELS, "a texel that the ray does not get beyond"))
    });

    b.section(
        "slope",
        "Direction dn * R, with R = 1 / M rounded to a float, and its reciprocal M / dn; M = 2^HEIGHT_W - 1.",
    );
    let r = b.inst(&div, "u_div", &[], &[("a", bottom(&b, &f, &height)), ("b", dn)]).only();
    let by_bottom = recip_of_bottom(&b, &f, &height);
    let direction = b.inst(&fp_mul(d.format, d.latency.mul), "u_mul", &[], &[("a", dn), ("b", by_bottom)]).only();
    let r = r.named("height_per_texel").doc("M / dn [float, height codes per texel]");
    let direction = direction.named("direction").doc("dn * R, rounded once more [float, texels per height code]");
    let dn_exp = dn.slice(f.man.clone(), f.exp.clone());
    let is_zero = dn_exp.none().named("is_zero").doc("dn is zero");
    let never = (r.slice(f.man.clone(), f.exp.clone()).all() | is_zero)
        .named("never_moves")
        .doc("dn is zero, or so small that M / dn overflows");
    b.drive(o_r, r);
    b.drive(o_d, direction);
    b.drive(o_never, never);

    b.section("bias", "A power of two above the error of an estimated position, applied against the direction.");
    let neg = dn.msb().named("neg");
    let bias_exp = bias_exponent(&b, d, &f, &levels, dn_exp);
    let add = fp_add(d.format, d.latency.add);
    let bias = |sign, net: &str| {
        let bias = b.cat(&[sign, bias_exp, b.zeros(&f.man)]).named(net);
        bias.reg_if(d.latency.has(Register::Bias))
    };
    let back = b
        .inst(
            &add,
            "u_back",
            &[],
            &[("a", p), ("b", bias((!neg).named("forward").doc("sign of the bias: against the direction"), "bias"))],
        )
        .only();
    b.drive(o_back, back.named("moved_back").doc("p + bias [float]"));

    if let Some((o_p, o_farthest)) = o_ahead {
        b.section(
            "ahead",
            "The same bias along the direction. A direction that underflows to 0 says nothing about the way: then the \
             end of the ray.",
        );
        let moved = b.inst(&add, "u_ahead", &[], &[("a", p), ("b", bias(neg, "bias_ahead"))]).only();
        let begin = is_zero.mux(p, moved.named("moved_ahead").doc("p + bias_ahead [float]")).named("begin_point");
        let end = b.inst(&add, "u_whole", &[], &[("a", begin), ("b", dn)]).only();
        let end = end.named("end_point").doc("begin_point + dn [float]");
        let no_direction = direction.slice(f.man.clone(), f.exp.clone()).none().named("no_direction");
        let to = fp_to_int(d.format, t.idx_bits(), d.latency.to_int);
        let texel = b.inst(&to, "u_farthest", &[("INT_W", idx.expect("a trim has it"))], &[("a", end)]).only();
        b.drive(o_p, no_direction.mux(end, begin).named("begin_ahead"));
        b.drive(o_farthest, texel.named("end_texel").doc("floor of end_point [texels]"));
    }
    let at = |l: i64, h: i64| Binding::from([("LEVELS".into(), l), ("HEIGHT_W".into(), h)]);
    let fmt = Binding::from([("EXP_W".into(), 8), ("MAN_W".into(), 23)]);
    b.finish(&[at(2, 8), at(12, 8), at(12, 16), at(2, 2), fmt])
}

/// M = 2^HEIGHT_W - 1, encoded: the ray parameter at the bottom plane.
fn bottom<'b>(b: &'b Builder, f: &FormatParams, height: &Expr) -> Sig<'b> {
    let exp = b.konst(f.bias() + height - 1, &f.exp).named("m_exp").doc("biased exponent of M = 2^HEIGHT_W - 1");
    let frac = b.konst(f.man.pow2() - (&f.man - height + 1).pow2(), &f.man).named("m_frac").doc("fraction field of M");
    b.cat(&[b.zeros(1), exp, frac])
}

/// 1 / M, encoded: its significand is rounded to nearest.
fn recip_of_bottom<'b>(b: &'b Builder, f: &FormatParams, height: &Expr) -> Sig<'b> {
    let exp = b.konst(f.bias() - height, &f.exp).named("recip_exp").doc("biased exponent of 1 / M");
    let two_m = height.pow2() * 2 - 2;
    let significand = ((height + &f.man + 1).pow2() + height.pow2() - 1).div(two_m);
    b.cat(&[
        b.zeros(1),
        exp,
        b.konst(significand, &f.man)
            .named("recip_sig")
            .doc("significand of 1 / M: 2^(HEIGHT_W + MAN_W) / M, to nearest; never a tie"),
    ])
}

/// Exponent of the bias: that of LEVELS + 2, or of 2^5 times the travel `dn`, less the bits of a significand.
fn bias_exponent<'b>(b: &'b Builder, d: &Design, f: &FormatParams, levels: &Expr, dn_exp: Sig<'b>) -> Sig<'b> {
    let wide = &f.exp + 1;
    let step = |v: Sig<'b>| v.reg_if(d.latency.has(Register::BiasStep));
    let least = b
        .konst(f.bias() + levels + 2, &wide)
        .named("least_exp")
        .doc("biased exponent of 2^(LEVELS + 2), four times the side of the map");
    let error_exp = step((dn_exp.zext(&wide) + b.lit(5, &wide)).named("error_exp").doc("exponent of 2^5 dn"));
    let top = step(least.lt(error_exp).mux(error_exp, least).named("bias_top").doc("the larger of the two exponents"));
    let exp = (top - b.konst(&f.man + 1, &wide).named("sig_w").doc("bits of a significand"))
        .named("bias_exp")
        .doc("exponent of the bias, never negative");
    b.unused(exp.msb());
    exp.slice(0, f.exp.clone())
}
