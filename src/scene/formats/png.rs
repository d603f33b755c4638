//! PNG at its own depth, row by row.
use super::opened::{Info, Opened, Rows, Samples, broken, filled, sized};
use super::orient::{of_exif, upright};
use super::pick::Pick;
use crate::source::Handle;
use png::{ColorType, DecodeOptions, Decoder, Limits, Reader, Transformations};
use reliefrtl_base::error::Result;
use reliefrtl_config::MapConfig;

const KIND: &str = "PNG";
/// What may be allocated for a header, in bytes; rows are counted by [`sized`].
const HEADER: usize = 64 << 20;

/// What the samples of a pixel mean.
enum Pixel {
    /// As they stand.
    Plain,
    /// They and an opacity that is 0 where they are this one colour.
    Keyed(Vec<f64>),
    /// A number in this palette of red, green, blue and opacity.
    Palette(Vec<[f64; 4]>),
}

pub(super) fn open<'a>(handle: Handle<'a>, map: &MapConfig) -> Result<Opened<'a>> {
    let mut options = DecodeOptions::default();
    // A byte that was damaged would be another height.
    options.set_ignore_checksums(false);
    let mut decoder = Decoder::new_with_options(handle, options);
    decoder.set_limits(Limits { bytes: HEADER });
    decoder.set_transformations(Transformations::IDENTITY);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    let reader = decoder.read_info().map_err(|error| broken(KIND, error))?;
    let header = reader.info();
    let (width, height) = sized(header.width.into(), header.height.into(), map)?;
    let bits = header.bit_depth as u32;
    let (stored, names): (usize, &[&str]) = match header.color_type {
        ColorType::Grayscale => (1, &["Y"]),
        ColorType::GrayscaleAlpha => (2, &["Y", "A"]),
        ColorType::Rgb | ColorType::Indexed => (3, &["R", "G", "B"]),
        ColorType::Rgba => (4, &["R", "G", "B", "A"]),
    };
    let with_alpha: &[&str] = if stored == 1 { &["Y", "A"] } else { &["R", "G", "B", "A"] };
    let (meaning, names, samples, stored) = match (header.color_type, &header.trns) {
        (ColorType::Indexed, opacity) => {
            let colours = header.palette.as_deref().unwrap_or_default();
            let alpha = |at: usize| opacity.as_ref().and_then(|list| list.get(at)).map_or(255.0, |&a| f64::from(a));
            let entry = |(at, c): (usize, &[u8])| [f64::from(c[0]), f64::from(c[1]), f64::from(c[2]), alpha(at)];
            let palette: Vec<[f64; 4]> = colours.chunks_exact(3).enumerate().map(entry).collect();
            let names = if opacity.is_some() { with_alpha } else { names };
            (Pixel::Palette(palette), names, Samples::bits(8), 1)
        }
        // Two bytes a sample, of which the crate leaves the lower ones where samples are bytes.
        (ColorType::Grayscale | ColorType::Rgb, Some(key)) if [stored, 2 * stored].contains(&key.len()) => {
            let word = |bytes: &[u8]| bytes.iter().fold(0u16, |word, byte| word << 8 | u16::from(*byte));
            let key = key.chunks_exact(key.len() / stored).map(|bytes| f64::from(word(bytes))).collect();
            (Pixel::Keyed(key), with_alpha, Samples::bits(bits), stored)
        }
        _ => (Pixel::Plain, names, Samples::bits(bits), stored),
    };
    let pick = Pick::new(names, samples.full(), map)?;
    let orientation = of_exif(header.exif_metadata.as_deref());
    let info = Info { channel: pick.label(), ..Info::new(KIND, width, height, samples) };
    let opaque = samples.full();
    let rows = PngRows { reader, meaning, pick, bits, stored, opaque, whole: None, at: 0 };
    upright(Opened { info, rows: Box::new(rows) }, orientation)
}

struct PngRows<'a> {
    reader: Reader<Handle<'a>>,
    meaning: Pixel,
    pick: Pick,
    bits: u32,
    /// Samples of a pixel in the file.
    stored: usize,
    opaque: f64,
    /// The whole picture, where its rows come in seven passes.
    whole: Option<Vec<u8>>,
    at: usize,
}

/// Sample `at` of a row of `bits` bits each.
fn sample(row: &[u8], at: usize, bits: u32) -> f64 {
    match bits {
        16 => f64::from(u16::from_be_bytes([row[2 * at], row[2 * at + 1]])),
        8 => f64::from(row[at]),
        _ => {
            let per = 8 / bits as usize;
            let shift = 8 - bits - (at % per) as u32 * bits;
            f64::from(row[at / per] >> shift & ((1 << bits) - 1))
        }
    }
}

impl PngRows<'_> {
    fn pixels(&self, bytes: &[u8], row: &mut [f64]) -> Result<()> {
        let mut pixel = vec![0.0; self.pick.channels()];
        for (x, height) in row.iter_mut().enumerate() {
            match &self.meaning {
                Pixel::Palette(palette) => {
                    let number = sample(bytes, x, self.bits) as usize;
                    let entry = palette.get(number).ok_or_else(|| {
                        broken(
                            KIND,
                            format!("pixel ({x}, {}) is number {number} of {} colours", self.at, palette.len()),
                        )
                    })?;
                    pixel.copy_from_slice(&entry[..self.pick.channels()]);
                }
                meaning => {
                    for (c, value) in pixel[..self.stored].iter_mut().enumerate() {
                        *value = sample(bytes, x * self.stored + c, self.bits);
                    }
                    if let Pixel::Keyed(key) = meaning {
                        pixel[self.stored] = if pixel[..self.stored] == key[..] { 0.0 } else { self.opaque };
                    }
                }
            }
            *height = self.pick.take(&pixel, x, self.at)?;
        }
        Ok(())
    }
}

impl Rows for PngRows<'_> {
    fn next(&mut self, row: &mut [f64]) -> Result<()> {
        let failed = |error: png::DecodingError| broken(KIND, error);
        if self.reader.info().interlaced && self.whole.is_none() {
            let size = self.reader.output_buffer_size().ok_or_else(|| broken(KIND, "it is too large"))?;
            let mut whole = filled(0, size)?;
            self.reader.next_frame(&mut whole).map_err(failed)?;
            self.whole = Some(whole);
        }
        if let Some(whole) = self.whole.take() {
            let stride = (row.len() * self.stored * self.bits as usize).div_ceil(8);
            let bytes = whole.get(self.at * stride..(self.at + 1) * stride);
            let done = self.pixels(bytes.ok_or_else(|| broken(KIND, "its rows end early"))?, row);
            self.whole = Some(whole);
            done?;
        } else {
            let line = self.reader.next_row().map_err(failed)?;
            let bytes = line.ok_or_else(|| broken(KIND, "its rows end early"))?.data().to_vec();
            self.pixels(&bytes, row)?;
        }
        self.at += 1;
        if self.at == self.reader.info().height as usize {
            // The last checksums stand after the last row.
            self.reader.finish().map_err(failed)?;
        }
        Ok(())
    }
}
