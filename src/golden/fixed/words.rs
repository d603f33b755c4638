//! The words of a ray and of its parameter.
use super::model::time_fraction;
use crate::record::RayInput;
use reliefrtl_config::Design;

/// The ray whose words are nearest to (u, v, du, dv), in tiles: entry points wrapped into \[0, 1), travels that are too long as the one
/// word that no ray may have.
pub(super) fn encode(d: &Design, [u, v, du, dv]: [f64; 4]) -> RayInput {
    let (f, far) = (d.datapath.fraction_bits, 1i64 << (d.datapath.fraction_bits + d.traverse.tile_bits));
    let scale = 2f64.powi(f as i32);
    let entry = |x: f64| (x.rem_euclid(1.0) * scale).round_ties_even() as u64 % (1 << f);
    let travel = |x: f64| {
        let code = (x * scale).round_ties_even();
        let code = if code.abs() < far as f64 { code as i64 } else { -far };
        code as u64 % (2 * far as u64)
    };
    RayInput { u: entry(u), v: entry(v), du: travel(du), dv: travel(dv), lod: 0 }
}

/// A travel's word as a number, in 2^-FRACTION_W tiles.
pub fn travel(d: &Design, word: u64) -> i64 {
    let far = 1u64 << (d.datapath.fraction_bits + d.traverse.tile_bits);
    let word = word % (2 * far);
    if word < far { word as i64 } else { word as i64 - 2 * far as i64 }
}

/// A ray parameter in height codes.
pub(super) fn time(d: &Design, t: u64) -> f64 {
    t as f64 / 2f64.powi(time_fraction(d) as i32)
}
