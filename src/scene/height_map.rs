//! A height map as it was read or made, before it becomes codes.
use reliefrtl_base::error::{Error, Result};

/// How finely the source tells heights apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Whole numbers of this many bits, 1 to 32.
    Bits(u32),
    /// Floating point: finer than any code.
    Float,
    /// Floating point in a range that was given: rounded to whatever depth is asked for.
    Ranged,
    /// A formula: made at whatever depth is asked for.
    Formula,
}

/// Heights in [0, 1], row by row; i runs along a row (u), j from row to row (v).
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    /// Texels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// `width * height` heights in [0, 1]; texel (i, j) at `j * width + i`.
    pub samples: Vec<f64>,
    /// Depth of the source.
    pub depth: Depth,
}

impl HeightMap {
    /// A map of checked heights.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no texel, if the count does not fit, or naming the first pixel (from 0, column then
    /// row) whose height is not a number or not in [0, 1].
    pub fn new(width: usize, height: usize, samples: Vec<f64>, depth: Depth) -> Result<Self> {
        if samples.is_empty() {
            return Err(Error::input(format!("an empty image ({width} x {height}): at least one pixel is needed")));
        }
        if width.checked_mul(height) != Some(samples.len()) {
            return Err(Error::input(format!("{} heights for {width} x {height} pixels", samples.len())));
        }
        if let Some(at) = samples.iter().position(|height| !(0.0..=1.0).contains(height)) {
            let (x, y, value) = (at % width, at / width, samples[at]);
            let what = if value.is_nan() { "not a number".to_owned() } else { format!("{value}") };
            return Err(Error::input(format!("pixel ({x}, {y}) is {what}: heights must be in 0 to 1")));
        }
        Ok(Self { width, height, samples, depth })
    }

    /// The height of texel (i, j).
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.samples[j * self.width + i]
    }
}
