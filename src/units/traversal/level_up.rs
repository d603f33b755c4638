//! `level_up`: does a crossing go one level up? (PIDM-HW section 3.3; the rules stand in `docs/datapath.md`.)
use super::params::{LevelParams, bindings, index_width};
use crate::quantity::{BIT, LEVELS, TEXELS};
use reliefrtl_config::{Design, LevelUp, Register};
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// Whether the rule asks if the crossed plane bounds the parent node too: whether its index is even.
pub fn reads_parity(d: &Design) -> bool {
    matches!(d.mode.level_up, LevelUp::Tevs | LevelUp::Selective)
}

/// Builds `level_up` of the design's rule where planes are compared: of the selective rule, the distance of two nodes and what it says are long in
/// series. `None` for the rule that never ascends.
pub fn level_up(d: &Design) -> Option<Arc<Module>> {
    build(d, [Register::NodeDistance, Register::Neighbour].map(|r| d.latency.has(r)))
}

/// The same, combinational.
pub fn level_up_at_once(d: &Design) -> Option<Arc<Module>> {
    build(d, [false; 2])
}

/// `cuts`: whether registers stand after the distance and after what it says.
fn build(d: &Design, cuts: [bool; 2]) -> Option<Arc<Module>> {
    let (t, rule) = (&d.traverse, d.mode.level_up);
    let text = match rule {
        LevelUp::None => return None,
        LevelUp::Tevs => "level-up test: the crossing leaves the parent node",
        LevelUp::Selective => "level-up test: the crossing leaves the parent, and the predicted hit is no neighbour",
        LevelUp::Coherent => "level-up test: the iteration before was a crossing too",
        LevelUp::Always => "level-up test: every crossing goes up",
    };
    let b = Builder::new("level_up", file!(), text);
    b.choice("level_up", rule.word());
    let LevelParams { levels, level_w } = LevelParams::declare(&b, t);
    if rule == LevelUp::Selective && cuts[0] {
        b.clock();
        b.clock_enable();
    }
    let level = b.input("level", &level_w, LEVELS, "level of the crossed node");
    let below_root = level.eq(b.konst(&levels, &level_w).named("root").doc("the root's level"));
    let below_root = (!below_root).named("below_root");
    let go = match rule {
        LevelUp::None => unreachable!("returned above"),
        LevelUp::Always => None,
        LevelUp::Coherent => Some(b.input("prev_crossed", 1, BIT, "the iteration before was a crossing")),
        LevelUp::Tevs => Some(b.input("even", 1, BIT, "the crossed plane also bounds the parent")),
        LevelUp::Selective => {
            let idx = index_width(&b, t, Some(&levels));
            let even = b.input("even", 1, BIT, "the crossed plane also bounds the parent");
            let ends = ["x", "y"].map(|axis| {
                let at = b.input(&format!("{axis}_at"), &idx, TEXELS, "a texel of the node");
                (axis, at, b.input(&format!("{axis}_hit"), &idx, TEXELS, "predicted hit"))
            });
            let near = ends.map(|(axis, at, hit)| distance(&b, at, hit, level, axis, cuts));
            let neighbour = near[0].1 & near[1].1 & !(near[0].0 & near[1].0);
            Some(even & !neighbour.named("is_neighbour"))
        }
    };
    let out = b.output("up", 1, BIT, "one level up; never at the root");
    b.drive(out, go.map_or(below_root, |g| g & below_root));
    Some(b.finish(&bindings()))
}

/// (same node, at most one node apart) along one axis. Both texels stay where they are, with what lies below the node cleared: the difference
/// is then a multiple of the node's side, and nothing has to be shifted down.
fn distance<'b>(
    b: &'b Builder,
    at: Sig<'b>,
    hit: Sig<'b>,
    level: Sig<'b>,
    axis: &str,
    cuts: [bool; 2],
) -> (Sig<'b>, Sig<'b>) {
    let n = |what: &str| format!("{axis}_{what}");
    let wide = at.width() + 1;
    let keep = b.ones(&wide).shift_left(level).named(&n("keep"));
    let corner = |texel: Sig<'b>, name: &str| (texel.sext(&wide) & keep).named(&n(name));
    let diff = (corner(hit, "hit_corner") - corner(at, "corner")).named(&n("diff")).reg_if(cuts[0]);
    let keep = keep.reg_if(cuts[0]);
    let side = (keep & !b.cat(&[keep.slice(0, at.width()), b.zeros(1)])).named(&n("side"));
    let same = diff.none().named(&n("same"));
    let one = diff.eq(side);
    let minus_one = diff.eq(keep);
    let near = (same | one | minus_one).named(&n("near"));
    (same.reg_if(cuts[1]), near.reg_if(cuts[1]))
}
