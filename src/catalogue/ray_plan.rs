//! Rays that reach what a camera's rays leave out: every texel or a spread of them, refused rays, axes that do not move, travels of every
//! exponent and of full length, every start level, lattice corners, tile borders.
use crate::config::{Design, TraverseConfig};
use crate::error::Result;
use crate::format::Words;
use crate::golden::{Datapath, Pyramid, RayHit, RayInput, encode_ray, prepare};
use crate::scene::hard::Numbers;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Texels that get a ray of their own: all of a map of up to 32 x 32, a spread of a larger one.
const TEXELS: u32 = 1024;
/// Iterations beyond which a ray is left out: in the published datapath some never end, and each would take a simulator minutes.
const LONGEST: u32 = 1000;
/// Rays that sweep the exponents of a travel, at most.
const SWEEP: i32 = 64;

/// Rays planned for a design over a map; `seed` chooses the random ones.
///
/// # Errors
/// An illegal design.
pub fn planned_rays(d: &Design, pyramid: &Pyramid, seed: u64) -> Result<Vec<RayInput>> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(2);
    // What a ray hits is asked without the configured limit, which is there to end rays that never end by themselves.
    let unlimited = Design { traverse: TraverseConfig { step_limit: LONGEST, ..d.traverse }, ..*d };
    let tracer = prepare(&unlimited)?;
    let mut rays = texel_rays(&*tracer, pyramid, &mut rng);
    let refused = refused(d);
    let mut others = still(d);
    others.extend(sweep(d));
    others.extend([longest(d), start_levels(d), corners(d, &mut rng), anywhere(d, &mut rng)].concat());
    let words = (d.traverse.levels + 1).next_power_of_two();
    if d.mode.lod {
        // Every second ray has a level of detail: each word that the port takes in turn.
        others.iter_mut().skip(1).step_by(2).zip(0..).for_each(|(r, k)| r.lod = k % words);
    }
    others.retain(|r| tracer.trace(pyramid, r).steps < LONGEST);
    // What is refused comes between rays that hit walls and go far: it takes their slots, and must keep nothing of them.
    let gap = others.len().div_ceil(refused.len()).max(1);
    let mut refused = refused.into_iter();
    for others in others.chunks(gap) {
        rays.extend(others);
        rays.extend(refused.next());
    }
    rays.extend(refused);
    Ok(rays)
}

/// Texels (i, j) that get a ray: of a map of more than 32 x 32 as many as fit, such that each place in a block of 16 x 16 comes four
/// times, and so does each row and column of a map of 256 x 256.
fn texels(levels: u32) -> Vec<(u32, u32)> {
    let side = 1u32 << levels;
    if side * side <= TEXELS {
        return (0..side * side).map(|k| (k % side, k / side)).collect();
    }
    let blocks = side / 16;
    let texel = |k: u32| {
        let (in_i, in_j, turn) = (k % 16, k / 16 % 16, k / 256);
        // Sixteen blocks in turn, and of a larger map other sixteens.
        let block = |low: u32| ((low + turn) % 16 + 16 * ((7 * low + 3 * turn) % blocks.div_ceil(16))) % blocks;
        (in_i + 16 * block(in_j), in_j + 16 * block(in_i))
    };
    (0..TEXELS).map(texel).collect()
}

/// For each of [`texels`] a ray that ends on its top, so that any other height of it gives another result: straight down, along an axis, within the
/// texel, or from a few texels away.
fn texel_rays(tracer: &dyn Datapath, pyramid: &Pyramid, rng: &mut ChaCha8Rng) -> Vec<RayInput> {
    let d = tracer.design();
    let side = f64::from(1u32 << d.traverse.levels);
    let most = f64::from((1u32 << d.traverse.height_bits) - 1);
    let mut one = |(k, (i, j)): (usize, (u32, u32))| {
        let depth = 1.0 - f64::from(pyramid.node(0, i, j)) / most;
        let mut travel = |texels: f64| (rng.random::<f64>() * 2.0 - 1.0) * texels / side;
        let (du, dv) = match k % 4 {
            0 => (0.0, 0.0),
            1 if k % 8 == 1 => (travel(6.0), 0.0),
            1 => (0.0, travel(6.0)),
            2 => (travel(0.4), travel(0.4)),
            _ => (travel(8.0), travel(8.0)),
        };
        let aimed = |du: f64, dv: f64| {
            let from = |at: u32, d: f64| (f64::from(at) + 0.5) / side - d * depth;
            encode_ray(d, [from(i, du), from(j, dv), du, dv])
        };
        let ends_there = |h: RayHit| (h.i, h.j, h.wall, h.limit) == (i, j, false, false);
        let ray = aimed(du, dv);
        if ends_there(tracer.trace(pyramid, &ray)) { ray } else { aimed(0.0, 0.0) }
    };
    texels(d.traverse.levels).into_iter().enumerate().map(&mut one).collect()
}

