//! What a reader makes of a file: what its header says, then its rows; and what all readers share.
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::MapConfig;
use reliefrtl_config::check::plain as plain_number;
use std::fmt;

/// The rows of a file, top to bottom, in the file's own numbers.
pub(crate) trait Rows {
    /// The next row, of as many samples as the file has columns.
    fn next(&mut self, row: &mut [f64]) -> Result<()>;
}

/// The numbers that a file holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Samples {
    /// Whole numbers from 0 to this one.
    Unsigned(u64),
    /// Whole numbers of either sign, of this many bits.
    Signed(u32),
    /// Floating point of this many bits; 64 for numbers in text.
    Float(u32),
}

impl Samples {
    /// Whole numbers of `bits` bits.
    pub(super) const fn bits(bits: u32) -> Self {
        Self::Unsigned(if bits >= 64 { u64::MAX } else { (1 << bits) - 1 })
    }

    /// The largest value, of floats 1: full height, and opaque alpha.
    pub(crate) const fn full(self) -> f64 {
        match self {
            Self::Unsigned(max) => max as f64,
            Self::Signed(bits) => ((1u64 << (bits - 1)) - 1) as f64,
            Self::Float(_) => 1.0,
        }
    }

    /// Whether a sample is this no-data value, as exactly as the file could say it.
    pub(crate) fn same(self, sample: f64, value: f64) -> bool {
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
pub(crate) struct Info {
    /// Kind of file.
    pub(crate) format: &'static str,
    /// Columns.
    pub(crate) width: usize,
    /// Rows.
    pub(crate) height: usize,
    /// Numbers.
    pub(crate) samples: Samples,
    /// Channel that is taken.
    pub(crate) channel: String,
    /// Part or page that is taken, where the file has several.
    pub(crate) part: Option<String>,
    /// The value that the file itself calls no data.
    pub(crate) nodata: Option<f64>,
    /// What else there is to say.
    pub(crate) note: Option<String>,
}

impl Info {
    /// One channel of one picture.
    pub(super) fn new(format: &'static str, width: usize, height: usize, samples: Samples) -> Self {
        Self { format, width, height, samples, channel: "Y".into(), part: None, nodata: None, note: None }
    }
}

/// A file whose header was read.
pub(crate) struct Opened<'a> {
    /// What it says.
    pub(crate) info: Info,
    /// What comes next.
    pub(crate) rows: Box<dyn Rows + 'a>,
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
pub(super) fn broken(kind: &str, error: impl fmt::Display) -> Error {
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
pub(super) fn sized(width: u64, height: u64, map: &MapConfig) -> Result<(usize, usize)> {
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
pub(super) fn oblong(width: f64, height: f64) -> Option<String> {
    let (across, down) = (plain_number(width), plain_number(height));
    // What a single-precision number or a few decimals can't tell apart is square.
    let oblong = (width.abs() - height.abs()).abs() > width.abs().max(height.abs()) * 1e-4;
    oblong.then(|| format!("its cells are {across} x {down}, and each is taken as a square texel"))
}

/// What there is to say, in one.
pub(super) fn noted(notes: impl IntoIterator<Item = Option<String>>) -> Option<String> {
    let said: Vec<String> = notes.into_iter().flatten().collect();
    (!said.is_empty()).then(|| said.join("; "))
}

/// So many equal values, or a sentence where that is more memory than there is.
pub(crate) fn filled<T: Copy>(value: T, count: usize) -> Result<Vec<T>> {
    let mut list = Vec::new();
    list.try_reserve_exact(count).map_err(|_| {
        let bytes = count as u128 * std::mem::size_of::<T>() as u128;
        Error::input(format!("its size asks for {bytes} bytes of memory at once, which are not to be had"))
    })?;
    list.resize(count, value);
    Ok(list)
}
