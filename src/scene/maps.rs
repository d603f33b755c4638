//! Procedural height maps: a function of place and seed, sampled at texel centres. All of them repeat without a seam.
use super::height_map::{Depth, HeightMap};
use super::noise::{around, fractal, gradient, mix, smooth_min, smooth_step, value};
use super::rocks::Rocks;
use rayon::prelude::*;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::MapKind;

/// The map of `2^levels` x `2^levels` texels. The natural ones fill [0, 1]; the seed changes them, but not `stairs`, `flat`, `spike`,
/// `pit` and `checker`.
///
/// # Errors
/// [`Error::Input`] for [`MapKind::File`], which is read and not made.
pub fn procedural(kind: MapKind, levels: u32, seed: u64) -> Result<HeightMap> {
    let side = 1usize << levels;
    let fill = |height: &(dyn Fn(f64, f64) -> f64 + Sync)| spread(sample(side, height));
    let texels = |height: &(dyn Fn(usize, usize) -> f64 + Sync)| -> Vec<f64> {
        (0..side * side).map(|at| height(at % side, at / side)).collect()
    };
    let middle = side / 2;
    let samples = match kind {
        MapKind::Rocks => {
            let rocks = Rocks::new(seed);
            fill(&|x, y| rocks.height(x, y))
        }
        MapKind::Bricks => fill(&|x, y| bricks(seed, x, y)),
        MapKind::Dunes => fill(&|x, y| dunes(seed, x, y)),
        MapKind::Spikes => fill(&|x, y| spikes(seed, x, y)),
        MapKind::Stairs => fill(&stairs),
        MapKind::Flat => vec![0.5; side * side],
        MapKind::Spike => texels(&|i, j| f64::from((i, j) == (middle, middle))),
        MapKind::Pit => texels(&|i, j| f64::from((i, j) != (middle, middle))),
        MapKind::Checker => texels(&|i, j| ((i + j) % 2) as f64),
        MapKind::File => return Err(Error::input("map.kind = \"file\" is read from an image, not made")),
    };
    HeightMap::new(side, side, samples, Depth::Formula)
}

fn sample(side: usize, height: &(dyn Fn(f64, f64) -> f64 + Sync)) -> Vec<f64> {
    let centre = |at: usize| (at as f64 + 0.5) / side as f64;
    // Each texel depends on its place alone, so the order of the threads can't show.
    (0..side * side).into_par_iter().map(|at| height(centre(at % side), centre(at / side))).collect()
}

/// Linearly onto [0, 1].
fn spread(samples: Vec<f64>) -> Vec<f64> {
    let low = samples.iter().copied().fold(f64::INFINITY, f64::min);
    let high = samples.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    samples.into_iter().map(|height| ((height - low) / (high - low)).clamp(0.0, 1.0)).collect()
}

/// Running bond: every other row shifted by half a brick; each brick lies, tilts and is chipped a little differently.
fn bricks(seed: u64, x: f64, y: f64) -> f64 {
    const COLUMNS: f64 = 4.0;
    const ROWS: f64 = 10.0;
    let row = (y * ROWS).floor();
    let along = x * COLUMNS + if row % 2.0 == 0.0 { 0.0 } else { 0.5 };
    let column = along.floor().rem_euclid(COLUMNS);
    // From the brick's middle, in tiles.
    let (dx, dy) = ((along - along.floor() - 0.5) / COLUMNS, (y * ROWS - row - 0.5) / ROWS);
    let (i, j) = (column as i64, row as i64);
    let own = |what: u64| value(seed.wrapping_mul(64).wrapping_add(what), i, j) * 2.0 - 1.0;
    let waver = 0.0022 * fractal(seed ^ 0x11, x, y, 16, 4);
    let (dx, dy) = (dx + 0.0015 * own(1), dy + 0.0012 * own(2));
    // Distance into the brick from its rounded outline.
    let (half_x, half_y, corner) = (0.5 / COLUMNS - 0.0062, 0.5 / ROWS - 0.0062, 0.007);
    let (ox, oy) = ((dx.abs() - half_x + corner).max(0.0), (dy.abs() - half_y + corner).max(0.0));
    let inside = corner - (ox * ox + oy * oy).sqrt() + (half_x - dx.abs()).min(half_y - dy.abs()).min(corner) - corner;
    let depth = smooth_min(inside + waver, 0.009, 0.006);
    let mortar = 0.16 + 0.07 * fractal(seed ^ 0x22, x, y, 40, 3) + 0.04 * gradient(seed ^ 0x23, x, y, 7);
    let face = 0.80 + 0.10 * own(3) + 0.9 * (own(4) * dx + 2.0 * own(5) * dy);
    let pits = smooth_step(0.30, 0.75, gradient(seed ^ 0x44, x, y, 52)) * 0.16;
    let grain = 0.045 * fractal(seed ^ 0x33, x, y, 30, 4) - pits;
    let edge = smooth_step(-0.001, 0.0095, depth);
    mortar.max(mix(0.0, face + grain, edge))
}

