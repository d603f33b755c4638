//! Cases about where the ray enters, what lies beyond the map's border, how large the map is, and how long the way is.
use super::case::Case;
use super::draw::{Draw, Ray};
use crate::border::{clamped, mirrored};

/// A case of a map of 2^levels texels a side.
const fn sized(name: &'static str, levels: u32) -> Case {
    let about = "a map of this many texels a side, rays anywhere, on corners, and over several tiles";
    Case { name, about, limit: false, levels: Some(levels), make: any_size }
}

pub(super) const CASES: &[Case] = &[
    Case::new("entry-border", "enters on a texel border, and a few last places beside one", |d| {
        (d.rough(), |d| {
            let beside = |d: &mut Draw| {
                let (border, places) = (d.border(), d.below(5) as i32 - 2);
                d.numbers.nudge(border, places)
            };
            [beside(d), beside(d), d.travel(0.25), d.travel(0.25)]
        })
    }),
    Case::new("entry-zero", "enters at 0, and at the smallest numbers above it", |d| {
        (d.rough(), |d| {
            let (zero, least) = (d.signed(0.0), d.numbers.smallest());
            let places = d.below(3) as i32;
            let low = [zero, d.numbers.nudge(least, places)];
            let (u, v) = (d.pick(&low), if d.coin() { d.pick(&low) } else { d.entry() });
            [u, v, d.travel(1.0), d.travel(1.0)]
        })
    }),
    Case::new("entry-one", "enters at the last numbers below 1", |d| {
        (d.rough(), |d| {
            let places = -(d.below(3) as i32);
            let last = d.numbers.nudge(d.numbers.below_one(), places);
            let other = if d.coin() { last } else { d.entry() };
            [last, other, d.travel(1.0), d.travel(1.0)]
        })
    }),
    Case::new("border-wrap", "runs over the map's border, where it repeats", |d| (d.rough(), over_the_border)),
    Case::new("border-mirror", "a map that was continued by its mirror images, one level up", |d| {
        (small(d, |levels, texels| mirrored(levels, &texels)), over_the_border)
    }),
    Case::new("border-clamp", "a map that was continued by its border texels, one level up", |d| {
        (small(d, |levels, texels| clamped(levels, &texels)), |d| {
            // From the map in the middle outward over its border, a quarter of a tile beyond it at most.
            let (u, out) = (d.real(0.25, 0.5), d.real(0.0, 0.25));
            let (v, dv, du) = (d.real(0.25, 0.75), d.travel(0.25), 0.25 - u - out);
            let (u, du) = if d.coin() { (u, du) } else { (1.0 - u, -du) };
            if d.coin() { [u, v, du, dv] } else { [v, u, dv, du] }
        })
    }),
    Case {
        levels: Some(2),
        ..Case::new(
            "size-2",
            "a map of two texels a side, which four times is the smallest that the hardware holds",
            |d| {
                let codes = d.rough();
                (d.map(|i, j| codes[(j % 2 * d.numbers.side() + i % 2) as usize]), any_size(d).1)
            },
        )
    },
    sized("size-4", 2),
    sized("size-8", 3),
    sized("size-16", 4),
    sized("size-32", 5),
    sized("size-64", 6),
    sized("size-128", 7),
    sized("size-256", 8),
    sized("size-512", 9),
    sized("size-1024", 10),
    sized("size-2048", 11),
    sized("size-4096", 12),
    Case::new("longest-path", "a stair-shaped trench that only texels show: every one of its texels is visited", |d| {
        let (top, side) = (d.numbers.top, d.numbers.side());
        (d.map(|i, j| if (j + side - i) % side < 2 { 0 } else { top }), |d| {
            // Two texels a step of the stair, and up to three iterations a texel with the level-up rule "always".
            let texels = f64::from(d.numbers.step_limit / 8).min(d.numbers.longest() * f64::from(d.numbers.side()));
            let (travel, start) = (d.numbers.tiles(texels.floor()), d.border());
            [start + d.numbers.tiles(0.25), start + d.numbers.tiles(0.5), travel, travel]
        })
    }),
    Case::new("step-limit", "a limit of exactly the iterations that the longest ray needs, and of one less", |d| {
        (d.rough(), Draw::ray)
    })
    .at_the_limit(),
];

/// The map of the cases that differ in size only.
fn any_size(d: &Draw) -> (Vec<u32>, fn(&mut Draw) -> Ray) {
    (d.rough(), |d| {
        let most = 4f64.min(d.numbers.longest());
        match d.below(4) {
            0 => [d.border(), d.border(), d.whole_travel(), d.whole_travel()],
            1 => [d.entry(), d.entry(), d.travel(most), d.travel(most)],
            _ => d.ray(),
        }
    })
}

/// A rough map of half the side, prepared to the whole one.
fn small(d: &Draw, prepare: fn(u32, Vec<u32>) -> Vec<u32>) -> Vec<u32> {
    let half = d.numbers.side() / 2;
    let codes = d.rough();
    let corner = (0..half * half).map(|at| codes[((at / half) * 2 * half + at % half) as usize]).collect();
    prepare(d.numbers.levels - 1, corner)
}

/// Rays that enter within a quarter of a tile of the border and run toward it.
fn over_the_border(d: &mut Draw) -> Ray {
    let (near, far) = (d.real(0.0, 0.25), d.real(0.25, 1.0));
    let (v, dv) = (d.entry(), d.travel(0.5));
    let (u, du) = if d.coin() { (near, -far) } else { (1.0 - near, far) };
    if d.coin() { [u, v, du, dv] } else { [v, u, dv, du] }
}
