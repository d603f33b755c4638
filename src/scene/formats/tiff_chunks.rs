//! The strips and tiles of a TIFF, a row of them at a time.
//!
//! Unpacked here: the crate `tiff` knows neither whole numbers of other than 8, 16, 32 and 64 bits nor palettes, and its checks of sizes
//! come after what they should prevent. The compressions themselves are other crates'; those with loss and fax stay with `tiff`.
use super::opened::{Rows, broken, filled};
use super::pick::Pick;
use super::tiff_packed::{Turned, lzw, pack_bits, unpacked_here, word};
use crate::source::Handle;
use reliefrtl_base::error::{Error, Result};
use std::io::{Read, SeekFrom};
use tiff::decoder::{Decoder, DecodingResult};
use tiff::tags::{CompressionMethod, Tag};

pub(super) const KIND: &str = "TIFF";

/// A chunk may be larger than the picture by this many bytes.
const SMALL: u64 = 1 << 20;

fn failed(error: tiff::TiffError) -> Error {
    broken(KIND, error)
}

/// What the bits of a sample are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    /// A whole number.
    Unsigned,
    /// A whole number in two's complement.
    Signed,
    /// A binary float.
    Float,
}

/// What the samples of a pixel mean.
pub(super) enum Meaning {
    /// As they stand.
    Plain,
    /// 0 is white.
    Inverted,
    /// Numbers of colours.
    Palette(Vec<[f64; 3]>),
}

/// How the picture is cut.
pub(super) struct Grid {
    /// Columns of the picture.
    width: usize,
    /// Rows of the picture.
    height: usize,
    /// Columns of a chunk.
    columns: usize,
    /// Rows of a chunk.
    rows: usize,
    /// Whether chunks at the border are filled up.
    tiles: bool,
    /// Samples of a pixel.
    per_pixel: usize,
    /// Whether each sample has chunks of its own.
    planar: bool,
    /// Bits of a sample.
    bits: u32,
    /// Difference to the sample before (2), or to the byte before with bytes sorted (3).
    predictor: u32,
    offsets: Vec<u64>,
    counts: Vec<u64>,
}

impl Grid {
    /// What the tags say, none of it out of proportion to the picture.
    pub(super) fn new<'a>(
        tags: &mut Decoder<Handle<'a>>,
        (width, height): (usize, usize),
        per_pixel: usize,
        bits: u32,
    ) -> Result<Self> {
        let number = |tags: &mut Decoder<Handle<'a>>, tag: Tag| tags.find_tag_unsigned::<u32>(tag).map_err(failed);
        let list = |tags: &mut Decoder<Handle<'a>>, tag: Tag| {
            Ok::<_, Error>(tags.find_tag_unsigned_vec::<u64>(tag).map_err(failed)?.unwrap_or_default())
        };
        let tiles = number(tags, Tag::TileWidth)?.is_some();
        let (columns, rows, offsets, counts) = if tiles {
            let columns = number(tags, Tag::TileWidth)?.unwrap_or(0) as usize;
            let rows = number(tags, Tag::TileLength)?.unwrap_or(0) as usize;
            (columns, rows, list(tags, Tag::TileOffsets)?, list(tags, Tag::TileByteCounts)?)
        } else {
            let rows = number(tags, Tag::RowsPerStrip)?.map_or(height, |rows| rows as usize).min(height);
            (width, rows, list(tags, Tag::StripOffsets)?, list(tags, Tag::StripByteCounts)?)
        };
        let planes = number(tags, Tag::PlanarConfiguration)?.unwrap_or(1);
        if !(1..=2).contains(&planes) {
            return Err(broken(KIND, format!("its planar configuration is {planes}, and 1 or 2 are legal")));
        }
        let planar = planes == 2 && per_pixel > 1;
        let predictor = number(tags, Tag::Predictor)?.unwrap_or(1);
        let grid = Self { width, height, columns, rows, tiles, per_pixel, planar, bits, predictor, offsets, counts };
        if columns == 0 || rows == 0 {
            return Err(broken(KIND, format!("its chunks are {columns} x {rows}")));
        }
        let bytes = (grid.row_bytes() as u128) * rows as u128;
        if bytes > (width * height) as u128 * 24 + u128::from(SMALL) {
            return Err(broken(
                KIND,
                format!("its chunks of {bytes} bytes are out of proportion to {width} x {height} pixels"),
            ));
        }
        let needed = grid.across() * height.div_ceil(rows) * if planar { per_pixel } else { 1 };
        if grid.offsets.len() < needed || grid.counts.len() < needed {
            return Err(broken(KIND, format!("it has {} chunks instead of {needed}", grid.offsets.len())));
        }
        Ok(grid)
    }

    /// Samples of a pixel in one chunk.
    const fn together(&self) -> usize {
        if self.planar { 1 } else { self.per_pixel }
    }

    /// Bytes of a row of a chunk.
    const fn row_bytes(&self) -> usize {
        (self.columns * self.together() * self.bits as usize).div_ceil(8)
    }

    const fn across(&self) -> usize {
        self.width.div_ceil(self.columns)
    }

    /// Rows that are stored in the chunks at row `band` of chunks.
    fn stored_rows(&self, band: usize) -> usize {
        if self.tiles { self.rows } else { self.rows.min(self.height - band * self.rows) }
    }
}

