//! `ray_setup`: once per ray, from texture coordinates to what the loop compares (PIDM-HW section 4.2, mode 1).
//!
//! Each axis has its constants (`axis_slope`) and texels (`axis_ends`); both together have the start level. What each is, to the bit:
//! `docs/fixed.md`, "Once per ray".
use super::axis_ends::axis_ends;
use super::axis_slope::{PER_CODE, axis_slope};
use super::params::{LENGTH, Params, bindings, shift_width};
use crate::quantity::{BIT, BITS, LEVELS, Quantity, TEXELS, integer};
use crate::traversal::cells::cells_level;
use crate::traversal::finest_level::finest_doc;
use crate::traversal::{finest_level, start_level};
use reliefrtl_config::{Design, Trim};
use reliefrtl_ir::{Builder, Expr, Module, NodeId, Record, Sig};
use std::sync::Arc;

/// What setup computes for one axis.
struct Axis<'b> {
    ok: Sig<'b>,
    /// By the names of the ports, without the axis.
    words: Record<'b>,
    /// The texel of the ray's end, where a start level is found.
    last: Option<Sig<'b>>,
}

/// Widths of the outputs.
struct Sizes {
    f: Expr,
    w: Expr,
    n: Expr,
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
    of.height(&f);
    let (tile, reach) = of.reach(&f);
    let idx = of.index(&n, &tile);
    let level_w = b.local("LevelW", (&n + 1).clog2(), "bits of a level");
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
    let s = Sizes { f, w, n, reach, idx };
    let outs = ["x", "y"].map(|a| outputs(&b, d, &s, a));
    let o_lod = d.mode.lod.then(|| b.output("finest", &level_w, LEVELS, "finest level, in the pyramid"));
    let axes = [axis(&b, d, &s, "x", u, du), axis(&b, d, &s, "y", v, dv)];
    b.section(if nodes { "acceptance and level" } else { "acceptance" }, "");
    // Of unknown words it is not known whether they are a ray: then it is refused. The register is the one clock at least that keeps a ready from
    // following from a valid in the same clock.
    let ok = (axes[0].ok & axes[1].ok).named("is_ok").decided(false);
    let l = b.latest(axes.iter().flat_map(|a| a.words.iter().map(|(_, v)| v)).chain([ok]));
    let ok = ok.at(l);
    b.drive(o_ok, ok);
    let gate = |v: Sig<'_>| -> NodeId { (v.at(l) & ok.rep(v.width())).id() };
    if let Some(o_level) = o_level {
        let level = match (axes[0].last, axes[1].last) {
            (Some(x_end), Some(y_end)) => {
                let (x, y) = (axes[0].words["first"], axes[1].words["first"]);
                let ins = [("x", x), ("y", y), ("x_end", x_end), ("y_end", y_end)];
                let unit = start_level(&d.traverse);
                b.inst(&unit, "u_start_level", &[("IDX_W", s.idx.clone())], &ins).only().named("start")
            }
            _ => b.konst(&s.n, &level_w).named("root").doc("the root's level"),
        };
        let mut level = if d.fetch.blocks() { cells_level(level) } else { level };
        if let Some((lod, o_lod)) = lod.zip(o_lod) {
            let o = b.inst(&finest_level(d), "u_finest", &[], &[("lod", lod), ("start", level)]);
            level = o["level"].named("first_level");
            b.drive(o_lod, b.sig(gate(o["finest"].named("finest"))));
        }
        b.drive(o_level, b.sig(gate(level)));
    }
    for (axis, ports) in axes.iter().zip(outs) {
        ports.into_iter().for_each(|(name, port)| b.drive(port, b.sig(gate(axis.words[name]))));
    }
    b.finish(&bindings())
}

/// Declares the outputs of one axis: name without the axis, and port.
fn outputs(b: &Builder, d: &Design, s: &Sizes, axis: &str) -> Vec<(&'static str, usize)> {
    let of = |name: &'static str, width: &Expr, unit: Quantity, doc: &str| {
        (name, b.output(&format!("{name}_{axis}"), width, unit, doc))
    };
    let mut list = vec![
        of("p", &s.f, LENGTH, "entry point"),
        of("s", &(&s.reach + 1), PER_CODE, "travel per height code, its magnitude"),
        of("r", &s.w, integer("a number of RECIP_W bits"), "reciprocal of the travel"),
        of("z", &shift_width(&s.reach), BITS, "its power of two"),
        of("neg", &Expr::from(1), BIT, "the ray runs toward smaller coordinates"),
    ];
    if d.datapath.kind.facts().reads_nodes {
        list.push(of("first", &s.idx, TEXELS, "texel of the entry point"));
    }
    if d.mode.trim != Trim::None {
        list.push(of("le", &s.idx, TEXELS, "a texel that the ray does not get beyond"));
    }
    list
}

fn axis<'b>(b: &'b Builder, d: &Design, s: &Sizes, name: &str, p: Sig<'b>, travel: Sig<'b>) -> Axis<'b> {
    let n = |what: &str| format!("{name}_{what}");
    b.section(&format!("axis {name}"), "");
    let is_ok = !(travel.msb() & travel.slice(0, s.reach.clone()).none());
    let ok = is_ok.named(&n("ok")).doc("the travel is not the most negative word");
    let ins = [("d", travel), ("p", p)];
    // Only a trim asks for the entry point.
    let taken = if d.mode.trim == Trim::None { &ins[..1] } else { &ins };
    let o = b.inst(&axis_slope(d), &format!("u_slope_{name}"), &[], taken);
    let ports = [("s", "s"), ("r", "r"), ("z", "z"), ("neg", "neg"), ("le", "farthest")];
    let slope = ports.iter().filter_map(|(word, port)| Some((*word, o.get(port)?.named(&n(word)))));
    let nodes = d.datapath.kind.facts().reads_nodes;
    let (first, last) = if nodes && d.mode.start_level {
        let o = b.inst(&axis_ends(d), &format!("u_ends_{name}"), &[], &ins);
        (Some(o["first"]), Some(o["last"].named(&n("last"))))
    } else {
        (nodes.then(|| p.slice(&s.f - &s.n, s.n.clone()).zext(&s.idx)), None)
    };
    let first = first.map(|v| ("first", v.named(&n("first"))));
    Axis { ok, words: slope.chain([("p", p.named(&n("p")))]).chain(first).collect(), last }
}
