//! The files that height maps come in: what each is known by, and its rows in the file's own numbers, top to bottom.
//!
//! Every reader tells the dimensions first, from the header alone; nothing is allocated before [`sized`] has agreed to them.
mod asc;
mod bc4;
mod dds;
mod exr;
mod image;
mod netpbm;
mod orient;
mod packed;
mod pick;
mod plain;
mod png;
mod raw;
mod tiff;
mod tiff_chunks;
mod tiff_packed;

use super::source::{Handle, Source};
use crate::config::check::plain as plain_number;
use crate::config::{ByteOrder, MapConfig};
use crate::error::{Error, Result};
use std::fmt;
use std::io::Read;

/// What is read, for the sentences about files that are not.
pub(super) const READ: &str = "PNG, PGM (PBM, PPM, PAM), PFM, TIFF (BigTIFF, GeoTIFF), OpenEXR, BMP, TGA, lossless WebP, DDS (R8, R16, R32F, BC4), SRTM HGT, ESRI ASC, and R16 / RAW with map.size";

/// The rows of a file, top to bottom, in the file's own numbers.
pub(super) trait Rows {
    /// The next row, of as many samples as the file has columns.
    fn next(&mut self, row: &mut [f64]) -> Result<()>;
}

/// The numbers that a file holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Samples {
    /// Whole numbers from 0 to this one.
    Unsigned(u64),
    /// Whole numbers of either sign, of this many bits.
    Signed(u32),
    /// Floating point of this many bits; 64 for numbers in text.
    Float(u32),
}

impl Samples {
    /// Whole numbers of `bits` bits.
    const fn bits(bits: u32) -> Self {
        Self::Unsigned(if bits >= 64 { u64::MAX } else { (1 << bits) - 1 })
    }

    /// The largest value, of floats 1: full height, and opaque alpha.
    pub(super) const fn full(self) -> f64 {
        match self {
            Self::Unsigned(max) => max as f64,
            Self::Signed(bits) => ((1u64 << (bits - 1)) - 1) as f64,
            Self::Float(_) => 1.0,
        }
    }

    /// Whether a sample is this no-data value, as exactly as the file could say it.
    pub(super) fn same(self, sample: f64, value: f64) -> bool {
        match self {
            Self::Float(16) => (sample - value).abs() <= value.abs() / 2048.0,
            Self::Float(32) => sample as f32 == value as f32,
            _ => sample == value,
        }
    }
}

impl fmt::Display for Samples {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unsigned(max) if (max + 1).is_power_of_two() => write!(f, "{}-bit", (max + 1).ilog2()),
            Self::Unsigned(max) => write!(f, "0 to {max}"),
            Self::Signed(bits) => write!(f, "signed {bits}-bit"),
            Self::Float(bits) => write!(f, "{bits}-bit float"),
        }
    }
}

/// What the header says.
pub(super) struct Info {
    /// Kind of file.
    pub(super) format: &'static str,
    /// Columns.
    pub(super) width: usize,
    /// Rows.
    pub(super) height: usize,
    /// Numbers.
    pub(super) samples: Samples,
    /// Channel that is taken.
    pub(super) channel: String,
    /// Part or page that is taken, where the file has several.
    pub(super) part: Option<String>,
    /// The value that the file itself calls no data.
    pub(super) nodata: Option<f64>,
    /// What else there is to say.
    pub(super) note: Option<String>,
}

impl Info {
    /// One channel of one picture.
    fn new(format: &'static str, width: usize, height: usize, samples: Samples) -> Self {
        Self { format, width, height, samples, channel: "Y".into(), part: None, nodata: None, note: None }
    }
}

/// A file whose header was read.
pub(super) struct Opened<'a> {
    /// What it says.
    pub(super) info: Info,
    /// What comes next.
    pub(super) rows: Box<dyn Rows + 'a>,
}

