//! `chord_trim`: the level of the smallest node that holds the rest of the ray inside the current node.
//!
//! The chord runs from the current texel to the last one before the node's exit. That one is exact along the axis by whose plane the ray leaves;
//! along the other it is an estimate that may lie ahead of the ray and never short of it. The smallest node of both then has the same exit, and its
//! height is no larger (`docs/datapath.md`, "Chord trim").
use super::cells::cells_level;
use super::params::{LevelParams, bindings, index_width};
use super::start_level::start_level;
use crate::quantity::{BIT, LEVELS, Quantity, TEXELS};
use reliefrtl_config::{Design, Trim};
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Builds `chord_trim`, combinational; integers only, so that it serves every datapath that knows these texels.
pub fn chord_trim(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b = Builder::new("chord_trim", file!(), "level of the smallest node that holds the ray's way through this one");
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    let idx = index_width(&b, t, Some(&levels));
    let level = b.input("level", &level_w, LEVELS, "level of this node");
    let enable =
        (d.mode.trim == Trim::Descent).then(|| b.input("descended", 1, BIT, "trim: this is a descent's child"));
    let lod = d.mode.lod.then(|| b.input("lod", &level_w, LEVELS, "the finest level to go to"));
    let x_first = b.input("x_first", 1, BIT, "the ray leaves by the u plane");
    let mut axes = Vec::new();
    for axis in ["x", "y"] {
        let of =
            |what: &str, width: &Expr, unit: Quantity, doc: &str| b.input(&format!("{axis}_{what}"), width, unit, doc);
        axes.push(Axis {
            name: axis,
            at: of("at", &idx, TEXELS, "the current texel"),
            low: of("low", &idx, TEXELS, "least texel of the node that the ray has not passed"),
            high: of("high", &idx, TEXELS, "greatest texel of the node that the ray has not passed"),
            neg: of("neg", &Expr::from(1), BIT, "the ray runs toward smaller coordinates"),
            bound: of(
                "bound",
                &idx,
                TEXELS,
                "texel of the ray, or one ahead of it, where it leaves by the other axis' plane",
            ),
            last: of("last", &idx, TEXELS, "a texel that the ray does not get beyond"),
        });
    }
    let outs = ["x", "y"].map(|a| b.output(&format!("{a}_chord"), &idx, TEXELS, "the chord's far end"));
    let out = b.output("level_read", &level_w, LEVELS, "level of the node to be read");

    let ends = [axes[0].far(x_first), axes[1].far(!x_first)];
    let ins = [("x", axes[0].at), ("y", axes[1].at), ("x_end", ends[0]), ("y_end", ends[1])];
    let tight = b.inst(&start_level(t), "u_start_level", &[("IDX_W", idx)], &ins).only().named("tight");
    let tight = if d.fetch.blocks() { cells_level(tight) } else { tight };
    let kept = lod.map_or(tight, |lod| tight.lt(lod).mux(lod, tight).named("kept"));
    let read = enable.map_or(kept, |e| e.mux(kept, level).named("level_chosen"));
    if enable.is_none() {
        b.unused(level);
    }
    outs.iter().zip(ends).for_each(|(o, e)| b.drive(*o, e));
    b.drive(out, read);
    b.finish(&bindings())
}

/// What is known of one axis.
struct Axis<'b> {
    name: &'static str,
    at: Sig<'b>,
    low: Sig<'b>,
    high: Sig<'b>,
    neg: Sig<'b>,
    bound: Sig<'b>,
    last: Sig<'b>,
}

impl<'b> Axis<'b> {
    /// The chord's far end; `exits`: the ray leaves by this axis' plane, so that only its own end keeps it from the texel before the plane.
    fn far(&self, exits: Sig<'b>) -> Sig<'b> {
        let n = |what: &str| format!("{}_{what}", self.name);
        let less = self.bound.slt(self.last).named(&n("bound_is_less"));
        let whole = (exits | !(less ^ self.neg)).named(&n("whole"));
        let end = whole.mux(self.last, self.bound).named(&n("end"));
        let before = end.slt(self.low).named(&n("end_lt_low"));
        let beyond = self.high.slt(end).named(&n("beyond"));
        before.mux(self.low, beyond.mux(self.high, end)).named(&n("far"))
    }
}