/// Rays that are none: each kind of word that setup refuses, in each place.
fn refused(d: &Design) -> Vec<RayInput> {
    let ray = encode_ray(d, [0.3125, 0.6875, 0.4375, -0.28125]);
    let put = |k: usize, word: u64| {
        let mut r = ray;
        *[&mut r.u, &mut r.v, &mut r.du, &mut r.dv][k] = word;
        r
    };
    let f = match d.words() {
        Words::Float(format) => format,
        Words::Fixed { travel_bits, .. } => {
            let far = 1u64 << (travel_bits - 1);
            return vec![put(2, far), put(3, far), RayInput { du: far, ..put(3, far) }];
        }
    };
    let power = |e: i32| ((f.bias() + e) as u64) << f.man;
    let (inf, nan, sign) = (f.infinity(), f.nan(), f.sign_bit());
    let smallest = 1u64 << f.man;
    let entries =
        [nan, nan | sign, inf, inf | sign, inf | 1, power(0), power(1), inf - 1, power(-1) | sign, smallest | sign];
    let end = power(d.traverse.tile_bits as i32);
    let travels = [nan, nan | sign, inf, inf | sign, inf | 1, end, end | sign, end + 1, inf - 1, (inf - 1) | sign];
    let place = |k: usize| if k < 2 { entries } else { travels };
    (0..4).flat_map(|k| place(k).map(|word| put(k, word))).collect()
}

/// Entry points that stand for all: the first, the last, on a border, inside of a texel.
fn entries(d: &Design) -> [f64; 4] {
    let side = f64::from(1u32 << d.traverse.levels);
    [0.0, Numbers::of(d).below_one(), (side / 2.0 + 1.0) / side, (side / 4.0 + 0.375) / side]
}

/// Rays that don't move along one axis or both, with every zero there is.
fn still(d: &Design) -> Vec<RayInput> {
    let side = f64::from(1u32 << d.traverse.levels);
    let mut out = Vec::new();
    for (u, v) in entries(d).into_iter().zip(entries(d).into_iter().rev()) {
        out.push(encode_ray(d, [u, v, 0.0, 0.0]));
        for travel in [0.375 / side, 0.6875, 2.5] {
            let travel = travel.min(Numbers::of(d).longest());
            out.extend(
                [[travel, 0.0], [-travel, 0.0], [0.0, travel], [0.0, -travel]]
                    .map(|[du, dv]| encode_ray(d, [u, v, du, dv])),
            );
        }
    }
    let ray = encode_ray(d, [0.3125, 0.6875, 0.4375, -0.28125]);
    let (one, top) = match d.words() {
        Words::Fixed { travel_bits, .. } => (1, (1 << travel_bits) - 1),
        Words::Float(format) => (format.man_mask(), format.sign_bit()),
    };
    // The other zero, what reads as zero, and the least travels; entry points likewise.
    for word in [top, one, one | top, one + 1, (one + 1) | top] {
        out.extend([
            RayInput { du: word, ..ray },
            RayInput { dv: word, ..ray },
            RayInput { du: word, dv: word, ..ray },
        ]);
    }
    if d.words().float().is_some() {
        for word in [top, one, one | top, one + 1] {
            out.extend([RayInput { u: word, ..ray }, RayInput { v: word, ..ray }]);
        }
    }
    out
}

