//! `axis_slope`: a ray's constants along one axis, from entry point and travel in texels. What each is, to the bit: `docs/datapath.md`, "Once
//! per ray".
use crate::config::{Design, LatencyConfig, Trim};
use crate::ir::{Binding, Builder, Module, Sig};
use crate::units::float::{FormatParams, fp_add, fp_div, fp_mul, fp_to_int};
use crate::units::traversal::params::{LevelParams, index_width};
use std::sync::Arc;

/// Clocks through `axis_slope`.
pub fn latency(d: &Design) -> u32 {
    let l: &LatencyConfig = &d.latency;
    let ahead = if d.mode.trim == Trim::None { 0 } else { bias_clocks(l) + 2 * l.add + l.to_int };
    l.div.max(l.mul).max(bias_clocks(l) + l.add).max(ahead)
}

/// The bias waits for the scaled exponent, and a sum waits for it. Its own sum, comparison and difference can have a clock each.
fn bias_clocks(l: &LatencyConfig) -> u32 {
    l.node.min(1) + 2 * l.setup
}

/// Builds `axis_slope`.
pub fn axis_slope(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b =
        Builder::new("axis_slope", file!(), "a ray's constants along one axis: slope, its reciprocal, biased entry");
    let f = FormatParams::declare(&b, d.format);
    let levels = LevelParams::declare(&b, t).levels;
    let height = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
    let trims = d.mode.trim != Trim::None;
    let idx = trims.then(|| index_width(&b, t, None));
    b.require(2, &height);
    b.require(&height, 16);
    b.require(&height, &f.man + 1);
    b.require(7, &f.man);
    b.require(&height + 2, f.bias());
    b.require(&f.man, f.bias() + &levels);
    b.require(&levels + 2, f.bias());
    if let Some(idx) = &idx {
        b.require(2, idx);
        b.require(idx - 1, f.bias());
        // What underflows must stay below the bias of a chord's end.
        b.require(&f.man + 4, f.bias());
    }
    b.clock();
    b.clock_enable();
    let p = b.input("p", &f.width, "float, texels", "entry point");
    let dn = b.input("dn", &f.width, "float, texels", "travel down to the bottom plane");
    let o_back = b.output("p_back", &f.width, "float, texels", "entry point, biased backwards");
    let o_d = b.output("d", &f.width, "float, texels per height code", "direction");
    let o_r = b.output("r", &f.width, "float, height codes per texel", "reciprocal direction");
    let o_never = b.output("never", 1, "bit", "the ray does not move along this axis");
    let o_ahead = idx.as_ref().map(|idx| {
        let p = b.output("p_ahead", &f.width, "float, texels", "entry point, biased forward");
        (p, b.output("farthest", idx, "texels", "a texel that the ray does not get beyond"))
    });
    let l = latency(d);

    b.section("slope", "In height codes: d / M and its reciprocal, M = 2^HEIGHT_W - 1.");
    let m_exp = b.konst(f.bias() + &height - 1, &f.exp).named("m_exp");
    let m_frac = b.konst(f.man.pow2() - (&f.man - &height + 1).pow2(), &f.man).named("m_frac");
    let m = b.cat(&[b.zeros(1), m_exp, m_frac]);
    let div = fp_div(d.format, &d.latency);
    // A divider of many stages needs as many rows to cut: what it asks of MAN_W holds here too.
    div.checks.iter().for_each(|c| b.require(&c.lhs, &c.rhs));
    let r = b.inst(&div, "u_div", &[], &[("a", m), ("b", dn)])[0].named("height_per_texel");
    let c_exp = b.konst(f.bias() - &height, &f.exp).named("recip_exp");
    let two_m = height.pow2() * 2 - 2;
    let c_sig = ((&height + &f.man + 1).pow2() + height.pow2() - 1).div(two_m);
    let c = b.cat(&[b.zeros(1), c_exp, b.konst(c_sig, &f.man).named("recip_frac")]);
    let dt = b.inst(&fp_mul(d.format, d.latency.mul), "u_mul", &[], &[("a", dn), ("b", c)])[0].named("direction");
    let is_zero = dn.slice(f.man.clone(), f.exp.clone()).none().named("is_zero");
    let never = (r.slice(f.man.clone(), f.exp.clone()).all() | is_zero).named("never_moves");
    b.drive(o_r, r, Some(l));
    b.drive(o_d, dt, Some(l));
    b.drive(o_never, never, Some(l));

    b.section("bias", "A power of two above the position estimate's error, subtracted against the direction.");
    let neg = dn.msb().named("neg");
    let wide = &f.exp + 1;
    let least = b.konst(f.bias() + &levels + 2, &wide).named("least");
    let step = |v: Sig<'_>| if d.latency.setup > 0 { v.reg().id() } else { v.id() };
    let error_exp = dn.slice(f.man.clone(), f.exp.clone()).zext(&wide) + b.lit(5, &wide);
    let error_exp = b.sig(step(error_exp.named("error_exp")));
    let top = b.sig(step(least.lt(error_exp).mux(error_exp, least).named("bias_top")));
    let b_exp = (top - b.konst(&f.man + 1, &wide).named("ulps")).named("bias_exp");
    b.unused(b_exp.msb());
    let cut = |v: Sig<'_>| if d.latency.node > 0 { v.reg().id() } else { v.id() };
    let bias = |sign: Sig<'_>, net: &str| {
        let sign = b.sig(sign.id());
        b.sig(cut(b.cat(&[sign, b_exp.slice(0, f.exp.clone()), b.zeros(&f.man)]).named(net))).id()
    };
    let add = fp_add(d.format, d.latency.add);
    let back = b.sig(bias((!neg).named("forward"), "bias"));
    let back = b.inst(&add, "u_back", &[], &[("a", p), ("b", back)])[0].named("moved_back");
    b.drive(o_back, back, Some(l));

    if let Some((o_p, o_farthest)) = o_ahead {
        b.section(
            "ahead",
            "The same bias along the direction. A direction too small for a number says nothing: then the whole way.",
        );
        let moved = b.inst(&add, "u_ahead", &[], &[("a", p), ("b", b.sig(bias(neg, "bias_ahead")))])[0].named("moved");
        let begin = is_zero.mux(p, moved).named("begin_point");
        let end = b.inst(&add, "u_whole", &[], &[("a", begin), ("b", dn)])[0].named("whole_way");
        let no_d = dt.slice(f.man.clone(), f.exp.clone()).none().named("no_d");
        let to = fp_to_int(d.format, t.idx_bits(), d.latency.to_int);
        let int = [("INT_W", idx.expect("a trim has it"))];
        b.drive(o_p, no_d.mux(end, begin).named("begin_ahead"), Some(l));
        b.drive(o_farthest, b.inst(&to, "u_farthest", &int, &[("a", end)])[0].named("end_texel"), Some(l));
    }
    let at = |l: i64, h: i64| Binding::from([("LEVELS".into(), l), ("HEIGHT_W".into(), h)]);
    let fmt = Binding::from([("EXP_W".into(), 8), ("MAN_W".into(), 23)]);
    b.finish(Some(l), &[at(2, 8), at(12, 8), at(12, 16), at(2, 2), fmt])
}
