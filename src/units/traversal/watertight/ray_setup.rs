//! `ray_setup`: once per ray, from texture coordinates to texels and height codes (PIDM-HW section 4.2, mode 1).
//!
//! Each axis is scaled (`axis_scale`), then its constants (`axis_slope`) and texels (`axis_ends`) are computed; for both: the start level. What
//! each is, to the bit: `docs/datapath.md`, "Once per ray".
use super::axis_ends::axis_ends;
use super::axis_scale::axis_scale;
use super::axis_slope::axis_slope;
use crate::float::{FormatParams, fp_to_int};
use crate::quantity::{BIT, LEVELS, Quantity, TEXELS, float};
use crate::traversal::cells::cells_level;
use crate::traversal::finest_level::finest_doc;
use crate::traversal::params::{LevelParams, ray_conditions};
use crate::traversal::{finest_level, start_level};
use reliefrtl_config::{Design, Register, Trim};
use reliefrtl_ir::{Binding, Builder, Expr, Module, Record, Sig};
use std::sync::Arc;

/// What setup computes for one axis.
struct Axis<'b> {
    ok: Sig<'b>,
    /// By the names of the ports, without the axis.
    words: Record<'b>,
    /// The texel of the ray's end, where a start level is found.
    last: Option<Sig<'b>>,
}

/// Builds `ray_setup`.
pub fn ray_setup(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b =
        Builder::new("ray_setup", file!(), "a ray's constants, from texture coordinates to texels and height codes");
    b.note("A ray that can't be traced (see ok) has all other outputs 0.");
    let f = FormatParams::declare(&b, d.format);
    let levels = LevelParams::declare(&b, t);
    let height = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
    let tile = b.param("TILE_W", t.tile_bits, "a ray travels less than 2^TILE_W tiles along each axis");
    ray_conditions(&b, d, &f, &levels.levels, &height, &tile);
    let idx = b.local("IdxW", &levels.levels + &tile + 2, "bits of a signed, unwrapped texel coordinate");
    b.clock();
    b.clock_enable();
    let u = b.input("u", &f.width, float("tiles"), "entry point at the top plane, 0 <= u < 1");
    let v = b.input("v", &f.width, float("tiles"), "entry point at the top plane, 0 <= v < 1");
    let du = b.input("du", &f.width, float("tiles"), "u travelled while the height falls from 1 to 0");
    let dv = b.input("dv", &f.width, float("tiles"), "v travelled while the height falls from 1 to 0");
    let lod = d.mode.lod.then(|| b.input("lod", &levels.level_w, LEVELS, finest_doc(d)));
    let o_ok = b.output("ok", 1, BIT, "the ray can be traced: finite, entry in the tile, direction below 2^TILE_W");
    let o_level = b.output("level", &levels.level_w, LEVELS, "level of the first iteration");
    let outs = ["x", "y"].map(|a| outputs(&b, d, &f, &idx, a));
    let o_lod = d.mode.lod.then(|| b.output("finest", &levels.level_w, LEVELS, "finest level, in the pyramid"));
    let axes = [axis(&b, d, &idx, "x", u, du), axis(&b, d, &idx, "y", v, dv)];
    b.section("acceptance and level", "");
    let level = match (axes[0].last, axes[1].last) {
        (Some(x_end), Some(y_end)) => {
            let (x, y) = (axes[0].words["first"], axes[1].words["first"]);
            let ins = [("x", x), ("y", y), ("x_end", x_end), ("y_end", y_end)];
            let start = b.inst(&start_level(t), "u_start_level", &[("IDX_W", idx)], &ins).only().named("start");
            start.reg_if(d.latency.has(Register::StartLevel))
        }
        _ => b.konst(&levels.levels, &levels.level_w).named("root").doc("the root's level"),
    };
    // Of unknown words it is not known whether they are a ray: then it is refused. The register is the one clock at least that keeps a ready from
    // following from a valid in the same clock.
    let ok = (axes[0].ok & axes[1].ok).named("is_ok").decided(false);
    let words = axes.iter().flat_map(|a| a.words.iter().map(|(_, v)| v));
    let l = b.latest(words.chain([level, ok]));
    let ok = ok.at(l);
    b.drive(o_ok, ok);
    let gate = |v: Sig<'_>| -> reliefrtl_ir::NodeId { (v.at(l) & ok.rep(v.width())).id() };
    let mut level = if d.fetch.blocks() { cells_level(level) } else { level };
    if let Some((lod, o_lod)) = lod.zip(o_lod) {
        let o = b.inst(&finest_level(d), "u_finest", &[], &[("lod", lod), ("start", level)]);
        level = o["level"].named("first_level");
        b.drive(o_lod, b.sig(gate(o["finest"].named("finest"))));
    }
    b.drive(o_level, b.sig(gate(level)));
    for (axis, ports) in axes.iter().zip(outs) {
        ports.into_iter().for_each(|(name, port)| b.drive(port, b.sig(gate(axis.words[name]))));
    }
    let at = |l: i64, h: i64| Binding::from([("LEVELS".into(), l), ("HEIGHT_W".into(), h)]);
    let fmt = Binding::from([("EXP_W".into(), 8), ("MAN_W".into(), 23)]);
    b.finish(&[at(2, 8), at(12, 8), at(12, 16), at(2, 2), fmt])
}

