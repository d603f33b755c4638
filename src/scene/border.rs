//! What lies behind a map's border. The hardware repeats the map; other borders are prepared into a map one level up.

/// The map of `2^levels` x `2^levels` texels beside its mirror images: twice the side, and it repeats without a seam.
///
/// # Panics
/// If there are not 4^levels texels.
pub fn mirrored<T: Copy>(levels: u32, texels: &[T]) -> Vec<T> {
    let side = side(levels, texels);
    let inside = |at: usize| if at < side { at } else { 2 * side - 1 - at };
    prepared(side, texels, inside)
}

/// The map of `2^levels` x `2^levels` texels in the middle of one of twice the side, with its border texels continued outward for
/// half a side. A ray that travels no further than that beyond the border sees them go on for ever.
///
/// # Panics
/// If there are not 4^levels texels.
pub fn clamped<T: Copy>(levels: u32, texels: &[T]) -> Vec<T> {
    let side = side(levels, texels);
    prepared(side, texels, |at| at.saturating_sub(side / 2).min(side - 1))
}

fn side<T>(levels: u32, texels: &[T]) -> usize {
    let side = 1 << levels;
    assert_eq!(texels.len(), side * side, "a map of 2^levels texels a side");
    side
}

fn prepared<T: Copy>(side: usize, texels: &[T], inside: impl Fn(usize) -> usize) -> Vec<T> {
    let row = |j: usize| (0..2 * side).map(move |i| (i, j));
    (0..2 * side).flat_map(row).map(|(i, j)| texels[inside(j) * side + inside(i)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_by_two() {
        let map = [1, 2, 3, 4];
        assert_eq!(mirrored(1, &map), [1, 2, 2, 1, 3, 4, 4, 3, 3, 4, 4, 3, 1, 2, 2, 1]);
        assert_eq!(clamped(1, &map), [1, 1, 2, 2, 1, 1, 2, 2, 3, 3, 4, 4, 3, 3, 4, 4]);
    }
}
