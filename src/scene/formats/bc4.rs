//! Block compression of one channel: 4 x 4 texels in 8 bytes, two ends and a place between them for each.
use super::opened::{Rows, broken, filled};
use crate::source::{Handle, Source};
use reliefrtl_base::error::Result;
use std::io::SeekFrom;

const KIND: &str = "BC4";

pub(super) struct Bc4<'a> {
    handle: Handle<'a>,
    /// A row of blocks.
    bytes: Vec<u8>,
    at: usize,
}

impl<'a> Bc4<'a> {
    pub(super) fn new(source: &'a Source, offset: u64, width: usize, height: usize) -> Result<Self> {
        let row = width.div_ceil(4) * 8;
        let there = source.len().saturating_sub(offset);
        if (row as u64) * height.div_ceil(4) as u64 > there {
            return Err(broken(
                KIND,
                format!("{width} x {height} pixels are announced, but only {there} bytes follow"),
            ));
        }
        let mut handle = source.open()?;
        handle.seek(SeekFrom::Start(offset)).map_err(|error| broken(KIND, error))?;
        Ok(Self { handle, bytes: filled(0, row)?, at: 0 })
    }
}

/// The value of texel `at` of a block, in 1/255, not rounded: between the ends lie six more, or four and 0 and 255.
fn value(block: &[u8], at: usize) -> f64 {
    let (first, last) = (f64::from(block[0]), f64::from(block[1]));
    let places = block[2..8].iter().rev().fold(0u64, |word, &byte| word << 8 | u64::from(byte));
    let place = f64::from((places >> (3 * at) & 7) as u32);
    match (block[0] > block[1], place as u32) {
        (_, 0) => first,
        (_, 1) => last,
        (false, 6) => 0.0,
        (false, 7) => 255.0,
        (more, _) => {
            let parts = if more { 7.0 } else { 5.0 };
            ((parts + 1.0 - place) * first + (place - 1.0) * last) / parts
        }
    }
}

impl Rows for Bc4<'_> {
    fn next(&mut self, row: &mut [f64]) -> Result<()> {
        if self.at.is_multiple_of(4) {
            self.handle.read_exact(&mut self.bytes).map_err(|error| broken(KIND, error))?;
        }
        for (x, height) in row.iter_mut().enumerate() {
            *height = value(&self.bytes[x / 4 * 8..][..8], self.at % 4 * 4 + x % 4);
        }
        self.at += 1;
        Ok(())
    }
}
