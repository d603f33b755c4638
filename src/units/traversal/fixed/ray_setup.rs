//! `ray_setup`: once per ray, from texture coordinates to what the loop compares (PIDM-HW section 4.2, mode 1).
//!
//! Per axis: entry point, travel per height code, reciprocal and its shift, sign, and first texel; for both: the start
//! level. What each is, to the bit: `docs/fixed.md`, "Once per ray".
use super::params::{LENGTH, Params, bindings, shift_width};
use super::reciprocal::reciprocal;
use crate::quantity::{BIT, BITS, LEVELS, Quantity, TEXELS, integer};
use crate::traversal::cells::cells_level;
use crate::traversal::finest_level::finest_doc;
use crate::traversal::{finest_level, start_level};
use reliefrtl_config::{Design, Register, Trim};
use reliefrtl_ir::{Builder, Expr, Module, NodeId, Sig};
use std::sync::Arc;

/// What setup computes for one axis.
struct Axis<'b> {
    ok: Sig<'b>,
    /// In the order of the ports; the first texel after them.
    words: [Sig<'b>; 5],
    first: Option<Sig<'b>>,
    last: Option<Sig<'b>>,
    /// A texel that the ray does not get beyond.
    far: Option<Sig<'b>>,
}

/// Widths that both axes use.
struct Sizes {
    f: Expr,
    w: Expr,
    n: Expr,
    h: Expr,
    reach: Expr,
    idx: Expr,
}

/// Builds `ray_setup`.
pub fn ray_setup(d: &Design) -> Arc<Module> {
    let b = Builder::new("ray_setup", file!(), "a ray's constants, from texture coordinates to what the loop compares");
    b.note("A ray that can't be traced (see ok) has all other outputs 0.");
    let of = Params { b: &b, d };
    let f = of.fraction();
    let w = of.recip();
    let n = of.levels(&f);
    let h = of.height(&f);
    let (tile, reach) = of.reach(&f);
    let idx = of.index(&n, &tile);
    let level_w = b.local("LevelW", (&n + 1).clog2());
    let shift_w = b.local("ShiftW", shift_width(&reach));
    b.clock();
    b.clock_enable();
    let u = b.input("u", &f, LENGTH, "entry point at the top plane");
    let v = b.input("v", &f, LENGTH, "entry point at the top plane");
    let du = b.input("du", &reach + 1, LENGTH, "u travelled while the height falls from 1 to 0, signed");
    let dv = b.input("dv", &reach + 1, LENGTH, "v travelled while the height falls from 1 to 0, signed");
    let lod = d.mode.lod.then(|| b.input("lod", &level_w, LEVELS, finest_doc(d)));
    let o_ok = b.output("ok", 1, BIT, "the ray can be traced: no travel is the most negative word");
    // A search by windows knows no level, and takes the first texel from the entry point.
    let nodes = d.datapath.kind.facts().reads_nodes;
    let o_level = nodes.then(|| b.output("level", &level_w, LEVELS, "level of the first iteration"));
    let outs = ["x", "y"].map(|a| {
        let of = |n: &str, w: &Expr, unit: Quantity, doc: &str| b.output(&format!("{n}_{a}"), w, unit, doc);
        let mut outs = vec![
            of("p", &f, LENGTH, "entry point"),
            of("s", &(&reach + 1), integer("2^-(FRACTION_W+HEIGHT_W) tiles"), "travel per height code, its magnitude"),
            of("r", &w, integer("a number of RECIP_W bits"), "reciprocal of the travel"),
            of("z", &shift_w, BITS, "its power of two"),
            of("neg", &Expr::from(1), BIT, "the ray runs toward smaller coordinates"),
        ];
        if nodes {
            outs.push(of("first", &idx, TEXELS, "texel of the entry point"));
        }
        if d.mode.trim != Trim::None {
            outs.push(of("le", &idx, TEXELS, "a texel that the ray does not get beyond"));
        }
        outs
    });
    let o_lod = d.mode.lod.then(|| b.output("finest", &level_w, LEVELS, "finest level, in the pyramid"));
    let s = Sizes { f, w, n, h, reach, idx };
    let axes = [axis(&b, d, &s, "x", u, du), axis(&b, d, &s, "y", v, dv)];
    // Of unknown words it is not known whether they are a ray: then it is refused. The register is the one clock at least that keeps a ready from
    // following from a valid in the same clock.
    let ok = (axes[0].ok & axes[1].ok).named("is_ok").decided(false);
    let l = b.latest(axes.iter().flat_map(|a| a.words).chain([ok]));
    let ok = ok.at(l);
    b.drive(o_ok, ok);
    let gate = |v: Sig<'_>| -> NodeId { (v.at(l) & ok.rep(v.width())).id() };
    if let Some(o_level) = o_level {
        b.section("acceptance and level", "");
        let level = match (axes[0].last, axes[1].last) {
            (Some(x_end), Some(y_end)) => {
                let first = |k: usize| axes[k].first.expect("with the nodes' level comes a first texel");
                let ins = [("x", first(0)), ("y", first(1)), ("x_end", x_end), ("y_end", y_end)];
                let unit = start_level(&d.traverse);
                b.inst(&unit, "u_start_level", &[("IDX_W", s.idx.clone())], &ins).only().named("start")
            }
            _ => b.konst(&s.n, &level_w).named("root"),
        };
        let mut level = if d.fetch.blocks() { cells_level(level) } else { level };
        if let Some((lod, o_lod)) = lod.zip(o_lod) {
            let o = b.inst(&finest_level(d), "u_finest", &[], &[("lod", lod), ("start", level)]);
            level = o["level"].named("first_level");
            b.drive(o_lod, b.sig(gate(o["finest"].named("finest"))));
        }
        b.drive(o_level, b.sig(gate(level)));
    }
    for (name, (a, o)) in ["x", "y"].iter().zip(axes.iter().zip(outs)) {
        b.section(&format!("axis {name}"), "");
        for (port, v) in o.into_iter().zip(a.words.into_iter().chain(a.first).chain(a.far)) {
            b.drive(port, b.sig(gate(v)));
        }
    }
    b.finish(&bindings())
}