/// Reads rows out of chunks.
pub(super) struct Chunks<'a> {
    tags: Decoder<Handle<'a>>,
    grid: Grid,
    number: Number,
    meaning: Meaning,
    pick: Pick,
    compression: CompressionMethod,
    /// Whether the first bit of each stored byte is its lowest (FillOrder 2), as libtiff reads it: of what is packed, too.
    reversed: bool,
    /// Bytes of the file.
    len: u64,
    /// The chunks of the present row of them, unpacked, plane after plane; empty where they are not looked at.
    band: Vec<Vec<u8>>,
    at: usize,
    /// The samples of a row, as they are stored.
    words: Vec<u64>,
    /// One more row, of a chunk.
    part: Vec<u64>,
}

impl<'a> Chunks<'a> {
    pub(super) fn new(
        tags: Decoder<Handle<'a>>,
        grid: Grid,
        (number, meaning): (Number, Meaning),
        pick: Pick,
        (compression, reversed): (CompressionMethod, bool),
        len: u64,
    ) -> Result<Self> {
        if reversed && !unpacked_here(compression) {
            return Err(broken(
                KIND,
                format!("its bits are stored in reverse (FillOrder 2), which is not read of {compression:?}"),
            ));
        }
        let difference =
            grid.predictor == 2 && number != Number::Float || grid.predictor == 3 && number == Number::Float;
        if grid.predictor != 1 && !difference {
            return Err(broken(
                KIND,
                format!("its predictor is {}, which is not read for its samples", grid.predictor),
            ));
        }
        let words = filled(0, grid.width * grid.per_pixel)?;
        Ok(Self {
            tags,
            grid,
            number,
            meaning,
            pick,
            compression,
            reversed,
            len,
            band: Vec::new(),
            at: 0,
            words,
            part: Vec::new(),
        })
    }

    /// Unpacks the chunks of the next rows.
    fn load(&mut self) -> Result<()> {
        let (across, planes) = (self.grid.across(), if self.grid.planar { self.grid.per_pixel } else { 1 });
        let band = self.at / self.grid.rows;
        let plane = across * self.grid.height.div_ceil(self.grid.rows);
        let size = self.grid.row_bytes() * self.grid.stored_rows(band);
        self.band.clear();
        for which in 0..planes {
            for x in 0..across {
                let needed = !self.grid.planar || self.pick.needs(which);
                let chunk = which * plane + band * across + x;
                let bytes = if needed { self.unpack(chunk, size)? } else { Vec::new() };
                self.band.push(bytes);
            }
        }
        Ok(())
    }

    fn unpack(&mut self, chunk: usize, size: usize) -> Result<Vec<u8>> {
        let (offset, count) = (self.grid.offsets[chunk], self.grid.counts[chunk]);
        let ended = |error: std::io::Error| broken(KIND, format!("chunk {chunk}: {error}"));
        if count > self.len {
            return Err(broken(
                KIND,
                format!("chunk {chunk} is announced with {count} bytes in a file of {}", self.len),
            ));
        }
        if offset == 0 && count == 0 {
            return Err(broken(KIND, format!("chunk {chunk} is not stored")));
        }
        let mut out = filled(0, size)?;
        if !unpacked_here(self.compression) {
            self.by_crate(chunk, &mut out)?;
            return Ok(out);
        }
        let file = self.tags.inner();
        file.seek(SeekFrom::Start(offset)).map_err(ended)?;
        let packed = Turned { from: file.take(count), reversed: self.reversed };
        match self.compression {
            CompressionMethod::None => { packed }.read_exact(&mut out).map_err(ended)?,
            CompressionMethod::Deflate | CompressionMethod::OldDeflate => {
                flate2::read::ZlibDecoder::new(packed).read_exact(&mut out).map_err(ended)?;
            }
            CompressionMethod::ZSTD => {
                zstd::Decoder::new(packed).map_err(ended)?.read_exact(&mut out).map_err(ended)?;
            }
            CompressionMethod::LZW => {
                let mut decoder = weezl::decode::Decoder::with_tiff_size_switch(weezl::BitOrder::Msb, 8);
                let mut bytes = Vec::new();
                { packed }.read_to_end(&mut bytes).map_err(ended)?;
                lzw(&mut decoder, &bytes, &mut out).map_err(|error| broken(KIND, format!("chunk {chunk}: {error}")))?;
            }
            CompressionMethod::PackBits => {
                let mut bytes = Vec::new();
                { packed }.read_to_end(&mut bytes).map_err(ended)?;
                pack_bits(&bytes, &mut out).map_err(|error| broken(KIND, format!("chunk {chunk}: {error}")))?;
            }
            _ => unreachable!("the others are the crate's"),
        }
        Ok(out)
    }

