//! The golden model of the units that the published datapath alone has, in the order of their ports.
use super::level_bits;
use crate::bits::{mask, signed};
use crate::config::{DatapathConfig, Design, LevelUp, TraverseConfig};
use crate::golden::float as gf;
use crate::golden::{Published, RayInput, Travel, descend_levels};
use crate::ir::Binding;

/// Expected outputs of `unit` for one row of inputs, at design `d` and parameter values `b`.
///
/// # Panics
/// If the unit has no model: the catalogue and the units went apart.
pub fn model(unit: &str, d: &Design, b: &Binding, x: &[u64]) -> Vec<u64> {
    let f = d.format;
    let p = |name: &str| b[name] as u32;
    let idx = b.get("IDX_W").map_or(d.traverse.idx_bits(), |v| *v as u32);
    let index = |v: i64| v as u64 & mask(idx);
    let one = gf::from_int(f, 1);
    match unit {
        "exit_plane" => {
            let (k, at, neg) = (x[0] as u32, signed(x[1], idx), x[2] == 1);
            let size = 1i64 << k;
            let first = at.div_euclid(size) * size;
            // Past the largest coordinate the plane wraps with its word.
            let plane = index(if neg { first } else { first + size });
            let mut out = vec![plane];
            let even = u64::from(signed(plane, idx).div_euclid(size).rem_euclid(2) == 0);
            out.extend(looks_at_planes(d).then_some(even));
            out
        }
        "boundary_time" => {
            let nudge = p("NUDGE_W");
            let step = match (nudge, x[1]) {
                (0, _) => 0,
                (_, 0) => 1,
                _ => -1,
            };
            let behind = gf::from_fixed(f, (signed(x[0], idx) << nudge) + step, nudge);
            vec![gf::div(f, gf::add(f, behind, gf::neg(f, x[2])), x[3])]
        }
        "surface_time" => {
            let m = (1u64 << p("HEIGHT_W")) - 1;
            let t_v = gf::mul(f, gf::from_int(f, (m - x[0]) as i64), gf::recip_int(f, m));
            let reach = if gf::lt(f, x[1], t_v) { t_v } else { x[1] };
            let first = d.mode.start_level && x[2] == 1;
            vec![if first { one } else { reach }, u64::from(gf::lt(f, t_v, x[1]))]
        }
        "ray_point" => vec![gf::add(f, x[0], gf::mul(f, x[1], x[2]))],
        "nearer_plane" => {
            let y_first = gf::lt(f, x[1], x[0]);
            let mut out = vec![x[usize::from(y_first)]];
            out.extend(looks_at_planes(d).then_some(u64::from(!y_first)));
            out
        }
        "crossing_test" => {
            let [x_hit, x_edge, x_neg, y_hit, y_edge, y_neg, t, t_exit] = x[..] else { panic!("8 inputs") };
            let beyond = |hit, edge, neg| gf::lt(f, hit, edge) == (neg == 1);
            let leaves = (beyond(x_hit, x_edge, x_neg) || beyond(y_hit, y_edge, y_neg)) && !gf::lt(f, one, t_exit);
            vec![u64::from(leaves), if gf::lt(f, t, t_exit) { t_exit } else { t }]
        }
        "descent_level" => {
            let many = d.mode.levels_down;
            let down = descend_levels(many, x[0] as u32, many > 1 && x[1] == 1);
            vec![x[0].wrapping_sub(u64::from(down)) & mask(level_bits(d))]
        }
        "level_choice" => {
            let (first, x) =
                if d.mode.start_level { (x[1] == 1, [&x[..1], &x[2..]].concat()) } else { (false, x.into()) };
            let [leaves, up, level, down, m, t_next, x_hit, x_cross, y_hit, y_cross] = x[..] else {
                panic!("10 inputs, and first with a start level")
            };
            if leaves == 1 && !first {
                vec![0, 1, (level + up) & mask(level_bits(d)), x_cross, y_cross, t_next]
            } else {
                let hit = level == 0;
                vec![u64::from(hit), 0, if hit { level } else { down }, x_hit, y_hit, m]
            }
        }
        "ray_scale" => {
            // The setup knows nothing of the hit position and of the nudge, whose bits may be too many beside it.
            let traverse = TraverseConfig { frac_bits: 1, ..d.traverse };
            let datapath = DatapathConfig { nudge_bits: 0, ..d.datapath };
            let g = Published::new(&Design { traverse, datapath, ..*d }).expect("the set's parameters are legal");
            let ray = RayInput { u: x[0], v: x[1], du: x[2], dv: x[3], lod: 0 };
            let Some(r) = g.route(&ray) else { return vec![0; 8] };
            let axis = |a: &Travel| [a.p, a.d, index(a.x)];
            [&[1, u64::from(d.traverse.levels)][..], &axis(&r.u), &axis(&r.v)].concat()
        }
        "texel_fraction" => {
            let frac = p("FRAC_W");
            let at = gf::to_fixed(f, gf::add(f, x[0], gf::mul(f, x[1], x[2])), idx + frac, frac);
            vec![at as u64 & mask(frac)]
        }
        _ => super::float::model(unit, d, b, x),
    }
}

/// Whether the level-up rule asks which plane was crossed, and for its index.
fn looks_at_planes(d: &Design) -> bool {
    matches!(d.mode.level_up, LevelUp::Tevs | LevelUp::Selective)
}
