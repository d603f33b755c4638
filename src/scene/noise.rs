//! Noise that repeats with the tile, made of + - * / and integer hashes only: equal to the last bit on every machine.

/// A well-mixed hash of a lattice point (the finalizer of SplitMix64, chained).
pub(super) fn hash(seed: u64, i: i64, j: i64) -> u64 {
    let mix = |value: u64| {
        let value = (value ^ (value >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let value = (value ^ (value >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        value ^ (value >> 31)
    };
    let first = mix(seed.wrapping_add(0x9e37_79b9_7f4a_7c15));
    let second = mix(first ^ (i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    mix(second ^ (j as u64).wrapping_mul(0xd1b5_4a32_d192_ed03))
}

/// In [0, 1), from the hash's top bits.
pub(super) fn unit(hash: u64) -> f64 {
    (hash >> 11) as f64 / (1u64 << 53) as f64
}

/// In [0, 1) at a lattice point.
pub(super) fn value(seed: u64, i: i64, j: i64) -> f64 {
    unit(hash(seed, i, j))
}

/// 0 below `low`, 1 above `high`, smooth between.
pub(super) fn smooth_step(low: f64, high: f64, x: f64) -> f64 {
    let part = ((x - low) / (high - low)).clamp(0.0, 1.0);
    part * part * (3.0 - 2.0 * part)
}

/// `a` at 0, `b` at 1.
pub(super) fn mix(a: f64, b: f64, part: f64) -> f64 {
    a + (b - a) * part
}

/// The smaller of two, with a rounded edge of width `soft`.
pub(super) fn smooth_min(a: f64, b: f64, soft: f64) -> f64 {
    let part = (soft - (a - b).abs()).max(0.0) / soft;
    a.min(b) - part * part * soft * 0.25
}

/// Gradient noise in about [-1, 1] with `period` lattice cells a tile; x and y in tiles.
pub(super) fn gradient(seed: u64, x: f64, y: f64, period: i64) -> f64 {
    let (x, y) = (x * period as f64, y * period as f64);
    let (i, j) = (x.floor(), y.floor());
    let (fx, fy) = (x - i, y - j);
    let corner = |di: i64, dj: i64| {
        let bits = hash(seed, (i as i64 + di).rem_euclid(period), (j as i64 + dj).rem_euclid(period));
        // Any direction will do; it need not have length 1.
        let (gx, gy) = (unit(bits) * 2.0 - 1.0, unit(bits.wrapping_mul(0x9e37_79b9_7f4a_7c15)) * 2.0 - 1.0);
        gx * (fx - di as f64) + gy * (fy - dj as f64)
    };
    let ease = |t: f64| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let (sx, sy) = (ease(fx), ease(fy));
    1.6 * mix(mix(corner(0, 0), corner(1, 0), sx), mix(corner(0, 1), corner(1, 1), sx), sy)
}

/// Octaves of gradient noise, each twice as fine and half as strong, in about [-1, 1].
pub(super) fn fractal(seed: u64, x: f64, y: f64, period: i64, octaves: u32) -> f64 {
    let (mut sum, mut weight, mut total) = (0.0, 1.0, 0.0);
    for octave in 0..octaves {
        sum += weight * gradient(seed.wrapping_add(u64::from(octave)), x, y, period << octave);
        total += weight;
        weight *= 0.5;
    }
    sum / total
}

/// The way from `from` to `to` on the circle of length 1: in [-1/2, 1/2].
pub(super) fn around(from: f64, to: f64) -> f64 {
    let way = to - from;
    way - way.round()
}
