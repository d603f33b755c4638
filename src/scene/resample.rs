//! Rows of another number of samples: the mean over a texel's area where the map shrinks, linear where it grows; the map repeats.

/// One row of samples to as many as `to` has.
pub(super) fn stretch(from: &[f64], to: &mut [f64]) {
    let (width, side) = (from.len(), to.len());
    for (at, sample) in to.iter_mut().enumerate() {
        *sample = if side < width {
            let (first, last) = (at * width / side, ((at + 1) * width).div_ceil(side));
            (first..last).map(|source| from[source] * area(at, source, width, side)).sum()
        } else {
            line(at, width, side).iter().map(|&(source, weight)| from[source] * weight).sum()
        };
    }
}

/// The part of target sample `at` that source sample `source` fills.
fn area(at: usize, source: usize, width: usize, side: usize) -> f64 {
    // In units of 1 / side source samples, so that every border is a whole number and the weights are exact ratios.
    let (from, to) = (at * width, (at + 1) * width);
    let inside = to.min((source + 1) * side) - from.max(source * side);
    inside as f64 / width as f64
}

/// The two source samples around the centre of target sample `at`, wrapped.
fn line(at: usize, width: usize, side: usize) -> [(usize, f64); 2] {
    // The centre lies at (2 at + 1) width / (2 side) - 1/2 source samples; twice that and shifted by width stays a whole number.
    let twice = (2 * at + 1) * width + 2 * side * width - side;
    let low = twice / (2 * side);
    let part = (twice % (2 * side)) as f64 / (2 * side) as f64;
    [(low % width, 1.0 - part), ((low + 1) % width, part)]
}

/// Adds rows up to as many as there shall be, as they come.
pub(super) struct Column {
    /// Rows that come.
    height: usize,
    /// Samples of a row, and rows, that there shall be.
    side: usize,
    sums: Vec<f64>,
    /// Where each row that comes goes, and with which weight; while the map grows.
    taps: Vec<Vec<(usize, f64)>>,
}

impl Column {
    pub(super) fn new(height: usize, side: usize) -> Self {
        let mut taps = Vec::new();
        if side > height {
            taps = vec![Vec::new(); height];
            for at in 0..side {
                for (source, weight) in line(at, height, side) {
                    taps[source].push((at, weight));
                }
            }
        }
        Self { height, side, sums: vec![0.0; side * side], taps }
    }

    /// Row `y` of those that come.
    pub(super) fn add(&mut self, y: usize, row: &[f64]) {
        let side = self.side;
        let mut add = |at: usize, weight: f64| {
            self.sums[at * side..(at + 1) * side].iter_mut().zip(row).for_each(|(sum, sample)| *sum += sample * weight);
        };
        if side > self.height {
            self.taps[y].iter().for_each(|&(at, weight)| add(at, weight));
        } else {
            let (first, last) = (y * side / self.height, ((y + 1) * side - 1) / self.height);
            (first..=last).for_each(|at| add(at, area(at, y, self.height, side)));
        }
    }

    pub(super) fn sums(&self) -> &[f64] {
        &self.sums
    }
}
