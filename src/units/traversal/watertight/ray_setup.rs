//! `ray_setup`: once per ray, from texture coordinates to texels and height codes (PIDM-HW section 4.2, mode 1).
//!
//! Per axis: entry point in texels, the same biased backwards, direction per height code, reciprocal slope, sign, and
//! first texel; for both: the start level. What each is, to the bit: `docs/datapath.md`, "Once per ray".
use crate::config::{Design, LatencyConfig, Trim};
use crate::ir::{Binding, Builder, Expr, Module, Sig};
use crate::units::float::{Fields, FormatParams, fp_add, fp_div, fp_mul, fp_to_int};
use crate::units::traversal::{finest_level, start_level};
use std::sync::Arc;

/// Clocks through `ray_setup`; at least one, so that a ready never follows from a valid in the same clock.
pub fn latency(d: &Design) -> u32 {
    let l: &LatencyConfig = &d.latency;
    let start = if d.mode.start_level { l.add + l.to_int + l.setup } else { l.to_int };
    let ahead = if d.mode.trim == Trim::None { 0 } else { bias_clocks(l) + 2 * l.add + l.to_int };
    scale_clocks(l) + l.div.max(l.mul).max(bias_clocks(l) + l.add).max(start).max(ahead).max(1)
}

/// The scaled ray has a register of its own where a node has one.
fn scale_clocks(l: &LatencyConfig) -> u32 {
    l.node.min(1)
}

/// The bias too: it waits for the scaled exponent, and a sum waits for it. Its own sum, comparison and difference can have a clock each.
fn bias_clocks(l: &LatencyConfig) -> u32 {
    l.node.min(1) + 2 * l.setup
}

/// What setup computes for one axis.
struct Axis<'b> {
    name: &'static str,
    ok: Sig<'b>,
    p: Sig<'b>,
    p_back: Sig<'b>,
    d: Sig<'b>,
    r: Sig<'b>,
    never: Sig<'b>,
    neg: Sig<'b>,
    first: Sig<'b>,
    last: Option<Sig<'b>>,
    /// Entry point for a chord's end, and a texel that the ray does not get beyond.
    ahead: Option<[Sig<'b>; 2]>,
}

/// Widths and sizes that both axes use.
struct Sizes {
    f: FormatParams,
    levels: Expr,
    height: Expr,
    tile: Expr,
    idx: Expr,
}

