//! Kinds that the crate `image` reads whole: BMP, TGA, WebP, and JPEG where it is asked for.
use super::opened::{Info, Opened, Rows, Samples, broken, filled, sized};
use super::orient::{of_exif, upright};
use super::pick::Pick;
use crate::source::Source;
use image::{ColorType, ImageDecoder, ImageFormat, ImageReader, Limits};
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::MapConfig;
use std::io::{Read, SeekFrom};

/// What a decoder may allocate besides the picture itself, in bytes.
const BESIDE: u64 = 64 << 20;

pub(super) fn open<'a>(
    source: &'a Source,
    map: &MapConfig,
    format: ImageFormat,
    kind: &'static str,
) -> Result<Opened<'a>> {
    let failed = |error: image::ImageError| broken(kind, error);
    if format == ImageFormat::Bmp {
        bmp_sides(source, map)?;
    }
    let mut limits = Limits::default();
    limits.max_alloc = Some(map.max_texels.saturating_mul(8).saturating_add(BESIDE));
    let mut reader = ImageReader::with_format(source.open()?, format);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(failed)?;
    let (width, height) = decoder.dimensions();
    let (width, height) = sized(width.into(), height.into(), map)?;
    let orientation = of_exif(decoder.exif_metadata().map_err(failed)?.as_deref());
    let colour = decoder.color_type();
    let names: &[&str] = match colour {
        ColorType::L8 | ColorType::L16 => &["Y"],
        ColorType::La8 | ColorType::La16 => &["Y", "A"],
        ColorType::Rgb8 | ColorType::Rgb16 => &["R", "G", "B"],
        ColorType::Rgba8 | ColorType::Rgba16 => &["R", "G", "B", "A"],
        _ => return Err(broken(kind, "its pixels are of an unknown kind")),
    };
    let wide = colour.bytes_per_pixel() as usize / names.len() == 2;
    let samples = Samples::bits(if wide { 16 } else { 8 });
    let pick = Pick::new(names, samples.full(), map)?;
    let size = decoder.total_bytes();
    if size != (width * height * usize::from(colour.bytes_per_pixel())) as u64 {
        return Err(broken(kind, "its size is not what its header says"));
    }
    // Run lengths pack at most 255 pixels of a BMP into two bytes, and 128 of a TGA.
    let per_byte = match format {
        ImageFormat::Bmp => 128,
        ImageFormat::Tga => 64,
        _ => u64::MAX,
    };
    if (width * height) as u64 / per_byte > source.len() {
        return Err(broken(kind, format!("{width} x {height} pixels are announced in {} bytes", source.len())));
    }
    let mut bytes = filled(0, size as usize)?;
    decoder.read_image(&mut bytes).map_err(failed)?;
    let info = Info { channel: pick.label(), ..Info::new(kind, width, height, samples) };
    let rows = Whole { bytes, pick, wide, at: 0 };
    upright(Opened { info, rows: Box::new(rows) }, orientation)
}

/// The sides that a BMP's header announces, looked at before the crate's own limit speaks.
fn bmp_sides(source: &Source, map: &MapConfig) -> Result<()> {
    const MOST: u64 = 65535;
    let mut head = Vec::new();
    source.open()?.take(26).read_to_end(&mut head).map_err(|error| broken("BMP", error))?;
    // The oldest header has 16 bits a side; a negative height is that of rows from the top.
    let Some(sides) = head.get(18..26).filter(|_| head[14..18] != [12, 0, 0, 0]) else { return Ok(()) };
    let side = |at: usize| i32::from_le_bytes([sides[at], sides[at + 1], sides[at + 2], sides[at + 3]]);
    let (width, height) = (side(0), u64::from(side(4).unsigned_abs()));
    // A negative width has a sentence of its own.
    let Ok(width) = u64::try_from(width) else { return Ok(()) };
    sized(width, height, map)?;
    if width.max(height) > MOST {
        return Err(broken(
            "BMP",
            format!("it is {width} x {height}, and up to {MOST} columns and rows are read of one"),
        ));
    }
    Ok(())
}

/// A picture in memory.
struct Whole {
    bytes: Vec<u8>,
    pick: Pick,
    /// Two bytes a sample, in the machine's order.
    wide: bool,
    at: usize,
}

impl Rows for Whole {
    fn next(&mut self, row: &mut [f64]) -> Result<()> {
        let channels = self.pick.channels();
        let from = self.at * row.len() * channels;
        let mut pixel = vec![0.0; channels];
        for (x, height) in row.iter_mut().enumerate() {
            for (c, sample) in pixel.iter_mut().enumerate() {
                let at = from + x * channels + c;
                *sample = if self.wide {
                    f64::from(u16::from_ne_bytes([self.bytes[2 * at], self.bytes[2 * at + 1]]))
                } else {
                    f64::from(self.bytes[at])
                };
            }
            *height = self.pick.take(&pixel, x, self.at)?;
        }
        self.at += 1;
        Ok(())
    }
}

fn lossy(kind: &str) -> Error {
    Error::input(format!(
        "{kind} is compressed with loss: its heights are not those that were stored, and steps between them become waves; use a format without loss (PNG, TIFF, OpenEXR), or read it all the same with --set map.lossy=true"
    ))
}

/// JPEG, where it is asked for.
pub(super) fn jpeg<'a>(source: &'a Source, map: &MapConfig) -> Result<Opened<'a>> {
    if !map.lossy {
        return Err(lossy("a JPEG"));
    }
    open(source, map, ImageFormat::Jpeg, "JPEG")
}

/// WebP; with loss where it is asked for.
pub(super) fn webp<'a>(source: &'a Source, map: &MapConfig) -> Result<Opened<'a>> {
    if !map.lossy && !lossless(source)? {
        return Err(lossy("this WebP"));
    }
    open(source, map, ImageFormat::WebP, "WebP")
}

/// Whether the first picture of a WebP is stored without loss.
fn lossless(source: &Source) -> Result<bool> {
    let failed = |error: std::io::Error| broken("WebP", error);
    let mut handle = source.open()?;
    let mut at = 12;
    // A picture comes after a few chunks about it.
    for _ in 0..64 {
        handle.seek(SeekFrom::Start(at)).map_err(failed)?;
        let mut head = [0; 8];
        handle.read_exact(&mut head).map_err(failed)?;
        let size = u64::from(u32::from_le_bytes([head[4], head[5], head[6], head[7]]));
        match &head[..4] {
            b"VP8L" => return Ok(true),
            b"VP8 " => return Ok(false),
            b"ANIM" | b"ANMF" => return Err(broken("WebP", "it is animated, and a map is one picture")),
            _ => at += 8 + size + size % 2,
        }
    }
    Err(broken("WebP", "there is no picture in it"))
}

/// Whether the file ends as newer TGA files do.
pub(super) fn has_tga_footer(source: &Source) -> Result<bool> {
    const FOOTER: &[u8; 18] = b"TRUEVISION-XFILE.\0";
    let Some(at) = source.len().checked_sub(FOOTER.len() as u64) else { return Ok(false) };
    let failed = |error: std::io::Error| broken("file", error);
    let mut handle = source.open()?;
    handle.seek(SeekFrom::Start(at)).map_err(failed)?;
    let mut there = Vec::new();
    handle.take(FOOTER.len() as u64).read_to_end(&mut there).map_err(failed)?;
    Ok(there == FOOTER)
}