    /// What only the crate unpacks: fax, and JPEG where it is asked for.
    fn by_crate(&mut self, chunk: usize, out: &mut [u8]) -> Result<()> {
        let bytes = match self.tags.read_chunk(chunk as u32).map_err(failed)? {
            DecodingResult::U8(bytes) if self.grid.bits <= 8 => bytes,
            _ => return Err(broken(KIND, format!("{:?} of {} bits is not read", self.compression, self.grid.bits))),
        };
        // A tile at the border comes without what it is filled up with.
        let (across, row) = (self.grid.across(), self.grid.row_bytes());
        let x = chunk % across * self.grid.columns;
        let there =
            (self.grid.columns.min(self.grid.width - x) * self.grid.together() * self.grid.bits as usize).div_ceil(8);
        for (to, from) in out.chunks_mut(row).zip(bytes.chunks_exact(there)) {
            to[..there].copy_from_slice(from);
        }
        // `tiff` turns white and black round itself.
        if matches!(self.meaning, Meaning::Inverted) {
            out.iter_mut().for_each(|byte| *byte = !*byte);
        }
        Ok(())
    }

    /// The samples of row `y` of one chunk, differences added up.
    fn row_of(&mut self, chunk: usize, y: usize) {
        let (bytes, bits, together) = (self.grid.row_bytes(), self.grid.bits, self.grid.together());
        let row = &mut self.band[chunk][y * bytes..(y + 1) * bytes];
        let count = self.grid.columns * together;
        self.part.clear();
        if self.grid.predictor == 3 {
            for at in together..row.len() {
                row[at] = row[at].wrapping_add(row[at - together]);
            }
            // The most significant bytes of all samples come first.
            let width = bits as usize / 8;
            let word = |at: usize| (0..width).fold(0, |word, byte| word << 8 | u64::from(row[byte * count + at]));
            self.part.extend((0..count).map(word));
            return;
        }
        let little = self.tags.byte_order() == tiff::tags::ByteOrder::LittleEndian;
        self.part.extend((0..count).map(|at| word(row, at, bits, little)));
        if self.grid.predictor == 2 {
            let mask = u64::MAX >> (64 - bits);
            for at in together..count {
                self.part[at] = self.part[at].wrapping_add(self.part[at - together]) & mask;
            }
        }
    }

    /// The number that a sample is.
    fn value(&self, word: u64) -> f64 {
        match (self.number, self.grid.bits) {
            (Number::Unsigned, _) => word as f64,
            (Number::Signed, bits) => ((word << (64 - bits)) as i64 >> (64 - bits)) as f64,
            (Number::Float, 16) => super::packed::half(word as u16),
            (Number::Float, 32) => f64::from(f32::from_bits(word as u32)),
            (Number::Float, _) => f64::from_bits(word),
        }
    }
}

impl Rows for Chunks<'_> {
    fn next(&mut self, row: &mut [f64]) -> Result<()> {
        let (y, per_pixel) = (self.at % self.grid.rows, self.grid.per_pixel);
        if y == 0 {
            self.load()?;
        }
        let (across, together) = (self.grid.across(), self.grid.together());
        for chunk in 0..self.band.len() {
            if self.band[chunk].is_empty() {
                continue;
            }
            self.row_of(chunk, y);
            let (plane, from) = (chunk / across, chunk % across * self.grid.columns);
            let columns = self.grid.columns.min(self.grid.width - from);
            for x in 0..columns {
                for c in 0..together {
                    self.words[(from + x) * per_pixel + plane + c] = self.part[x * together + c];
                }
            }
        }
        let mut pixel = vec![0.0; per_pixel.max(3)];
        for (x, height) in row.iter_mut().enumerate() {
            let words = &self.words[x * per_pixel..(x + 1) * per_pixel];
            match &self.meaning {
                Meaning::Palette(palette) => pixel[..3].copy_from_slice(&palette[words[0] as usize]),
                meaning => {
                    for (sample, word) in pixel.iter_mut().zip(words) {
                        *sample = self.value(*word);
                    }
                    if matches!(meaning, Meaning::Inverted) {
                        let white =
                            if self.number == Number::Float { 1.0 } else { (u64::MAX >> (64 - self.grid.bits)) as f64 };
                        pixel[0] = white - pixel[0];
                    }
                }
            }
            *height = self.pick.take(&pixel, x, self.at)?;
        }
        self.at += 1;
        Ok(())
    }
}