/// Wind ripples: a long back, a short steep lee side, crests that bend and fork, on a broad swell.
fn dunes(seed: u64, x: f64, y: f64) -> f64 {
    let bend =
        0.62 * gradient(seed ^ 1, x, y, 2) + 0.26 * gradient(seed ^ 2, x, y, 5) + 0.05 * gradient(seed ^ 3, x, y, 13);
    // Whole numbers of waves along both sides keep the seam closed.
    let ripple = |waves: f64, slant: f64, shift: f64| {
        let phase = waves * x + slant * y + shift;
        let phase = phase - phase.floor();
        let crest = 0.76;
        if phase < crest {
            let back = phase / crest;
            back * back * (1.7 - 0.7 * back)
        } else {
            let lee = (phase - crest) / (1.0 - crest);
            1.0 - smooth_step(0.0, 1.0, lee)
        }
    };
    let swell = 0.5 + 0.5 * gradient(seed ^ 4, x, y, 2);
    let strength = 0.62 + 0.5 * swell;
    let large = ripple(6.0, 1.0, 1.5 * bend);
    let small = ripple(23.0, 2.0, 4.0 * bend + 0.6 * gradient(seed ^ 5, x, y, 11));
    let grain = 0.006 * fractal(seed ^ 6, x, y, 64, 2);
    0.30 * swell + strength * large + 0.075 * small * (1.25 - large) + grain
}

/// Cones of different heights and widths on a jittered grid, concave towards the tip.
fn spikes(seed: u64, x: f64, y: f64) -> f64 {
    const GRID: i64 = 9;
    let (i, j) = ((x * GRID as f64).floor() as i64, (y * GRID as f64).floor() as i64);
    let mut height: f64 = 0.03 + 0.025 * fractal(seed ^ 1, x, y, 10, 4);
    for dj in -1..=1 {
        for di in -1..=1 {
            let (ci, cj) = ((i + di).rem_euclid(GRID), (j + dj).rem_euclid(GRID));
            let own = |what: u64| value(seed.wrapping_mul(64).wrapping_add(what), ci, cj);
            let middle = |cell: i64, shift: f64| (cell as f64 + 0.5 + 0.55 * (shift - 0.5)) / GRID as f64;
            let (dx, dy) = (around(middle(ci, own(2)), x), around(middle(cj, own(3)), y));
            let radius = (0.42 + 0.26 * own(4)) / GRID as f64;
            let far = (dx * dx + dy * dy).sqrt() / radius;
            if far < 1.0 {
                let near = 1.0 - far;
                let tall = 0.45 + 0.55 * own(5);
                height = height.max(0.03 + tall * near * (0.45 + 0.55 * near));
            }
        }
    }
    height
}

/// A stepped pyramid: six terraces, and a flight of finer stairs up the middle of each side.
fn stairs(x: f64, y: f64) -> f64 {
    const TERRACES: f64 = 6.0;
    const PER_TERRACE: f64 = 4.0;
    let (dx, dy) = ((x - 0.5).abs(), (y - 0.5).abs());
    let rise = |far: f64, steps: f64| {
        // From the foot at 0.46 to the platform at 0.10.
        let up = ((0.46 - far) / 0.36 * steps).floor() + 1.0;
        up.clamp(0.0, steps) / steps
    };
    let far = dx.max(dy);
    let terrace = rise(far, TERRACES);
    let side = dx.min(dy);
    if side < 0.055 && far > 0.09 {
        // The flight stands out before the terraces by one of their steps.
        let flight = ((0.46 - far) / 0.36 * TERRACES * PER_TERRACE).floor() + PER_TERRACE;
        return terrace.max(flight.clamp(0.0, TERRACES * PER_TERRACE) / (TERRACES * PER_TERRACE));
    }
    terrace
}
