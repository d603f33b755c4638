//! Rows of samples that lie one after another in the file, uncompressed.
use super::opened::{Rows, broken, filled};
use super::pick::Pick;
use crate::source::{Handle, Source};
use reliefrtl_base::error::{Error, Result};
use std::io::SeekFrom;

/// How one sample is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stored {
    /// One bit, the first in the high end of a byte, rows filled up to bytes; 1 is black, which is height 0.
    Ink,
    /// A byte.
    U8,
    /// Two bytes.
    U16,
    /// Two bytes, two's complement.
    I16,
    /// Half precision.
    F16,
    /// Single precision.
    F32,
}

impl Stored {
    /// Bytes of a row of so many samples.
    pub(super) const fn row(self, samples: u64) -> u64 {
        match self {
            Self::Ink => samples.div_ceil(8),
            Self::U8 => samples,
            Self::U16 | Self::I16 | Self::F16 => samples * 2,
            Self::F32 => samples * 4,
        }
    }

    /// Sample `at` of a row.
    fn get(self, row: &[u8], at: usize, big: bool) -> f64 {
        let two = |at: usize| [row[2 * at], row[2 * at + 1]];
        let four = |at: usize| [row[4 * at], row[4 * at + 1], row[4 * at + 2], row[4 * at + 3]];
        match (self, big) {
            (Self::Ink, _) => f64::from(1 - (row[at / 8] >> (7 - at % 8) & 1)),
            (Self::U8, _) => f64::from(row[at]),
            (Self::U16, true) => f64::from(u16::from_be_bytes(two(at))),
            (Self::U16, false) => f64::from(u16::from_le_bytes(two(at))),
            (Self::I16, true) => f64::from(i16::from_be_bytes(two(at))),
            (Self::I16, false) => f64::from(i16::from_le_bytes(two(at))),
            (Self::F16, true) => half(u16::from_be_bytes(two(at))),
            (Self::F16, false) => half(u16::from_le_bytes(two(at))),
            (Self::F32, true) => f64::from(f32::from_be_bytes(four(at))),
            (Self::F32, false) => f64::from(f32::from_le_bytes(four(at))),
        }
    }
}

/// A half-precision number.
pub(super) fn half(word: u16) -> f64 {
    let (exponent, fraction) = (i32::from(word >> 10 & 31), f64::from(word & 1023));
    let magnitude = match exponent {
        0 => fraction * 2f64.powi(-24),
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        _ => (1024.0 + fraction) * 2f64.powi(exponent - 25),
    };
    if word >> 15 == 1 { -magnitude } else { magnitude }
}

/// Where and how the rows lie.
pub(super) struct Layout {
    /// Byte of the first stored row.
    pub(super) offset: u64,
    /// Columns.
    pub(super) width: usize,
    /// Rows.
    pub(super) height: usize,
    /// One sample.
    pub(super) stored: Stored,
    /// The most significant byte comes first.
    pub(super) big: bool,
    /// The bottom row comes first.
    pub(super) upward: bool,
    /// No sample may be larger.
    pub(super) max: f64,
}

/// Reads them.
pub(super) struct Packed<'a> {
    handle: Handle<'a>,
    layout: Layout,
    pick: Pick,
    kind: &'static str,
    bytes: Vec<u8>,
    at: usize,
}

impl<'a> Packed<'a> {
    /// The rows of a file of this kind, which must be long enough.
    pub(super) fn new(source: &'a Source, layout: Layout, pick: Pick, kind: &'static str) -> Result<Self> {
        let row = layout.stored.row(layout.width as u64 * pick.channels() as u64);
        let there = source.len().saturating_sub(layout.offset);
        if u128::from(row) * layout.height as u128 > u128::from(there) {
            return Err(broken(
                kind,
                format!(
                    "{} x {} pixels of {row} bytes a row are announced, but only {there} bytes follow",
                    layout.width, layout.height
                ),
            ));
        }
        let mut handle = source.open()?;
        if !layout.upward {
            handle.seek(SeekFrom::Start(layout.offset)).map_err(|error| broken(kind, error))?;
        }
        Ok(Self { handle, bytes: filled(0, row as usize)?, layout, pick, kind, at: 0 })
    }
}

impl Rows for Packed<'_> {
    fn next(&mut self, row: &mut [f64]) -> Result<()> {
        let failed = |error: std::io::Error| broken(self.kind, error);
        let Layout { offset, height, stored, big, upward, max, .. } = self.layout;
        if upward {
            let from = offset + (height - 1 - self.at) as u64 * self.bytes.len() as u64;
            self.handle.seek(SeekFrom::Start(from)).map_err(failed)?;
        }
        self.handle.read_exact(&mut self.bytes).map_err(failed)?;
        let channels = self.pick.channels();
        let mut pixel = vec![0.0; channels];
        for (x, height) in row.iter_mut().enumerate() {
            for (c, sample) in pixel.iter_mut().enumerate() {
                *sample = stored.get(&self.bytes, x * channels + c, big);
                if *sample > max {
                    return Err(above(self.kind, x, self.at, *sample, max));
                }
            }
            *height = self.pick.take(&pixel, x, self.at)?;
        }
        self.at += 1;
        Ok(())
    }
}

/// A sample above the file's own maximum.
pub(super) fn above(kind: &str, x: usize, y: usize, sample: f64, max: f64) -> Error {
    broken(kind, format!("pixel ({x}, {y}) is {sample}, above its maximum {max}"))
}