/// What libraries say in words that tell nothing of the file, and what is meant.
const SAID: [(&str, &str); 11] = [
    ("failed to fill whole buffer", "its data end early"),
    ("The Decoder limits are exceeded", "it asks for more memory than its pixels need"),
    ("limits are exceeded", "it asks for more memory than its pixels need"),
    ("Memory limit exceeded", "it asks for more memory than its pixels need"),
    ("Image size exceeds limit", "it asks for more memory than its pixels need"),
    ("decoder limits exceeded", "it asks for more memory than its pixels need"),
    ("platform or format size limits exceeded", "a number in its tags is larger than any picture needs"),
    (
        "inconsistent sizes encountered",
        "its tags contradict each other: SamplesPerPixel, BitsPerSample and ExtraSamples, or ImageLength, RowsPerStrip or TileLength, and how many StripOffsets or TileOffsets and byte counts there are",
    ),
    ("invalid: reference to missing bytes", "its data end early"),
    ("invalid: ", "invalid "),
    ("unsupported error: ", ""),
];

/// A sentence about a file that its own kind's reader can't read.
fn broken(kind: &str, error: impl fmt::Display) -> Error {
    let mut text = error.to_string();
    for (theirs, ours) in SAID {
        text = text.replace(theirs, ours);
    }
    for before in ["Format error decoding ", "Format error: ", "format error: "] {
        if let Some((_, rest)) = text.split_once(before) {
            // The kind of file was named.
            text = rest.split_once(": ").filter(|_| before.ends_with("decoding ")).map_or(rest, |r| r.1).to_owned();
        }
    }
    // All that a chunk of a PNG is, for its name.
    while let Some((head, (name, rest))) =
        text.split_once("ChunkType { type: ").and_then(|(head, rest)| Some((head, rest.split_once(", ")?)))
    {
        text = format!("{head}{name}{}", rest.split_once('}').map_or("", |r| r.1));
    }
    Error::input(format!("not a readable {kind}: {}", text.trim().trim_end_matches('.').replace(['\n', '\r'], " ")))
}

/// The most that `map.max_texels` may be.
const MAX_TEXELS: u64 = 1 << 40;

/// Dimensions that may be read, before anything is allocated for them.
fn sized(width: u64, height: u64, map: &MapConfig) -> Result<(usize, usize)> {
    if width == 0 || height == 0 {
        return Err(Error::input(format!("an empty image ({width} x {height}): at least one pixel is needed")));
    }
    let texels = u128::from(width) * u128::from(height);
    let limit = map.max_texels;
    if texels > u128::from(MAX_TEXELS) {
        return Err(Error::input(format!(
            "{width} x {height} are {texels} texels, more than map.max_texels may be ({MAX_TEXELS})"
        )));
    }
    if texels > u128::from(limit) {
        return Err(Error::input(format!(
            "{width} x {height} are {texels} texels, more than map.max_texels = {limit}: if they are meant, ask for them with --max-texels {texels}"
        )));
    }
    Ok((width as usize, height as usize))
}

/// What there is to say of cells of this width and height.
fn oblong(width: f64, height: f64) -> Option<String> {
    let (across, down) = (plain_number(width), plain_number(height));
    // What a single-precision number or a few decimals can't tell apart is square.
    let oblong = (width.abs() - height.abs()).abs() > width.abs().max(height.abs()) * 1e-4;
    oblong.then(|| format!("its cells are {across} x {down}, and each is taken as a square texel"))
}

/// What there is to say, in one.
fn noted(notes: impl IntoIterator<Item = Option<String>>) -> Option<String> {
    let said: Vec<String> = notes.into_iter().flatten().collect();
    (!said.is_empty()).then(|| said.join("; "))
}

/// So many equal values, or a sentence where that is more memory than there is.
pub(super) fn filled<T: Copy>(value: T, count: usize) -> Result<Vec<T>> {
    let mut list = Vec::new();
    list.try_reserve_exact(count).map_err(|_| {
        let bytes = count as u128 * std::mem::size_of::<T>() as u128;
        Error::input(format!("its size asks for {bytes} bytes of memory at once, which are not to be had"))
    })?;
    list.resize(count, value);
    Ok(list)
}

