//! Errors in a heap: quantiles, the largest with its ray, a histogram of octaves.
use serde::{Deserialize, Serialize};

/// Octave of the histogram's second bin: 2^-16 texels. The first bin holds what is smaller.
pub const FIRST_OCTAVE: i32 = -16;
/// Bins: up to 2^10 texels and beyond.
pub const BINS: usize = 28;

/// Errors of many rays, in texels.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Rays.
    pub rays: u64,
    /// Half of the rays have at most this error.
    pub p50: f64,
    /// 99 of 100 have at most this error.
    pub p99: f64,
    /// The largest.
    pub max: f64,
    /// The ray that has it.
    pub max_ray: usize,
    /// Rays by octave of their error.
    pub bins: Vec<u64>,
}

/// The bin of an error. By the exponent of the f64, so that every machine agrees.
pub fn bin(error: f64) -> usize {
    let octave = (error.to_bits() >> 52 & 0x7ff) as i32 - 1023;
    (octave - FIRST_OCTAVE + 1).clamp(0, BINS as i32 - 1) as usize
}

/// The smallest error above a bin.
pub fn upper(bin: usize) -> f64 {
    2f64.powi(FIRST_OCTAVE + bin as i32)
}

impl Spread {
    /// Of errors with their rays.
    pub fn of(mut errors: Vec<(f64, usize)>) -> Self {
        let mut bins = vec![0; BINS];
        errors.iter().for_each(|e| bins[bin(e.0)] += 1);
        // The first of equal errors is the witness, whatever the order of the threads.
        errors.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        let Some(&(max, max_ray)) = errors.last() else {
            return Self { bins, ..Self::default() };
        };
        // Nearest rank: an error that some ray has, not one in between.
        let rank = |per_cent: usize| errors[(errors.len() * per_cent).div_ceil(100).max(1) - 1].0;
        Self { rays: errors.len() as u64, p50: rank(50), p99: rank(99), max, max_ray, bins }
    }
}

/// Rays that may be wrong although none of `n` was: with 95 % confidence less than 3 of n (the rule of three).
pub fn bound(n: u64) -> f64 {
    3.0 / n.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_and_ranks() {
        assert_eq!((bin(0.0), bin(2f64.powi(-17)), bin(2f64.powi(-16)), bin(1e9)), (0, 0, 1, BINS - 1));
        for k in 0..BINS - 1 {
            assert_eq!((bin(upper(k)), bin(upper(k) * 0.999)), (k + 1, k));
        }
        let s = Spread::of((0..200).map(|i| (f64::from(199 - i), i as usize)).collect());
        assert_eq!((s.p50, s.p99, s.max, s.max_ray, s.rays), (99.0, 197.0, 199.0, 0, 200));
        assert_eq!(Spread::of(vec![(1.0, 7), (1.0, 3)]).max_ray, 3);
        assert_eq!(Spread::of(Vec::new()).rays, 0);
    }
}
