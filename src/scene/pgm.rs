//! Portable grey maps (P2, P5).
//!
//! Read here because a maximum other than 255 or 65535 must not be rescaled on the way: 10-bit data stays 10-bit.
use super::height_map::{Depth, HeightMap};
use crate::error::{Error, Result};

pub(super) fn is_pgm(bytes: &[u8]) -> bool {
    matches!(bytes, [b'P', b'2' | b'5', ..])
}

fn broken(text: impl std::fmt::Display) -> Error {
    Error::input(format!("not a readable PGM: {text}"))
}

/// The whitespace-separated words of the header (and of P2's data), comments skipped.
struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<&'a [u8]> {
        loop {
            match self.bytes.get(self.at)? {
                b'#' => {
                    while self.bytes.get(self.at).is_some_and(|&byte| byte != b'\n' && byte != b'\r') {
                        self.at += 1;
                    }
                }
                byte if byte.is_ascii_whitespace() => self.at += 1,
                _ => break,
            }
        }
        let start = self.at;
        while self.bytes.get(self.at).is_some_and(|byte| !byte.is_ascii_whitespace() && *byte != b'#') {
            self.at += 1;
        }
        Some(&self.bytes[start..self.at])
    }

    fn number(&mut self, what: &str) -> Result<usize> {
        let word = self.next().ok_or_else(|| broken(format!("it ends before {what}")))?;
        let text = String::from_utf8_lossy(word);
        let digits = word.iter().all(u8::is_ascii_digit);
        text.parse().ok().filter(|_| digits).ok_or_else(|| {
            let shown: String = text.chars().take(20).collect();
            broken(format!("{shown:?} is not a number where {what} should stand"))
        })
    }
}

pub(super) fn decode(bytes: &[u8]) -> Result<HeightMap> {
    let mut words = Words { bytes, at: 2 };
    let width = words.number("the width")?;
    let height = words.number("the height")?;
    let max = words.number("the maximum")?;
    if !(1..=65535).contains(&max) {
        return Err(broken(format!("its maximum is {max}, 1 to 65535 are legal")));
    }
    if width == 0 || height == 0 {
        return Err(Error::input(format!("an empty image ({width} x {height}): at least one pixel is needed")));
    }
    let sample = if max > 255 { 2 } else { 1 };
    let plain = bytes[1] == b'2';
    // One whitespace byte ends P5's header. A plain number takes two bytes, except that the last needs no space.
    let data = bytes.get(words.at + 1..).unwrap_or_default();
    let room = if plain { data.len().div_ceil(2) } else { data.len() / sample };
    let count = width.checked_mul(height).filter(|&count| count <= room).ok_or_else(|| {
        broken(format!("{width} x {height} pixels of {max} levels are announced, but only {} bytes follow", data.len()))
    })?;
    let mut samples = Vec::with_capacity(count);
    for at in 0..count {
        let value = if plain {
            words.number(&format!("pixel ({}, {})", at % width, at / width))?
        } else if sample == 2 {
            usize::from(u16::from_be_bytes([data[2 * at], data[2 * at + 1]]))
        } else {
            usize::from(data[at])
        };
        if value > max {
            return Err(broken(format!("pixel ({}, {}) is {value}, above its maximum {max}", at % width, at / width)));
        }
        samples.push(value as f64 / max as f64);
    }
    HeightMap::new(width, height, samples, Depth::Bits(max.ilog2() + 1))
}
