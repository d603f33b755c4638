//! The golden model of each unit that computes in fixed point.
use crate::bits::{mask, signed};
use crate::config::{Design, Trim};
use crate::golden::RayInput;
use crate::golden::fixed::{Fixed, FixedAxis};
use crate::ir::Binding;

/// The design with the least value of what a unit does not depend on: beside the values that it has, the defaults may be too large.
fn least_of_others(d: &Design, b: &Binding) -> Design {
    let mut d = *d;
    let least = |name: &str, slot: &mut u32, value: u32| {
        if !b.contains_key(name) {
            *slot = value;
        }
    };
    least("LEVELS", &mut d.traverse.levels, 2);
    least("HEIGHT_W", &mut d.traverse.height_bits, 2);
    least("TILE_W", &mut d.traverse.tile_bits, 1);
    least("RECIP_W", &mut d.datapath.reciprocal_bits, 8);
    d
}

/// Expected outputs of `unit` for one row of inputs, as [`super::model`].
pub(super) fn model(unit: &str, d: &Design, b: &Binding, x: &[u64]) -> Vec<u64> {
    let idx = d.traverse.idx_bits();
    let g = Fixed::new(&least_of_others(d, b)).expect("the set's parameters are legal");
    let index = |v: i64| v as u64 & mask(idx);
    // A ray's constants as a unit's ports bring them.
    let axis = |p: u64, s: u64, neg: u64| FixedAxis { p, s, neg: neg == 1, ..FixedAxis::default() };
    match unit {
        "reciprocal" => {
            let (r, z) = g.reciprocal(x[0]);
            vec![r, u64::from(z)]
        }
        "plane_time" => {
            let (plane, p, neg, r, z) = (signed(x[0], idx), x[1], x[2] == 1, x[3], x[4]);
            let (f, tile) = (d.datapath.fraction_bits, d.traverse.tile_bits);
            let ahead = (plane << (f - d.traverse.levels)) - p as i64;
            // A plane that no ray looks at may lie behind it or too far; its distance has as many bits as any.
            let distance = if neg { -ahead } else { ahead } as u64 & mask(f + tile + 1);
            vec![g.plane_time(distance, r, z as u32)]
        }
        "height_test" => {
            let t_v = g.height_time(x[0]);
            vec![x[1].max(t_v), u64::from(t_v < x[1])]
        }
        "predicted_hit" => vec![index(g.estimate(&axis(x[0], x[1], x[2]), x[3]))],
        "node_crossing" => {
            let (t, m, t_x, t_y) = (x[0], x[1], x[2], x[3]);
            vec![u64::from(m < t_x && m < t_y), u64::from(t_x <= t_y), t.max(t_x.min(t_y))]
        }
        "ray_setup" => {
            let lod = if d.mode.lod { x[4] as u32 } else { 0 };
            let o = g.setup(&RayInput { u: x[0], v: x[1], du: x[2], dv: x[3], lod });
            let mut out = vec![u64::from(o.valid), u64::from(o.level)];
            for a in [o.u, o.v] {
                out.extend([a.p, a.s, a.r, u64::from(a.z), u64::from(a.neg), index(a.x)]);
                out.extend((d.mode.trim != Trim::None).then(|| index(a.le)));
            }
            out.extend(d.mode.lod.then_some(u64::from(o.lod)));
            out
        }
        "hit_position" => {
            let at = axis(x[0], x[1], x[2]);
            let place = g.place(&at, x[3]);
            let kept =
                super::node_hit(d, d.traverse.frac_bits, place, signed(x[4], idx), if d.mode.lod { x[5] } else { 0 });
            if d.mode.lod { vec![kept[1], kept[0]] } else { vec![kept[1]] }
        }
        "chord_end" => vec![index(g.chord_end(&axis(x[0], x[1], x[2]), x[3]))],
        other => panic!("{other} has no golden model (at {b:?})"),
    }
}
