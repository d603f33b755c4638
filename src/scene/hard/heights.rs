//! Cases about heights: the extreme codes, and heights that the ray meets exactly where it enters or leaves a texel.
use super::case::Case;
use super::draw::{Draw, Ray};

pub(super) const CASES: &[Case] = &[
    Case::new("floor", "every texel 0: a hit only on the bottom plane, after the whole travel", |d| flat(d, 0)),
    Case::new("lowest", "every texel 1, one code above the bottom plane", |d| flat(d, 1)),
    Case::new("middle", "every texel at half height", |d| flat(d, d.numbers.top / 2)),
    Case::new("highest-but-one", "every texel one code below the top plane", |d| flat(d, d.numbers.top - 1)),
    Case::new("ceiling", "every texel at the top plane: each ray ends where it enters", |d| flat(d, d.numbers.top)),
    Case::new("extremes", "texels of 0, 1, max - 1 and max, at random", |d| {
        let codes = [0, 1, d.numbers.top - 1, d.numbers.top];
        (d.map(|i, j| codes[(d.hash(i, j) % 4) as usize]), Draw::ray)
    }),
    Case::new("spike", "one texel at max in a floor of 0, rays all around it", |d| single(d, d.numbers.top, 0)),
    Case::new("pit", "one texel at 0 in a plain at max: the only way down", |d| single(d, 0, d.numbers.top)),
    Case::new("checker", "texels alternate between 0 and max: no node but a texel is lower than the root", |d| {
        let top = d.numbers.top;
        (d.map(|i, j| (i + j) % 2 * top), Draw::ray)
    }),
    Case::new("noise", "every code, texel by texel at random", |d| (d.noise(), Draw::ray)),
    Case::new("plateau-equal", "plateaus at exactly the height at which the ray crosses a texel border on them", |d| {
        let fall = d.numbers.codes_per_texel();
        let run = steps(d);
        let reach = d.map(|i, j| {
            let (b, texel) = (1 + (d.hash(j, 1) % u64::from(run - 1)) as u32, ahead(d, i, j));
            // Three texels in front of the border and three beyond it; a floor elsewhere.
            if texel + 3 >= b && texel < b + 3 { d.numbers.top - (b << fall) } else { 0 }
        });
        (reach, along_the_slope)
    }),
    Case::new(
        "slope-equal",
        "a stair as steep as the ray: it leaves every texel at exactly its height, one texel is a code higher",
        |d| {
            let fall = d.numbers.codes_per_texel();
            let run = steps(d);
            let stair = d.map(|i, j| {
                let (b, texel) = ((d.hash(j, 2) % u64::from(run)) as u32, ahead(d, i, j));
                d.numbers.top.saturating_sub((texel + 1) << fall) + u32::from(texel == b)
            });
            (stair, along_the_slope)
        },
    ),
    Case::new(
        "graze",
        "a texel that the ray leaves at exactly its height; entry point and travel a few last places beside that",
        |d| {
            let fall = d.numbers.codes_per_texel();
            let run = steps(d);
            let posts = d.map(|i, j| {
                let b = (d.hash(j, 3) % u64::from(run)) as u32;
                if ahead(d, i, j) == b { d.numbers.top - ((b + 1) << fall) } else { 0 }
            });
            (posts, |d| {
                let [u, v, du, dv] = along_the_slope(d);
                let (places, aside) = (d.below(5) as i32 - 2, d.below(3));
                // A ray toward lower indices enters at the far border, and one further is outside of the map.
                let u = if aside == 1 { d.numbers.smallest().max(u) } else { u };
                [u, v, d.numbers.nudge(du, places), dv]
            })
        },
    ),
];

fn flat(d: &Draw, code: u32) -> (Vec<u32>, fn(&mut Draw) -> Ray) {
    (d.map(|_, _| code), |d| {
        let ray = d.ray();
        // Some that are as long as rays may be, some that stand still.
        match d.below(8) {
            0 => [ray[0], ray[1], d.numbers.longest(), ray[3]],
            1 => [ray[0], ray[1], 0.0, ray[3]],
            _ => ray,
        }
    })
}

fn single(d: &Draw, code: u32, rest: u32) -> (Vec<u32>, fn(&mut Draw) -> Ray) {
    let middle = d.numbers.side() / 2;
    (d.map(|i, j| if (i, j) == (middle, middle) { code } else { rest }), |d| {
        // Aimed at a point in the texel, or just beside it, at some depth.
        let middle = f64::from(d.numbers.side() / 2);
        let target = [d.real(-0.5, 1.5), d.real(-0.5, 1.5)].map(|x| d.numbers.tiles(middle + x));
        let (du, dv, depth) = (d.travel(1.0), d.travel(1.0), d.real(0.0, 1.0));
        [target[0] - depth * du, target[1] - depth * dv, du, dv]
    })
}

/// Texels that a ray of the slope crosses, at most a tile of them.
fn steps(d: &Draw) -> u32 {
    (d.numbers.top >> d.numbers.codes_per_texel()).min(d.numbers.side() - 1).max(2)
}

/// How many texels a ray of the slope has crossed when it comes to texel i: rays run up in even rows, down in odd ones.
fn ahead(d: &Draw, i: u32, j: u32) -> u32 {
    if j.is_multiple_of(2) { i } else { d.numbers.side() - 1 - i }
}

/// From the border of the tile along a row, falling by 2^k codes a texel exactly.
fn along_the_slope(d: &mut Draw) -> Ray {
    let j = d.below(d.numbers.side());
    let travel = d.numbers.tiles(f64::from(d.numbers.top) / f64::from(1 << d.numbers.codes_per_texel()));
    let v = d.numbers.tiles(f64::from(j) + 0.5);
    [0.0, v, if j.is_multiple_of(2) { travel } else { -travel }, 0.0]
}