/// Opens the file, by its content where that tells, else by its name or because `map.size` is given.
pub(super) fn open<'a>(source: &'a Source, map: &'a MapConfig) -> Result<Opened<'a>> {
    if source.len() == 0 {
        return Err(Error::input(format!("the file is empty: {READ} are read")));
    }
    let mut head = Vec::new();
    source.open()?.take(64).read_to_end(&mut head).map_err(|error| broken("file", error))?;
    let opened = known(source, map, &head)?;
    let format = opened.info.format;
    if let (Some(asked), None) = (map.part.as_ref().filter(|asked| *asked != "0"), &opened.info.part) {
        return Err(Error::input(format!("there is no part {asked:?} (map.part): the {format} is one picture")));
    }
    if map.byte_order != ByteOrder::Little && format != raw::RAW && format != raw::HGT {
        return Err(Error::input(format!(
            "the {format} says itself in which order its bytes are: leave out map.byte_order = \"{}\", for only files without a header need it",
            map.byte_order
        )));
    }
    if let (Some([width, height]), true) = (map.size, opened.info.format != raw::RAW && opened.info.format != raw::HGT)
    {
        let there = (opened.info.width, opened.info.height);
        if there != (width as usize, height as usize) {
            return Err(Error::input(format!(
                "the {} is {} x {}, but map.size = [{width}, {height}]: leave it out, for only files without a header need it",
                opened.info.format, there.0, there.1
            )));
        }
    }
    Ok(opened)
}

fn known<'a>(source: &'a Source, map: &'a MapConfig, head: &[u8]) -> Result<Opened<'a>> {
    let handle = || -> Result<Handle<'a>> { source.open() };
    let webp = head.len() >= 12 && head.starts_with(b"RIFF") && &head[8..12] == b"WEBP";
    match head {
        [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', ..] => return png::open(handle()?, map),
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => return tiff::open(handle()?, source.len(), map),
        [0x76, 0x2f, 0x31, 0x01, ..] => return exr::open(handle()?, source.len(), map),
        [b'D', b'D', b'S', b' ', ..] => return dds::open(source, map),
        _ if webp => return image::webp(source, map),
        _ => {}
    }
    let named = |endings: &[&str]| endings.iter().any(|ending| source.name().to_ascii_lowercase().ends_with(ending));
    // What has no header is known by its name; its first texels may look like anything.
    if named(&[".hgt"]) {
        return raw::hgt(source, map);
    }
    if named(&[".r16", ".r8", ".r32", ".raw"]) {
        return raw::open(source, map);
    }
    match head {
        [b'P', b'1'..=b'7', next, ..] if next.is_ascii_whitespace() || *next == b'#' => {
            return netpbm::open(source, map);
        }
        [b'P', b'f' | b'F', next, ..] if next.is_ascii_whitespace() => return netpbm::open_pfm(source, map),
        [b'B', b'M', ..] => return image::open(source, map, ::image::ImageFormat::Bmp, "BMP"),
        [0xff, 0xd8, 0xff, ..] => return image::jpeg(source, map),
        _ if asc::is_asc(head) => return asc::open(source, map),
        _ if named(&[".tga"]) || image::has_tga_footer(source)? => {
            return image::open(source, map, ::image::ImageFormat::Tga, "TGA");
        }
        _ if map.size.is_some() => return raw::open(source, map),
        _ => {}
    }
    let wide = head.starts_with(b"\xff\xfe") || head.starts_with(b"\xfe\xff");
    let hint = if wide { " (it looks like UTF-16 text: text is read as ASCII or UTF-8)" } else { "" };
    Err(Error::input(format!("not a file of a known kind{hint}: {READ} are read")))
}
