//! The golden model of the bilinear refinement's units, in the order of their ports.
use crate::config::Design;
use crate::golden::{address, bilinear as gb, float as gf};
use crate::ir::Binding;

/// Expected outputs of `unit` for one row of inputs, as [`super::model`]; `None` if it is no unit of the refinement.
pub(super) fn model(unit: &str, d: &Design, b: &Binding, x: &[u64]) -> Option<Vec<u64>> {
    let (f, n) = (d.format, d.traverse.levels);
    let p = |name: &str| b[name] as u32;
    let w = |k: usize| x[k] as u32;
    let pair = |(texel, fraction): (u32, u32)| vec![u64::from(texel), u64::from(fraction)];
    Some(match unit {
        "bilinear_window" => {
            let bottom = gf::from_int(f, (1 << p("HEIGHT_W")) - 1);
            gb::window(f, bottom, [x[0], x[1]], x[2]).to_vec()
        }
        "ray_place" => pair(gb::place(f, n, [p("IDX_W"), p("FRAC_W")], [x[0], x[1], x[2]])),
        "patch_corner" => pair(gb::corner(n, p("FRAC_W"), (w(0), w(1)))),
        "bank_address" => {
            let last = (1u32 << n) - 1;
            // The one of a texel and its neighbour that has the parity.
            let of = |texel: u32, odd: u32| if texel % 2 == odd { texel } else { (texel + 1) & last };
            let word = |k: u32| address(n, 0, of(w(0), k % 2), of(w(1), k / 2)) as u64 / 4;
            (0..4).map(word).collect()
        }
        "surface_gap" => {
            vec![gb::gap(f, [p("HEIGHT_W"), p("FRAC_W")], [w(0), w(1), w(2), w(3)], [w(4), w(5)], x[6])]
        }
        "secant_step" => {
            vec![gb::patch(f, [x[2], x[3]]).code(), gb::secant(f, [x[0], x[1]], [x[2], x[3]])]
        }
        _ => return None,
    })
}
