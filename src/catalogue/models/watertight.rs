//! The golden model of the units that the watertight datapath alone has, in the order of their ports.
use crate::bits::{mask, signed};
use crate::config::{Design, TraverseConfig, Trim};
use crate::golden::float as gf;
use crate::golden::{Golden, RayInput};
use crate::ir::Binding;

/// Expected outputs of `unit` for one row of inputs, as [`super::model`].
pub(super) fn model(unit: &str, d: &Design, b: &Binding, x: &[u64]) -> Vec<u64> {
    let f = d.format;
    let p = |name: &str| b[name] as u32;
    let idx = b.get("IDX_W").map_or(d.traverse.idx_bits(), |v| *v as u32);
    let s = |v: u64| signed(v, idx);
    let index = |v: i64| v as u64 & mask(idx);
    match unit {
        "plane_time" => {
            let dist = gf::add(f, gf::from_int(f, s(x[0])), gf::neg(f, x[1]));
            vec![if x[3] == 1 { f.infinity() } else { gf::mul(f, dist, x[2]) }]
        }
        "height_test" => {
            let t_v = gf::from_int(f, ((1 << p("HEIGHT_W")) - 1 - x[0]) as i64);
            vec![if gf::lt(f, x[1], t_v) { t_v } else { x[1] }, u64::from(gf::lt(f, t_v, x[1]))]
        }
        "predicted_hit" => vec![index(gf::to_int(f, gf::add(f, x[0], gf::mul(f, x[1], x[2])), idx))],
        "node_crossing" => {
            let (t, m, t_x, t_y) = (x[0], x[1], x[2], x[3]);
            let x_first = !gf::lt(f, t_y, t_x);
            let exit = if x_first { t_x } else { t_y };
            let inside = gf::lt(f, m, t_x) && gf::lt(f, m, t_y);
            vec![u64::from(inside), u64::from(x_first), if gf::lt(f, t, exit) { exit } else { t }]
        }
        "ray_setup" => {
            // The setup knows nothing of the hit position, whose bits may be too many beside it.
            let traverse = TraverseConfig { frac_bits: 1, ..d.traverse };
            let g = Golden::new(&Design { traverse, ..*d }).expect("the set's parameters are legal");
            let o = g.setup(&RayInput {
                u: x[0],
                v: x[1],
                du: x[2],
                dv: x[3],
                lod: if d.mode.lod { x[4] as u32 } else { 0 },
            });
            let mut out = vec![u64::from(o.valid), u64::from(o.level)];
            for a in [o.u, o.v] {
                out.extend([a.p, a.pb, a.dt, a.r, u64::from(a.never), u64::from(a.neg), index(a.x)]);
                if d.mode.trim != Trim::None {
                    out.extend([a.pf, index(a.le)]);
                }
            }
            if d.mode.lod {
                out.push(u64::from(o.lod));
            }
            out
        }
        "hit_position" => {
            let frac = p("FRAC_W");
            let at = gf::to_fixed(f, gf::add(f, x[0], gf::mul(f, x[1], x[2])), idx + frac, frac);
            let kept = super::node_hit(d, frac, at, s(x[3]), if d.mode.lod { x[4] } else { 0 });
            if d.mode.lod { vec![kept[1], kept[0]] } else { vec![kept[1]] }
        }
        "chord_end" => {
            let far = if x[2] == 1 { -1i64 << (idx - 1) } else { (1 << (idx - 1)) - 1 };
            let at = || gf::to_int(f, gf::add(f, x[0], gf::mul(f, x[1], x[3])), idx);
            let infinite = matches!(gf::decode(f, x[3]), gf::Value::Infinite(_) | gf::Value::Nan);
            vec![index(if infinite { far } else { at() })]
        }
        _ => super::bilinear::model(unit, d, b, x).unwrap_or_else(|| super::float::model(unit, d, b, x)),
    }
}