/// Builds `ray_setup`.
pub fn ray_setup(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b =
        Builder::new("ray_setup", file!(), "a ray's constants, from texture coordinates to texels and height codes");
    b.note("A ray that can't be traced (see ok) has all other outputs 0.");
    let f = FormatParams::declare(&b, d.format);
    let levels = crate::units::traversal::params::LevelParams::declare(&b, t);
    let height = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
    let tile = b.param("TILE_W", t.tile_bits, "a ray travels less than 2^TILE_W tiles along each axis");
    crate::units::traversal::params::ray_conditions(&b, d, &f, &levels.levels, &height, &tile);
    let idx = b.local("IdxW", &levels.levels + &tile + 2);
    let s = Sizes { f, levels: levels.levels.clone(), height, tile, idx };
    b.clock();
    b.clock_enable();
    let u = b.input("u", &s.f.width, "float, tiles", "entry point at the top plane, 0 <= u < 1");
    let v = b.input("v", &s.f.width, "float, tiles", "entry point at the top plane, 0 <= v < 1");
    let du = b.input("du", &s.f.width, "float, tiles", "u travelled while the height falls from 1 to 0");
    let dv = b.input("dv", &s.f.width, "float, tiles", "v travelled while the height falls from 1 to 0");
    let lod = d.mode.lod.then(|| b.input("lod", &levels.level_w, "levels", "finest level; above LEVELS it is LEVELS"));
    let o_ok = b.output("ok", 1, "bit", "the ray can be traced: finite, entry in the tile, direction below 2^TILE_W");
    let o_level = b.output("level", &levels.level_w, "levels", "level of the first iteration");
    let outs = ["x", "y"].map(|a| {
        let of = |n: &str, w: &Expr, unit: &str, doc: &str| b.output(&format!("{n}_{a}"), w, unit, doc);
        let mut outs = vec![
            of("p", &s.f.width, "float, texels", "entry point"),
            of("pb", &s.f.width, "float, texels", "entry point, biased backwards"),
            of("d", &s.f.width, "float, texels per height code", "direction"),
            of("r", &s.f.width, "float, height codes per texel", "reciprocal direction"),
            of("never", &Expr::from(1), "bit", "the ray does not move along this axis"),
            of("neg", &Expr::from(1), "bit", "it runs toward smaller coordinates"),
            of("first", &s.idx, "texels", "texel of the entry point"),
        ];
        if d.mode.trim != Trim::None {
            outs.push(of("pf", &s.f.width, "float, texels", "entry point, biased forward"));
            outs.push(of("le", &s.idx, "texels", "a texel that the ray does not get beyond"));
        }
        outs
    });
    let o_lod = d.mode.lod.then(|| b.output("finest", &levels.level_w, "levels", "finest level, in the pyramid"));
    let axes = [axis(&b, d, &s, "x", u, du), axis(&b, d, &s, "y", v, dv)];
    b.section("level", "");
    let level = match (axes[0].last, axes[1].last) {
        (Some(x_end), Some(y_end)) => {
            let (x, y) = (axes[0].first, axes[1].first);
            let ins = [("x", x), ("y", y), ("x_end", x_end), ("y_end", y_end)];
            let start = b.inst(&start_level(t), "u_start_level", &[("IDX_W", s.idx.clone())], &ins)[0].named("start");
            if d.latency.setup > 0 { start.reg() } else { start }
        }
        _ => b.konst(&s.levels, &levels.level_w).named("root"),
    };
    let l = latency(d);
    // Of unknown words it is not known whether they are a ray: then it is refused.
    let ok = (axes[0].ok & axes[1].ok).named("is_ok").decided(false).at(l);
    b.drive(o_ok, ok, Some(l));
    let gate = |v: Sig<'_>| -> crate::ir::NodeId { (v.at(l) & ok.rep(v.width())).id() };
    let mut level = level;
    if let Some((lod, o_lod)) = lod.zip(o_lod) {
        let o = b.inst(&finest_level(t), "u_finest", &[], &[("lod", lod), ("start", level)]);
        level = o[1].named("first_level");
        b.drive(o_lod, b.sig(gate(o[0].named("finest"))), Some(l));
    }
    b.drive(o_level, b.sig(gate(level)), Some(l));
    for (a, o) in axes.iter().zip(outs) {
        b.section(&format!("axis {}", a.name), "");
        let words = [a.p, a.p_back, a.d, a.r, a.never, a.neg, a.first];
        for (port, v) in o.into_iter().zip(words.into_iter().chain(a.ahead.into_iter().flatten())) {
            b.drive(port, b.sig(gate(v)), Some(l));
        }
    }
    let at = |l: i64, h: i64| Binding::from([("LEVELS".into(), l), ("HEIGHT_W".into(), h)]);
    let fmt = Binding::from([("EXP_W".into(), 8), ("MAN_W".into(), 23)]);
    b.finish(Some(l), &[at(2, 8), at(12, 8), at(12, 16), at(2, 2), fmt])
}

