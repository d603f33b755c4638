//! What lies beyond a map's border. The hardware repeats the map; other borders are prepared into a map one level up, and rays and hits
//! are scaled to it and back. A tile of the design is then two tiles of the map along each side.
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::Border;

/// The codes of 2^levels x 2^levels texels as the design sees them.
///
/// # Panics
/// If there are not 4^levels texels.
pub fn prepared<T: Copy>(border: Border, levels: u32, texels: Vec<T>) -> Vec<T> {
    match border {
        Border::Wrap => texels,
        Border::Clamp => clamped(levels, &texels),
        Border::Mirror => mirrored(levels, &texels),
    }
}

/// The map of `2^levels` x `2^levels` texels beside its mirror images: twice the side, and it repeats without a seam.
///
/// # Panics
/// If there are not 4^levels texels.
pub fn mirrored<T: Copy>(levels: u32, texels: &[T]) -> Vec<T> {
    doubled(Border::Mirror, levels, texels)
}

/// The map of `2^levels` x `2^levels` texels in the middle of one of twice the side, with its border texels continued outward for
/// half a side. A ray that ends no further than that beyond the border sees them go on for ever.
///
/// # Panics
/// If there are not 4^levels texels.
pub fn clamped<T: Copy>(levels: u32, texels: &[T]) -> Vec<T> {
    doubled(Border::Clamp, levels, texels)
}

fn doubled<T: Copy>(border: Border, levels: u32, texels: &[T]) -> Vec<T> {
    let side = 1usize << levels;
    assert_eq!(texels.len(), side * side, "a map of 2^levels texels a side");
    let own = |at: usize| own_texel(border, levels + 1, at as u32) as usize;
    let row = |j: usize| (0..2 * side).map(move |i| (i, j));
    (0..2 * side).flat_map(row).map(|(i, j)| texels[own(j) * side + own(i)]).collect()
}

/// The map's texel that column (or row) `at` of a design of `2^levels` texels holds.
pub fn own_texel(border: Border, levels: u32, at: u32) -> u32 {
    let side = 1 << (levels - border.levels());
    match border {
        Border::Wrap => at,
        Border::Clamp => at.saturating_sub(side / 2).min(side - 1),
        Border::Mirror => at.min(2 * side - 1 - at),
    }
}

/// A place of the design, in its tiles from 0 to 1, in tiles of the map: of a mirror image the place that it shows, and below 0 or
/// above 1 where the map is continued by its border texels.
pub fn own_place(border: Border, place: f64) -> f64 {
    match border {
        Border::Wrap => place,
        Border::Clamp => 2.0 * place - 0.5,
        Border::Mirror => (2.0 * place).min(2.0 - 2.0 * place),
    }
}

/// A ray (u, v, du, dv) in tiles of the map, in tiles of the design. An entry point that is not in the design's first tile wraps.
pub fn entered(border: Border, [u, v, du, dv]: [f64; 4]) -> [f64; 4] {
    match border {
        Border::Wrap => [u, v, du, dv],
        Border::Clamp => [(u + 0.5) / 2.0, (v + 0.5) / 2.0, du / 2.0, dv / 2.0],
        Border::Mirror => [u / 2.0, v / 2.0, du / 2.0, dv / 2.0],
    }
}

/// Rays of a table, in tiles of the map, in tiles of the design.
///
/// # Errors
/// An entry point outside of what was prepared.
pub fn enter_border(border: Border, rays: &[[f64; 4]]) -> Result<Vec<[f64; 4]>> {
    let outside = |x: f64| border == Border::Clamp && !(-0.5..1.5).contains(&x);
    match rays.iter().position(|r| outside(r[0]) || outside(r[1])) {
        Some(ray) => Err(Error::input(format!(
            "ray {ray} enters at u = {}, v = {}: with map.border = \"clamp\" a ray enters from -0.5 to below 1.5",
            rays[ray][0], rays[ray][1]
        ))),
        None => Ok(rays.iter().map(|r| entered(border, *r)).collect()),
    }
}

/// The inverse of [`entered`].
pub fn given(border: Border, [u, v, du, dv]: [f64; 4]) -> [f64; 4] {
    match border {
        Border::Wrap => [u, v, du, dv],
        Border::Clamp => [2.0 * u - 0.5, 2.0 * v - 0.5, 2.0 * du, 2.0 * dv],
        Border::Mirror => [2.0 * u, 2.0 * v, 2.0 * du, 2.0 * dv],
    }
}

/// How often the design's tile lies along a length where the map lies `repeat` times.
pub fn tiles(border: Border, repeat: u32) -> f64 {
    f64::from(repeat) / f64::from(1 << border.levels())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_by_two() {
        let map = [1, 2, 3, 4];
        assert_eq!(mirrored(1, &map), [1, 2, 2, 1, 3, 4, 4, 3, 3, 4, 4, 3, 1, 2, 2, 1]);
        assert_eq!(clamped(1, &map), [1, 1, 2, 2, 1, 1, 2, 2, 3, 3, 4, 4, 3, 3, 4, 4]);
        assert_eq!(prepared(Border::Wrap, 1, map.to_vec()), map);
    }

    #[test]
    fn there_and_back() {
        for border in Border::ALL {
            let ray = [0.375, 0.75, -1.5, 3.0];
            let inside = entered(border, ray);
            assert_eq!(given(border, inside), ray);
            assert_eq!(own_place(border, inside[0]), ray[0]);
            assert_eq!(own_place(border, inside[1]), ray[1]);
            // The texel at a place is that of the map at the place shown.
            let side = f64::from(1u32 << (5 - border.levels()));
            for at in 0..32 {
                let shown = own_place(border, (f64::from(at) + 0.5) / 32.0) * side;
                assert_eq!(own_texel(border, 5, at), shown.clamp(0.0, side - 1.0).floor() as u32);
            }
        }
    }
}
