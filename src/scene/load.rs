//! Height maps from image files.
use super::height_map::{Depth, HeightMap};
use super::pgm;
use crate::error::{Error, Result};
use image::{ColorType, DynamicImage, ExtendedColorType, ImageDecoder, ImageFormat, ImageReader, Limits};
use std::io::Cursor;
use std::path::Path;

/// Reads PNG, PGM (and the other portable maps), TIFF or OpenEXR; what the file is, its content decides, not its name.
///
/// Whole numbers of n bits are divided by 2^n - 1 (a PGM's by its own maximum), with no bit lost; floats count as they are.
/// A pixel of red = green = blue has exactly that height; alpha is ignored. An EXR gives its channel `Y`, or `R`, `G`, `B`, or its only channel.
///
/// # Errors
/// [`Error::File`] if it can't be read; [`Error::Input`] if it is no such image, is broken or empty, or holds a height
/// that is not in [0, 1] (NaN and infinity included) or a pixel that is coloured, which names the pixel.
pub fn load(path: impl AsRef<Path>) -> Result<HeightMap> {
    let path = path.as_ref();
    let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
    decode(&bytes, &path.display().to_string())
}

/// As [`load`], from bytes; `name` stands for the file in the sentences.
///
/// # Errors
/// As [`load`].
pub fn decode(bytes: &[u8], name: &str) -> Result<HeightMap> {
    if bytes.is_empty() {
        return Err(Error::input(format!("{name}: the file is empty: a PNG, PGM, TIFF or OpenEXR image is needed")));
    }
    let result = match image::guess_format(bytes) {
        Ok(ImageFormat::Png) => by_image(bytes, ImageFormat::Png, "PNG"),
        Ok(ImageFormat::Pnm) if pgm::is_pgm(bytes) => pgm::decode(bytes),
        Ok(ImageFormat::Pnm) => by_image(bytes, ImageFormat::Pnm, "portable map"),
        Ok(ImageFormat::Tiff) => tiff(bytes),
        Ok(ImageFormat::OpenExr) => exr(bytes),
        _ => Err(Error::input("not an image of a known type: PNG, PGM, TIFF or OpenEXR is needed")),
    };
    result.map_err(|error| match error {
        Error::Input(text) => Error::Input(format!("{name}: {text}")),
        other => other,
    })
}

fn broken(kind: &str, error: impl std::fmt::Display) -> Error {
    let text = error.to_string();
    Error::input(format!("not a readable {kind}: {}", text.trim().trim_end_matches('.').replace('\n', " ")))
}

fn by_image(bytes: &[u8], format: ImageFormat, kind: &str) -> Result<HeightMap> {
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    reader.limits(Limits::default());
    let decoder = reader.into_decoder().map_err(|error| broken(kind, error))?;
    let (width, height) = decoder.dimensions();
    let decoded: ColorType = decoder.color_type();
    // Depths below a byte are widened on reading, but remain what the source can tell apart.
    let bits = match decoder.original_color_type() {
        ExtendedColorType::L1 => 1,
        ExtendedColorType::L2 => 2,
        ExtendedColorType::L4 => 4,
        _ => 8 * u32::from(decoded.bytes_per_pixel()) / u32::from(decoded.channel_count()),
    };
    let picture = DynamicImage::from_decoder(decoder).map_err(|error| broken(kind, error))?;
    let (channels, depth, samples) = match &picture {
        DynamicImage::ImageLuma8(pixels) => (1, Depth::Bits(bits), unit8(pixels.as_raw())),
        DynamicImage::ImageLumaA8(pixels) => (2, Depth::Bits(bits), unit8(pixels.as_raw())),
        DynamicImage::ImageRgb8(pixels) => (3, Depth::Bits(bits), unit8(pixels.as_raw())),
        DynamicImage::ImageRgba8(pixels) => (4, Depth::Bits(bits), unit8(pixels.as_raw())),
        DynamicImage::ImageLuma16(pixels) => (1, Depth::Bits(16), unit16(pixels.as_raw())),
        DynamicImage::ImageLumaA16(pixels) => (2, Depth::Bits(16), unit16(pixels.as_raw())),
        DynamicImage::ImageRgb16(pixels) => (3, Depth::Bits(16), unit16(pixels.as_raw())),
        DynamicImage::ImageRgba16(pixels) => (4, Depth::Bits(16), unit16(pixels.as_raw())),
        DynamicImage::ImageRgb32F(pixels) => (3, Depth::Float, pixels.as_raw().iter().map(|&x| x.into()).collect()),
        DynamicImage::ImageRgba32F(pixels) => (4, Depth::Float, pixels.as_raw().iter().map(|&x| x.into()).collect()),
        _ => return Err(broken(kind, "its pixels are of an unknown type")),
    };
    let heights = grey(&samples, channels, width as usize)?;
    HeightMap::new(width as usize, height as usize, heights, depth)
}

fn unit8(values: &[u8]) -> Vec<f64> {
    values.iter().map(|&value| f64::from(value) / 255.0).collect()
}