fn axis<'b>(b: &'b Builder, d: &Design, s: &Sizes, name: &'static str, p_in: Sig<'b>, d_in: Sig<'b>) -> Axis<'b> {
    let f = &s.f;
    let n = |what: &str| format!("{name}_{what}");
    b.section(&n("scale"), "Times 2^LEVELS: the exponent grows; zeros stay zeros.");
    let (fp, fd) = (Fields::of(f, p_in, &n("p_in")), Fields::of(f, d_in, &n("d_in")));
    let one = b.konst(f.bias(), &f.exp).named("one_exp");
    let far = b.konst(f.bias() + &s.tile, &f.exp).named("far_exp");
    let ok = ((fp.is_zero | (!fp.sign & fp.exp.lt(one))) & fd.exp.lt(far)).named(&n("ok"));
    b.unused(b.cat(&[fp.is_inf, fp.is_nan, fd.is_inf, fd.is_nan]));
    let grow = b.konst(&s.levels, &f.exp).named("grow");
    let scaled = |x: &Fields<'b>, sign: Sig<'b>, net: &str| {
        let keep = (!x.is_zero).rep(&f.exp + &f.man);
        b.cat(&[sign, b.cat(&[x.exp + grow, x.frac]) & keep]).named(&n(net)).id()
    };
    let cut = |v: Sig<'b>| if scale_clocks(&d.latency) > 0 { v.reg() } else { v };
    let p = cut(b.sig(scaled(&fp, b.zeros(1), "p")));
    let dn = cut(b.sig(scaled(&fd, fd.sign, "dn")));
    let neg = fd.sign;

    b.section(&n("slope"), "In height codes: d / M and its reciprocal, M = 2^HEIGHT_W - 1.");
    let m_exp = b.konst(f.bias() + &s.height - 1, &f.exp).named("m_exp");
    let m_frac = b.konst(f.man.pow2() - (&f.man - &s.height + 1).pow2(), &f.man).named("m_frac");
    let m = b.cat(&[b.zeros(1), m_exp, m_frac]);
    let div = fp_div(d.format, &d.latency);
    // A divider of many stages needs as many rows to cut: what it asks of MAN_W holds here too.
    div.checks.iter().for_each(|c| b.require(&c.lhs, &c.rhs));
    let r = b.inst(&div, &format!("u_{name}_div"), &[], &[("a", m), ("b", dn)])[0].named(&n("r"));
    let c_exp = b.konst(f.bias() - &s.height, &f.exp).named("recip_exp");
    let two_m = s.height.pow2() * 2 - 2;
    let c_sig = ((&s.height + &f.man + 1).pow2() + s.height.pow2() - 1).div(two_m);
    let c_frac = b.konst(c_sig, &f.man).named("recip_frac");
    let c = b.cat(&[b.zeros(1), c_exp, c_frac]);
    let dt = b.inst(&fp_mul(d.format, d.latency.mul), &format!("u_{name}_mul"), &[], &[("a", dn), ("b", c)])[0]
        .named(&n("d"));
    let r_inf = r.slice(f.man.clone(), f.exp.clone()).all();
    let dn_zero = fd.is_zero;
    let never = (r_inf | dn_zero).named(&n("never"));

    b.section(&n("bias"), "A power of two above the position estimate's error, subtracted against the direction.");
    let wide = &f.exp + 1;
    let least = b.konst(f.bias() + &s.levels + 2, &wide).named("least");
    let dn_exp = dn.slice(f.man.clone(), f.exp.clone());
    let step = |v: Sig<'b>| if d.latency.setup > 0 { v.reg() } else { v };
    let reach = step((dn_exp.zext(&wide) + b.lit(5, &wide)).named(&n("reach")));
    let top = step(least.lt(reach).mux(reach, least).named(&n("bias_top")));
    let b_exp = (top - b.konst(&f.man + 1, &wide).named("ulps")).named(&n("bias_exp"));
    b.unused(b_exp.msb());
    let cut = |v: Sig<'b>| if d.latency.node > 0 { v.reg() } else { v };
    let bias = b.cat(&[(!neg).named(&n("forward")), b_exp.slice(0, f.exp.clone()), b.zeros(&f.man)]).named(&n("bias"));
    let bias = cut(bias);
    let add = fp_add(d.format, d.latency.add);
    let p_back = b.inst(&add, &format!("u_{name}_back"), &[], &[("a", p), ("b", bias)])[0].named(&n("pb"));

    b.section(&n("texels"), "");
    let to = fp_to_int(d.format, d.traverse.idx_bits(), d.latency.to_int);
    let int = [("INT_W", s.idx.clone())];
    let first = b.inst(&to, &format!("u_{name}_first"), &int, &[("a", p)])[0].named(&n("first"));
    let last = d.mode.start_level.then(|| {
        let end = b.inst(&add, &format!("u_{name}_end"), &[], &[("a", p), ("b", dn)])[0].named(&n("end"));
        b.inst(&to, &format!("u_{name}_last"), &int, &[("a", end)])[0].named(&n("last"))
    });
    let ahead = (d.mode.trim != Trim::None).then(|| {
        b.section(
            &n("ahead"),
            "The same bias along the direction. A direction too small for a number says nothing: then the whole way.",
        );
        let bias = cut(b.cat(&[neg, b_exp.slice(0, f.exp.clone()), b.zeros(&f.man)]).named(&n("bias_ahead")));
        let moved = b.inst(&add, &format!("u_{name}_ahead"), &[], &[("a", p), ("b", bias)])[0].named(&n("moved"));
        let begin = dn_zero.mux(p, moved).named(&n("begin"));
        let end = b.inst(&add, &format!("u_{name}_whole"), &[], &[("a", begin), ("b", dn)])[0].named(&n("whole"));
        let no_d = dt.slice(f.man.clone(), f.exp.clone()).none().named(&n("no_d"));
        let le = b.inst(&to, &format!("u_{name}_le"), &int, &[("a", end)])[0].named(&n("le"));
        [no_d.mux(end, begin).named(&n("pf")), le]
    });
    Axis { name, ok, p, p_back, d: dt, r, never, neg, first, last, ahead }
}
