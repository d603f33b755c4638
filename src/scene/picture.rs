//! Pictures: shaded previews, maps of the number of steps, grey height maps.
use super::palette::{Colour, HEAT, by_height, bytes};
use super::shade::{ShadePoint, Shader};
use image::ImageEncoder;
use rayon::prelude::*;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_base::files::write_atomic;
use std::path::Path;

/// An RGB picture, row by row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// Red, green, blue.
    pub pixels: Vec<[u8; 3]>,
}

/// Beyond the quad, at the top and at the bottom of the picture.
const BEYOND: [Colour; 2] = [[0.28, 0.35, 0.44], [0.66, 0.69, 0.71]];
const PAPER: [u8; 3] = [250, 250, 250];
const INK: [u8; 3] = [40, 40, 44];

impl Picture {
    /// The shaded preview; `None` is a pixel whose ray misses the quad.
    ///
    /// # Panics
    /// If there is not one point a pixel.
    pub fn shaded(shader: &Shader<'_>, width: usize, height: usize, points: &[Option<ShadePoint>]) -> Self {
        assert_eq!(points.len(), width * height, "one point a pixel");
        let pixels = points
            .par_iter()
            .enumerate()
            .map(|(at, point)| match point {
                Some(point) => shader.colour(point),
                None => bytes(by_height(&BEYOND, (at / width) as f64 / (height - 1).max(1) as f64)),
            })
            .collect();
        Self { width, height, pixels }
    }

    /// How many steps each ray took: a colour scale from 0 to the largest count, with its legend at the right.
    ///
    /// # Panics
    /// If there is not one count a pixel.
    pub fn steps(width: usize, height: usize, steps: &[Option<u32>]) -> Self {
        assert_eq!(steps.len(), width * height, "one count a pixel");
        let most = steps.iter().flatten().copied().max().unwrap_or(0).max(1);
        let zoom = (height / 192).clamp(1, 4);
        let (bar, gap, label) = (10 * zoom, 5 * zoom, most.to_string().len() * 4 * zoom);
        let mut picture = Self::blank(width + gap + bar + gap + label + gap, height);
        for (at, count) in steps.iter().enumerate() {
            let colour = count.map_or(PAPER, |count| bytes(by_height(&HEAT, f64::from(count) / f64::from(most))));
            picture.set(at % width, at / width, colour);
        }
        // The scale leaves half a digit free above and below, so that the end labels fit.
        let (left, top) = (width + gap, 4 * zoom);
        let length = height.saturating_sub(2 * top).max(1);
        for y in 0..length {
            let part = 1.0 - y as f64 / (length - 1).max(1) as f64;
            for x in 0..bar {
                picture.set(left + x, top + y, bytes(by_height(&HEAT, part)));
            }
        }
        let ticks = most.min(4);
        for tick in 0..=ticks {
            let count = (f64::from(most) * f64::from(tick) / f64::from(ticks)).round();
            let y = top + ((1.0 - count / f64::from(most)) * (length - 1) as f64).round() as usize;
            for x in 0..2 * zoom {
                picture.set(left + bar + x, y, INK);
            }
            let (x, y) = (left + bar + gap, y.saturating_sub(2 * zoom + zoom / 2));
            picture.text(x, y, zoom, INK, &(count as u32).to_string());
        }
        picture
    }

    /// The height map itself in grey.
    ///
    /// # Panics
    /// If there are not `side * side` codes.
    pub fn grey(codes: &[u32], side: usize, height_bits: u32) -> Self {
        assert_eq!(codes.len(), side * side, "one code a texel");
        let max = f64::from((1u32 << height_bits) - 1);
        let pixels = codes.iter().map(|&code| [(f64::from(code) / max * 255.0).round() as u8; 3]).collect();
        Self { width: side, height: side, pixels }
    }

    /// The picture shrunk by a whole factor: the mean of the light of `factor` x `factor` pixels. What does not fill a pixel is cut.
    pub fn shrunk(&self, factor: usize) -> Self {
        let factor = factor.clamp(1, self.width.min(self.height).max(1));
        let (width, height) = (self.width / factor, self.height / factor);
        let pixel = |at: usize| {
            let (x, y) = (at % width * factor, at / width * factor);
            let mut sum = [0.0; 3];
            for dy in 0..factor {
                for dx in 0..factor {
                    let pixel = self.pixels[(y + dy) * self.width + x + dx];
                    for (sum, byte) in sum.iter_mut().zip(pixel) {
                        *sum += (f64::from(byte) / 255.0) * (f64::from(byte) / 255.0);
                    }
                }
            }
            bytes(sum.map(|sum| sum / (factor * factor) as f64))
        };
        Self { width, height, pixels: (0..width * height).map(pixel).collect() }
    }

    /// The bytes of a PNG file.
    ///
    /// # Errors
    /// [`Error::Input`] if the picture has no pixel.
    pub fn to_png(&self) -> Result<Vec<u8>> {
        let mut png = Vec::new();
        let failed = |error| Error::input(format!("a picture of {} x {} pixels: {error}", self.width, self.height));
        image::codecs::png::PngEncoder::new(&mut png)
            .write_image(
                self.pixels.as_flattened(),
                self.width as u32,
                self.height as u32,
                image::ExtendedColorType::Rgb8,
            )
            .map_err(failed)?;
        Ok(png)
    }

    /// Writes a PNG file, beside its place first.
    ///
    /// # Errors
    /// As [`Picture::to_png`] and [`write_atomic`].
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        write_atomic(path, &self.to_png()?)
    }

    pub(super) fn blank(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![PAPER; width * height] }
    }

    pub(super) fn set(&mut self, x: usize, y: usize, colour: [u8; 3]) {
        // Small pictures cut their legend.
        if x < self.width && y < self.height {
            self.pixels[y * self.width + x] = colour;
        }
    }
}