fn unit16(values: &[u16]) -> Vec<f64> {
    values.iter().map(|&value| f64::from(value) / 65535.0).collect()
}

/// The one channel of pixels in rows of `width`: a height map holds no colour, and which mixture of three channels would be the height is
/// not ours to guess. Of a pixel with a channel out of range that channel is taken, for whoever checks the range.
fn grey(samples: &[f64], channels: usize, width: usize) -> Result<Vec<f64>> {
    let height = |(at, pixel): (usize, &[f64])| match pixel[..channels.min(3)] {
        [red, green, blue] => {
            let colours = [red, green, blue];
            match colours.into_iter().find(|c| !(0.0..=1.0).contains(c)) {
                Some(illegal) => Ok(illegal),
                None if red == green && green == blue => Ok(red),
                None => Err(Error::input(format!(
                    "a picture in colour (pixel ({}, {}) has red, green and blue {red}, {green}, {blue}): a height map has one channel, or three that are equal",
                    at % width,
                    at / width
                ))),
            }
        }
        _ => Ok(pixel[0]),
    };
    samples.chunks_exact(channels).enumerate().map(height).collect()
}

/// Grey TIFFs, which `image` reads in 8 and 16 bits only; colour goes through `image`.
fn tiff(bytes: &[u8]) -> Result<HeightMap> {
    use tiff::ColorType::Gray;
    use tiff::decoder::DecodingResult;
    let failed = |error: tiff::TiffError| broken("TIFF", error);
    let mut decoder = tiff::decoder::Decoder::new(Cursor::new(bytes)).map_err(failed)?;
    let (width, height) = decoder.dimensions().map_err(failed)?;
    if width == 0 || height == 0 {
        return Err(Error::input(format!("an empty image ({width} x {height}): at least one pixel is needed")));
    }
    let Gray(8 | 16 | 32 | 64) = decoder.colortype().map_err(failed)? else {
        return by_image(bytes, ImageFormat::Tiff, "TIFF");
    };
    let (depth, samples) = match decoder.read_image().map_err(failed)? {
        DecodingResult::U8(values) => (Depth::Bits(8), unit8(&values)),
        DecodingResult::U16(values) => (Depth::Bits(16), unit16(&values)),
        DecodingResult::U32(values) => {
            (Depth::Bits(32), values.iter().map(|&value| f64::from(value) / f64::from(u32::MAX)).collect())
        }
        DecodingResult::F16(values) => (Depth::Float, values.iter().map(|value| value.to_f64()).collect()),
        DecodingResult::F32(values) => (Depth::Float, values.iter().map(|&value| value.into()).collect()),
        DecodingResult::F64(values) => (Depth::Float, values),
        _ => return Err(broken("TIFF", "unsigned whole numbers of at most 32 bits, or floats, are needed")),
    };
    HeightMap::new(width as usize, height as usize, samples, depth)
}

/// Read by `exr` itself, because `image` knows only EXRs with the three colours.
fn exr(bytes: &[u8]) -> Result<HeightMap> {
    use exr::prelude::{FlatSamples, ReadChannels, ReadLayers, read};
    let file = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .map_err(|error| broken("OpenEXR", error))?;
    let layer = &file.layer_data;
    let channels = &layer.channel_data.list;
    let find = |name: &str| channels.iter().find(|channel| channel.name.eq(name));
    let chosen = match (find("Y"), find("R"), find("G"), find("B"), channels.as_slice()) {
        (Some(grey), ..) => vec![grey],
        (_, Some(red), Some(green), Some(blue), _) => vec![red, green, blue],
        (.., [only]) => vec![only],
        _ => {
            let names: Vec<_> = channels.iter().map(|channel| channel.name.to_string()).collect();
            return Err(broken(
                "OpenEXR",
                format!("it has the channels {}; Y, or R, G and B, or one alone are needed", names.join(", ")),
            ));
        }
    };
    if chosen.iter().any(|channel| channel.sampling != exr::math::Vec2(1, 1)) {
        return Err(broken("OpenEXR", "its channels are subsampled"));
    }
    let planes: Vec<Vec<f64>> = chosen
        .iter()
        .map(|channel| match &channel.sample_data {
            FlatSamples::F16(values) => values.iter().map(|value| value.to_f64()).collect(),
            FlatSamples::F32(values) => values.iter().map(|&value| value.into()).collect(),
            // EXR's whole numbers are identifiers; only 0 and 1 are heights.
            FlatSamples::U32(values) => values.iter().map(|&value| value.into()).collect(),
        })
        .collect();
    let samples = match planes.as_slice() {
        [red, green, blue] => {
            let pixels: Vec<f64> = red.iter().zip(green).zip(blue).flat_map(|((&r, &g), &b)| [r, g, b]).collect();
            grey(&pixels, 3, layer.size.width())?
        }
        _ => planes.into_iter().next().unwrap_or_default(),
    };
    HeightMap::new(layer.size.width(), layer.size.height(), samples, Depth::Float)
}