fn axis<'b>(b: &'b Builder, d: &Design, s: &Sizes, name: &str, p: Sig<'b>, travel: Sig<'b>) -> Axis<'b> {
    let n = |what: &str| format!("{name}_{what}");
    let (reach, idx) = (&s.reach, &s.idx);
    b.section(&n("magnitude"), "");
    let neg = travel.msb().named(&n("neg"));
    let low = travel.slice(0, reach.clone()).named(&n("low"));
    let ok = (!(neg & low.none())).named(&n("ok"));
    let flip = neg.rep(reach.clone());
    let a = ((low ^ flip) + b.cat(&[b.zeros(reach - 1), neg])).named(&n("a"));
    // The loop of a search by windows is faster than a sum and a count of zeros in series.
    let a = a.reg_if(d.datapath.kind.facts().short_loop && d.latency.has(Register::Travel));

    b.section(&n("slope"), "Height codes per length, and lengths per height code: the travel times 2^HEIGHT_W / M.");
    let o = b.inst(&reciprocal(d), &format!("u_{name}_reciprocal"), &[], &[("a", a)]);
    let (r, z) = (o["r"].named(&n("r")), o["z"].named(&n("z")));
    let tall = reach + 2;
    let mut sum = a.zext(tall.clone()).named(&n("s_0"));
    for k in 0..4u32 {
        // 2^h / M = 1 / (1 - 2^-h) = (1 + 2^-h) (1 + 2^-2h) (1 + 2^-4h) (1 + 2^-8h) ...
        // A bit more than the sum needs, so that a shift never is as wide as its word and still can leave nothing.
        let by = (s.h.clone() * (1 << k)).smaller(reach + 1);
        let by = b.konst(by, 8).named(&format!("code_{}", 1 << k));
        sum = (sum + sum.shift_right(by)).named(&n(&format!("s_{}", k + 1)));
        // The reciprocal takes longer: a register after each sum, as long as it does.
        if k < 3 && sum.stage().is_some_and(|stage| Some(stage + 1) < r.stage()) {
            sum = sum.reg();
        }
    }
    b.unused(sum.msb());
    let per_code = sum.slice(0, reach + 1).named(&n("s"));

    b.section(&n("texels"), "");
    let below = &s.f - &s.n;
    let nodes = d.datapath.kind.facts().reads_nodes;
    let first = nodes.then(|| p.slice(below.clone(), s.n.clone()).zext(idx).named(&n("first")));
    let last = (nodes && d.mode.start_level).then(|| {
        let wide = reach + 2;
        let end = (b.cat(&[b.zeros(&wide - &s.f), p]) + travel.sext(wide)).named(&n("end"));
        b.unused(end);
        end.slice(below, idx.clone()).named(&n("last"))
    });
    let far = (d.mode.trim != Trim::None).then(|| farthest(b, s, name, p, a, neg));
    let p = p.named(&n("p"));
    Axis { ok, words: [p, per_code, r, z, neg], first, last, far }
}

/// A texel that the ray does not get beyond, by the parameters of its planes.
fn farthest<'b>(b: &'b Builder, s: &Sizes, name: &str, p: Sig<'b>, a: Sig<'b>, neg: Sig<'b>) -> Sig<'b> {
    let n = |what: &str| format!("{name}_{what}");
    b.section(
        &n("farthest"),
        "The travel, and more than what the reciprocal and the rounding of a parameter add to it. No travel stays none.",
    );
    let wide = &s.reach + 2;
    let tall = a.zext(wide.clone()).named(&n("a_tall"));
    let part = |by: Expr, net: &str| tall.shift_right(b.konst(by.smaller(&s.reach), 6).named(&n(net)));
    let recip = part(&s.w - 1, "recip_part");
    let time = part(&s.f + 1, "time_part");
    let whole = (tall + recip + time + a.any().zext(&wide)).named(&n("whole"));
    let flip = neg.rep(wide.clone()).named(&n("turn"));
    // Toward smaller coordinates a texel is left when the ray is at its border.
    let end = (b.cat(&[b.zeros(&wide - &s.f), p]) ^ flip) + whole + neg.zext(&wide);
    let end = (end.named(&n("far_turned")) ^ flip).named(&n("far_end"));
    b.unused(end);
    end.slice(&s.f - &s.n, s.idx.clone()).named(&n("le"))
}