/// A travel of every exponent, axes and directions in turn.
fn sweep(d: &Design) -> Vec<RayInput> {
    let (least, most) = (d.words().least_exponent(), d.traverse.tile_bits as i32);
    let step = ((most - least + SWEEP - 1) / SWEEP).max(1);
    let ray = |(k, e): (usize, i32)| {
        let travel = 1.37 * 2f64.powi(e) * [1.0, -1.0][k / 2 % 2];
        let other = [0.11, -0.23][k / 4 % 2];
        let at = [0.4, 0.7][k / 8 % 2];
        encode_ray(d, if k % 2 == 0 { [at, 0.2, travel, other] } else { [0.9, at, other, travel] })
    };
    (least..most).step_by(step as usize).enumerate().map(ray).collect()
}

/// The longest rays in every direction, from corners of the map and from inside.
fn longest(d: &Design) -> Vec<RayInput> {
    let far = Numbers::of(d).longest();
    let mut out = Vec::new();
    for (u, v) in entries(d).into_iter().zip(entries(d)).skip(1).step_by(2) {
        for (du, dv) in [(far, far), (-far, far), (far, -far), (-far, -far)] {
            out.push(encode_ray(d, [u, v, du, dv]));
        }
        out.extend([encode_ray(d, [u, v, far, 0.0]), encode_ray(d, [u, v, 0.0, -far])]);
        out.extend([encode_ray(d, [u, v, far, 0.3 / far]), encode_ray(d, [u, v, -0.3 / far, far])]);
    }
    out
}

/// Rays of a texel's length over a plane of each level, so that each starts at the level above it; and over the border of the tile.
fn start_levels(d: &Design) -> Vec<RayInput> {
    let n = d.traverse.levels;
    let side = f64::from(1u32 << n);
    let mut out = Vec::new();
    for plane in (0..=n).map(|k| f64::from(1u32 << k) / side) {
        let (before, after, at) = (plane - 0.5 / side, (plane + 0.5 / side).rem_euclid(1.0), 0.40625);
        let (go, back) = (1.0 / side, -1.0 / side);
        out.extend([[before, at, go, 0.0], [after, at, back, 0.0], [at, before, 0.0, go], [at, after, 0.0, back]]);
        out.extend([[before, before, go, go], [after, after, back, back]]);
    }
    out.into_iter().map(|r| encode_ray(d, r)).collect()
}

/// Rays on the lattice: from corner to corner, where both planes are met at once, or along a border.
fn corners(d: &Design, rng: &mut ChaCha8Rng) -> Vec<RayInput> {
    let n = d.traverse.levels;
    let side = f64::from(1u32 << n);
    let mut ray = |k: u32| {
        let mut at = || f64::from(rng.random_range(0..1u32 << n)) / side;
        let (u, v) = (at(), at());
        let mut travel = || {
            let texels = f64::from(1u32 << rng.random_range(0..=n));
            if rng.random() { texels / side } else { -texels / side }
        };
        let (du, dv) = (travel(), travel());
        let dv = if k.is_multiple_of(2) { du.copysign(dv) } else { dv };
        encode_ray(d, [u, v, du, dv])
    };
    (0..48).map(&mut ray).collect()
}

/// Rays anywhere, of every length; every fourth enters on a border of texels, every eighth near the border of the tile.
fn anywhere(d: &Design, rng: &mut ChaCha8Rng) -> Vec<RayInput> {
    let n = d.traverse.levels as i32;
    let side = 2f64.powi(n);
    let mut ray = |k: u32| {
        let mut entry = || {
            let at: f64 = rng.random();
            match k % 8 {
                0 | 4 => (at * side).floor() / side,
                1 => 1.0 - at / side,
                _ => at,
            }
        };
        let (u, v) = (entry(), entry());
        let mut travel = || {
            let length = Numbers::of(d).longest()
                * 2f64.powf(-rng.random::<f64>() * f64::from(n + d.traverse.tile_bits as i32 + 1));
            if rng.random() { length } else { -length }
        };
        let (du, dv) = (travel(), travel());
        encode_ray(d, [u, v, du, dv])
    };
    (0..48).map(&mut ray).collect()
}
