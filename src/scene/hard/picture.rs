//! The picture of a case: its map from above with the rays' footprints, and one ray from the side.
use super::HardScene;
use super::draw::Ray;
use crate::palette::{by_height, bytes, of_map};
use crate::picture::Picture;
use reliefrtl_config::MapKind;

/// Side of the map in the picture, at least; a larger map is shrunk to it, each pixel its highest texel.
const SIDE: usize = 640;
const EDGE: usize = 16;
const LINE: usize = 22;
const PROFILE: usize = 150;
/// More rays than this hide each other.
const SHOWN: usize = 24;
const INK: [u8; 3] = [40, 40, 44];
const RAY: [u8; 3] = [255, 176, 32];
const CHOSEN: [u8; 3] = [64, 224, 255];
const ENTRY: [u8; 3] = [255, 255, 255];
const END: [u8; 3] = [214, 32, 48];
const SKY: [u8; 3] = [222, 229, 236];

/// Draws a case; `ends` are the parts of the travels after which the rays end, 0 to 1.
///
/// # Panics
/// If there is not one end a ray.
pub fn footprints(scene: &HardScene, name: &str, seed: u64, ends: &[f64]) -> Picture {
    assert_eq!(scene.rays.len(), ends.len(), "one end a ray");
    let side = 1usize << scene.design.traverse.levels;
    let zoom = (SIDE / side).max(1);
    let shown = side.min(SIDE) * zoom;
    let mut picture = Picture::blank(shown + 2 * EDGE, shown + PROFILE + 2 * EDGE + 5 * LINE / 2);
    picture.text(EDGE, EDGE, 2, INK, &format!("{name}, {side} x {side} texels, seed {seed}"));
    let map = EDGE + LINE;
    for y in 0..shown {
        for x in 0..shown {
            picture.set(EDGE + x, map + y, ground(highest(scene, x, y, shown)));
        }
    }
    let chosen = chosen(scene, ends);
    let few = scene.rays.iter().zip(ends).enumerate().take(SHOWN).filter(|(k, _)| Some(*k) != chosen);
    let last = chosen.map(|k| (k, (&scene.rays[k], &ends[k])));
    let mut dots = Vec::new();
    for (k, (ray, &end)) in few.chain(last) {
        let colour = if Some(k) == chosen { CHOSEN } else { RAY };
        let length = end * ray[2].hypot(ray[3]) * shown as f64;
        // Half a pixel apart; a ray round the tile many times needs no more points than can be told apart.
        let points = (2.0 * length).clamp(1.0, 40_000.0) as usize;
        let place = |point: usize| {
            let part = end * point as f64 / points as f64;
            [0, 1].map(|axis| ((ray[axis] + part * ray[axis + 2]).rem_euclid(1.0) * shown as f64) as usize % shown)
        };
        for point in 0..=points {
            let [x, y] = place(point);
            picture.block(EDGE + x, map + y, 2.min(shown - x), 2.min(shown - y), colour);
        }
        dots.push((place(0), ENTRY));
        dots.push((place(points), END));
    }
    for ([x, y], colour) in dots {
        dot(&mut picture, EDGE + x, map + y, colour);
    }
    let below = map + shown + LINE / 2;
    let counted = format!("{} of {} rays", ends.len().min(SHOWN), ends.len());
    picture.text(EDGE, below, 2, INK, &format!("{counted}: entry white, end red; below: the blue ray"));
    if let Some(k) = chosen {
        profile(&mut picture, scene, &scene.rays[k], ends[k], below + LINE, shown);
    }
    picture
}

/// Height of the highest texel in a pixel of the map, 0 to 1.
fn highest(scene: &HardScene, x: usize, y: usize, shown: usize) -> f64 {
    let side = 1usize << scene.design.traverse.levels;
    let texels = |pixel: usize| pixel * side / shown..((pixel + 1) * side).div_ceil(shown);
    let row = |j: usize| texels(x).map(move |i| j * side + i);
    let code = texels(y).flat_map(row).map(|at| scene.texels[at]).max().unwrap_or(0);
    height(scene, code)
}

fn height(scene: &HardScene, code: u32) -> f64 {
    f64::from(code) / f64::from((1u32 << scene.design.traverse.height_bits) - 1)
}

fn ground(height: f64) -> [u8; 3] {
    bytes(by_height(of_map(MapKind::Flat), height))
}

/// The ray for the side view: one that crosses enough texels to see something and not too many to see them, else the longest.
fn chosen(scene: &HardScene, ends: &[f64]) -> Option<usize> {
    let side = f64::from(1u32 << scene.design.traverse.levels);
    let way = |k: &usize| ends[*k] * (scene.rays[*k][2].abs() + scene.rays[*k][3].abs()) * side;
    let all = || 0..ends.len();
    all().find(|k| (5.0..60.0).contains(&way(k))).or_else(|| all().max_by(|a, b| way(a).total_cmp(&way(b))))
}

/// Texels under the ray as columns, and the ray coming down to its end.
fn profile(picture: &mut Picture, scene: &HardScene, ray: &Ray, end: f64, top: usize, shown: usize) {
    let side = 1usize << scene.design.traverse.levels;
    // A little further than the end, so that what was hit is seen.
    let reach = (end * 1.15).clamp(0.02, 1.0);
    let depth = |height: f64| ((1.0 - height) * (PROFILE - 1) as f64).round() as usize;
    for x in 0..shown {
        let part = reach * (x as f64 + 0.5) / shown as f64;
        let texel = |axis: usize| ((ray[axis] + part * ray[axis + 2]).rem_euclid(1.0) * side as f64) as usize % side;
        let height = height(scene, scene.texels[texel(1) * side + texel(0)]);
        picture.block(EDGE + x, top, 1, PROFILE, SKY);
        picture.block(EDGE + x, top + depth(height), 1, PROFILE - depth(height), ground(0.45 * height));
    }
    let last = (end / reach * (shown - 1) as f64).round() as usize;
    for x in 0..=last.min(shown - 1) {
        let y = |x: usize| depth(1.0 - reach * x as f64 / shown as f64);
        picture.block(EDGE + x, top + y(x), 1, (y(x + 1).max(y(x) + 2) - y(x)).min(PROFILE - y(x)), [20, 120, 190]);
    }
    dot(picture, EDGE + last.min(shown - 1), top + depth(1.0 - end), END);
}

/// A disc with a dark rim, which is seen on every ground.
fn dot(picture: &mut Picture, x: usize, y: usize, colour: [u8; 3]) {
    for dy in 0..9usize {
        for dx in 0..9usize {
            let far = (dx as f64 - 4.0).hypot(dy as f64 - 4.0);
            if far < 4.3 {
                let colour = if far < 3.0 { colour } else { INK };
                picture.set((x + dx).saturating_sub(4), (y + dy).saturating_sub(4), colour);
            }
        }
    }
}