/// Declares the outputs of one axis: name without the axis, and port.
fn outputs(b: &Builder, d: &Design, f: &FormatParams, idx: &Expr, axis: &str) -> Vec<(&'static str, usize)> {
    let of = |name: &'static str, width: &Expr, unit: Quantity, doc: &str| {
        (name, b.output(&format!("{name}_{axis}"), width, unit, &doc.replace('#', axis)))
    };
    let mut list = vec![
        of("p", &f.width, float("texels"), "entry point along #"),
        of("pb", &f.width, float("texels"), "entry point along #, biased against the direction"),
        of("d", &f.width, float("texels per height code"), "direction along #"),
        of("r", &f.width, float("height codes per texel"), "reciprocal of the direction along #"),
        of("never", &Expr::from(1), BIT, "the ray does not move along #"),
        of("neg", &Expr::from(1), BIT, "the ray runs toward smaller # coordinates"),
        of("first", idx, TEXELS, "# coordinate of the texel of the entry point"),
    ];
    if d.mode.trim != Trim::None {
        list.push(of("pf", &f.width, float("texels"), "entry point along #, biased in the direction"));
        list.push(of("le", idx, TEXELS, "# coordinate of a texel that the ray does not get beyond"));
    }
    list
}

fn axis<'b>(b: &'b Builder, d: &Design, idx: &Expr, name: &str, p: Sig<'b>, travel: Sig<'b>) -> Axis<'b> {
    let n = |what: &str| format!("{name}_{what}");
    let int = |param: &'static str| [(param, idx.clone())];
    b.section(&format!("axis {name}"), "");
    let o = b.inst(&axis_scale(d), &format!("u_scale_{name}"), &[], &[("p", p), ("d", travel)]);
    let ok = o["ok"].named(&n("ok"));
    let registered = |v: Sig<'b>| v.reg_if(d.latency.has(Register::ScaledRay));
    let (p, dn) = (registered(o["p_texels"].named(&n("p"))), registered(o["d_texels"].named(&n("dn"))));

    let o = b.inst(&axis_slope(d), &format!("u_slope_{name}"), &[], &[("p", p), ("dn", dn)]);
    let ports = [("pb", "p_back"), ("d", "d"), ("r", "r"), ("never", "never"), ("pf", "p_ahead"), ("le", "farthest")];
    let slope = ports.iter().filter_map(|(word, port)| Some((*word, o.get(port)?.named(&n(word)))));

    let (first, last) = if d.mode.start_level {
        let o = b.inst(&axis_ends(d), &format!("u_ends_{name}"), &int("IDX_W"), &[("p", p), ("dn", dn)]);
        (o["first"], Some(o["last"].named(&n("last"))))
    } else {
        let to = fp_to_int(d.format, d.traverse.idx_bits(), d.latency.to_int);
        (b.inst(&to, &format!("u_first_{name}"), &int("INT_W"), &[("a", p)]).only(), None)
    };
    let rest = [("p", p), ("neg", dn.msb().named(&n("neg"))), ("first", first.named(&n("first")))];
    Axis { ok, words: slope.chain(rest).collect(), last }
}
