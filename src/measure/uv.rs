//! The uv error: one definition, which `accuracy`, `report` and `fit` measure here.
//!
//! It is the Euclidean distance between the returned position and the exact one, in texels of the map, the shorter way round the tile, of a
//! ray that ended. The exact position is that of the exact walk, over the ray's very words (what the arithmetic alone does), or over the ray
//! as it was given, rounded to 2^-40 of a tile (what the rounding of the ray to words does, too).
use crate::config::Design;
use crate::error::Result;
use crate::golden::RayHit;
use crate::oracle::{ExactHit, ExactMap, ExactRay};

/// Fraction bits to which a ray as it was given is taken as exact: beyond, 256-bit integers no longer hold the exact walk.
pub const GIVEN_BITS: u32 = 40;

/// The definition in one sentence, as the page states it.
pub const DEFINITION: &str = "uv error: the Euclidean distance between the returned position and the exact one, in texels of the map, the shorter way round the tile, over the rays that ended";

/// An exact hit and its place in texels, not wrapped.
pub type Place = (ExactHit, [f64; 2]);

/// A ray as it was given (u, v, du, dv in tiles), to 2^-40 of a tile, its entry point wrapped.
pub fn given_ray([u, v, du, dv]: [f64; 4]) -> ExactRay {
    let word = |x: f64| (x * 2f64.powi(GIVEN_BITS as i32)).round() as i64;
    let wrap = |x: f64| word(x.rem_euclid(1.0)).rem_euclid(1 << GIVEN_BITS) as u64;
    ExactRay::fixed(GIVEN_BITS, [wrap(u), wrap(v)], [word(du), word(dv)])
}

/// Where a ray hits exactly.
///
/// # Errors
/// Numbers too far apart for the exact arithmetic.
pub fn place(map: &ExactMap<'_>, ray: &ExactRay) -> Result<Place> {
    let hit = map.trace(ray)?;
    let (side, bottom) = (2f64.powi(map.levels as i32), f64::from((1u32 << map.height_bits) - 1));
    let place = ray.place(&hit, bottom).map(|tiles| tiles * side);
    Ok((hit, place))
}

/// The uv error of a hit, in texels of a map of 2^levels texels a side; `exact` is a place on that map, and the design's own map may have
/// fewer levels.
pub fn uv_error(d: &Design, levels: u32, h: &RayHit, exact: [f64; 2]) -> f64 {
    let side = 2f64.powi(levels as i32);
    // A texel of the design, in texels of the map.
    let texel = 2f64.powi(levels as i32 - d.traverse.levels as i32);
    let unit = 2f64.powi(-(d.traverse.frac_bits as i32));
    let away = |index: u32, part: u32, exact: f64| {
        let far = (f64::from(index) + f64::from(part) * unit) * texel - exact;
        far - (far / side).round() * side
    };
    let (u, v) = (away(h.i, h.fu, exact[0]), away(h.j, h.fv, exact[1]));
    (u * u + v * v).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_and_four_texels_away_are_five() {
        let d = Design::default();
        let n = d.traverse.levels;
        let hit = |i, j| RayHit { i, j, ..RayHit::default() };
        assert_eq!(uv_error(&d, n, &hit(13, 24), [10.0, 20.0]), 5.0);
        // The shorter way round the tile, on both axes; and of places that are tiles away.
        assert_eq!(uv_error(&d, n, &hit(254, 2), [1.0, 254.0]), 5.0);
        assert_eq!(uv_error(&d, n, &hit(13, 24), [10.0 + 256.0 * 3.0, 20.0 - 256.0]), 5.0);
        // On a map of twice the side, the same hit counts twice as many texels; fractions count.
        assert_eq!(uv_error(&d, n + 1, &hit(13, 24), [20.0, 40.0]), 10.0);
        let half = RayHit { fu: 1 << (d.traverse.frac_bits - 1), ..hit(10, 20) };
        assert_eq!(uv_error(&d, n, &half, [10.0, 20.0]), 0.5);
    }
}
