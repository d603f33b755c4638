//! The fixed-point datapath (`docs/fixed.md`): parameters of integer planes, compared as unsigned integers.
//!
//! Plain integer arithmetic in 128 bits; nothing is narrower than it needs to be, so nothing can overflow unseen.
mod setup;
mod traverse;

pub use setup::FixedAxis;
pub use traverse::Fixed;

use super::setup::RayInput;
use crate::config::Design;

/// Bits that the ray parameter has beyond FRACTION_W: it counts in 2^-(FRACTION_W + GUARD - HEIGHT_W) height codes.
const GUARD: u32 = 2;

/// G: fraction bits of the ray parameter, which counts height codes.
///
/// Legal designs have height_bits <= fraction_bits, so it is at least [`GUARD`].
fn time_fraction(d: &Design) -> u32 {
    d.datapath.fraction_bits + GUARD - d.traverse.height_bits
}

/// What is wrong with the sizes of a fixed-point design; `None` if nothing is.
fn illegal(d: &Design) -> Option<&'static str> {
    let (t, f, w) = (&d.traverse, d.datapath.fraction_bits, d.datapath.reciprocal_bits);
    let rules = [
        ((2..=12).contains(&t.levels), "levels are 2 to 12"),
        ((2..=16).contains(&t.height_bits), "height_bits are 2 to 16"),
        ((1..=8).contains(&t.tile_bits), "tile_bits are 1 to 8"),
        ((1..=16).contains(&t.frac_bits), "frac_bits are 1 to 16"),
        ((8..=28).contains(&f), "fraction_bits are 8 to 28"),
        ((8..=32).contains(&w), "reciprocal_bits are 8 to 32"),
        (t.idx_bits() <= 24, "levels + tile_bits + 2 is at most 24"),
        (t.levels <= f, "levels are at most fraction_bits"),
        (t.height_bits <= f, "height_bits are at most fraction_bits"),
        (f + t.tile_bits <= 32, "fraction_bits + tile_bits is at most 32"),
        (f + t.tile_bits + w <= 63, "fraction_bits + tile_bits + reciprocal_bits is at most 63"),
        ((1..=4).contains(&d.mode.levels_down), "levels_down are 1 to 4"),
        ((1..=65535).contains(&t.step_limit), "step_limit is 1 to 65535"),
    ];
    rules.iter().find(|r| !r.0).map(|r| r.1)
}

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
pub(super) fn travel(d: &Design, word: u64) -> i64 {
    let far = 1u64 << (d.datapath.fraction_bits + d.traverse.tile_bits);
    let word = word % (2 * far);
    if word < far { word as i64 } else { word as i64 - 2 * far as i64 }
}

/// A ray parameter in height codes.
pub(super) fn time(d: &Design, t: u64) -> f64 {
    t as f64 / 2f64.powi(time_fraction(d) as i32)
}
