//! OpenEXR by part and channel, block after block. What lies in the display window but not in the data window has no data.
use super::opened::{Info, Opened, Rows, Samples, broken, filled, noted, oblong, sized};
use super::pick::Pick;
use crate::source::Handle;
use exr::block::UncompressedBlock;
use exr::block::chunk::{Chunk, CompressedBlock};
use exr::block::reader::{AllChunksReader, ChunksReader};
use exr::meta::BlockDescription;
use exr::meta::attribute::SampleType;
use exr::meta::header::Header;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::MapConfig;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

const KIND: &str = "OpenEXR";
/// A block may be larger than the picture by this many bytes.
const SMALL: u64 = 1 << 20;

pub(super) fn open<'a>(handle: Handle<'a>, len: u64, map: &MapConfig) -> Result<Opened<'a>> {
    let failed = |error: exr::error::Error| broken(KIND, error);
    let reader = exr::block::read(handle, false).map_err(failed)?;
    let (part, label) = part(reader.headers(), map)?;
    let header = &reader.headers()[part];
    let shown = header.shared_attributes.display_window;
    let (width, height) = sized(shown.size.width() as u64, shown.size.height() as u64, map)?;
    let stored = header.layer_size;
    let (columns, rows) = sized(stored.width() as u64, stored.height() as u64, map)?;
    bounded(header, (columns * rows) as u64, len)?;
    let channels = &header.channels.list;
    if channels.iter().any(|channel| channel.sampling != exr::math::Vec2(1, 1)) {
        return Err(broken(KIND, "its channels are subsampled"));
    }
    let names: Vec<String> = channels.iter().map(|channel| channel.name.to_string()).collect();
    let pick = Pick::new(&names.iter().map(String::as_str).collect::<Vec<_>>(), 1.0, map)?;
    let kinds: Vec<SampleType> = channels.iter().map(|channel| channel.sample_type).collect();
    let half = (0..kinds.len()).filter(|&at| pick.needs(at)).all(|at| kinds[at] == SampleType::F16);
    // Both windows are places in one plane.
    let place = header.own_attributes.layer_position;
    let left = i64::from(place.x()) - i64::from(shown.position.x());
    let top = i64::from(place.y()) - i64::from(shown.position.y());
    let same = (left, top, columns, rows) == (0, 0, width, height);
    let note = (!same).then(|| {
        format!("the file has a data window of {columns} x {rows} at ({left}, {top}) of a display window of {width} x {height}")
    });
    let aspect = f64::from(header.shared_attributes.pixel_aspect);
    let info = Info {
        channel: pick.label(),
        part: label,
        note: noted([note, oblong(aspect, 1.0)]),
        ..Info::new(KIND, width, height, Samples::Float(if half { 16 } else { 32 }))
    };
    let band = match header.blocks {
        BlockDescription::ScanLines => header.compression.scan_lines_per_block(),
        BlockDescription::Tiles(tiles) => tiles.tile_size.height(),
    };
    let window = Window { left, top, width, height, columns, rows, band: band.min(rows) };
    let chunks = reader.all_chunks(false).map_err(failed)?;
    let rows = Bands { chunks, part, window, kinds, pick, kept: BTreeMap::new(), at: 0 };
    Ok(Opened { info, rows: Box::new(rows) })
}

/// The part that is asked for, and its name where there are several.
fn part(headers: &[Header], map: &MapConfig) -> Result<(usize, Option<String>)> {
    let name = |at: usize| headers[at].own_attributes.layer_name.as_ref().map(ToString::to_string);
    let listed = || {
        let one = |at: usize| format!("{at} ({})", name(at).unwrap_or_else(|| "without a name".into()));
        (0..headers.len()).take(20).map(one).collect::<Vec<_>>().join(", ")
    };
    let label = |at: usize| (at, Some(format!("{at} ({})", name(at).unwrap_or_default())));
    match &map.part {
        Some(asked) => (0..headers.len())
            .find(|&at| name(at).as_ref() == Some(asked))
            .or_else(|| asked.parse().ok().filter(|&at: &usize| at < headers.len()))
            .map(label)
            .ok_or_else(|| Error::input(format!("there is no part {asked:?} (map.part): the file has {}", listed()))),
        None if headers.len() == 1 => Ok((0, None)),
        None => Err(Error::input(format!(
            "the file has the parts {}, and which one is the map is not ours to guess: choose it with --set map.part=0",
            listed()
        ))),
    }
}

/// What the header makes the reader allocate must be no more than its picture and the file deserve.
fn bounded(header: &Header, texels: u64, len: u64) -> Result<()> {
    let (size, block) = match header.blocks {
        BlockDescription::ScanLines => {
            let lines = header.compression.scan_lines_per_block().min(header.layer_size.height());
            (header.layer_size.width() as u64 * lines as u64, lines)
        }
        BlockDescription::Tiles(tiles) => {
            let side = |tile: usize, whole: usize| tile.min(whole) as u64;
            let (across, down) = (tiles.tile_size.width(), tiles.tile_size.height());
            let (width, height) = (header.layer_size.width(), header.layer_size.height());
            (side(across, width) * side(down, height), down)
        }
    };
    let bytes = size.saturating_mul(header.channels.bytes_per_pixel as u64);
    if block == 0 || bytes > texels.saturating_mul(24).saturating_add(SMALL) {
        return Err(broken(KIND, format!("its blocks of {bytes} bytes are out of proportion to its {texels} texels")));
    }
    if (header.chunk_count as u64).saturating_mul(8) > len {
        return Err(broken(KIND, format!("{} blocks are announced in {len} bytes", header.chunk_count)));
    }
    Ok(())
}

/// Where the data window lies in the display window, and how its rows stand together in blocks.
struct Window {
    left: i64,
    top: i64,
    /// Of the display window.
    width: usize,
    height: usize,
    /// Of the data window.
    columns: usize,
    rows: usize,
    /// Rows of a block.
    band: usize,
}

impl Window {
    /// The row of the data window that a row of the display window shows.
    fn data_row(&self, row: usize) -> Option<usize> {
        inside(row as i64 - self.top, self.rows)
    }

    /// Whether a row of this band is in the display window.
    fn shows(&self, band: usize) -> bool {
        let first = self.top + (band * self.band) as i64;
        first < self.height as i64 && first + self.band_rows(band) as i64 > 0
    }

    fn band_rows(&self, band: usize) -> usize {
        self.band.min(self.rows - band * self.band)
    }
}

fn inside(place: i64, side: usize) -> Option<usize> {
    usize::try_from(place).ok().filter(|&place| place < side)
}

/// The heights of a row of blocks, as wide as the display window, as far as they have been read.
struct Band {
    samples: Vec<f64>,
    /// Pixels of the data window that are there.
    seen: usize,
}

/// Blocks as the file has them, one row of blocks after the other: a file in the usual order has one of them in memory, any other
/// those that wait for their turn, and of all channels only the height.
struct Bands<'a> {
    chunks: AllChunksReader<Handle<'a>>,
    part: usize,
    window: Window,
    kinds: Vec<SampleType>,
    pick: Pick,
    kept: BTreeMap<usize, Band>,
    /// The row that is next.
    at: usize,
}

impl Bands<'_> {
    /// Reads blocks until this band is whole.
    fn complete(&mut self, band: usize) -> Result<()> {
        let whole = self.window.columns * self.window.band_rows(band);
        while self.kept.get(&band).is_none_or(|kept| kept.seen < whole) {
            let Some(chunk) = self.chunks.next() else {
                let row = band * self.window.band;
                return Err(broken(KIND, format!("the block of its row {row} is not there")));
            };
            self.take(chunk.map_err(|error| broken(KIND, error))?)?;
        }
        Ok(())
    }

    /// Keeps the heights of a block of the part, at its finest level.
    fn take(&mut self, chunk: Chunk) -> Result<()> {
        let finest = match &chunk.compressed_block {
            CompressedBlock::Tile(tile) => tile.coordinates.is_largest_resolution_level(),
            _ => true,
        };
        if chunk.layer_index != self.part || !finest {
            return Ok(());
        }
        let failed = |error: exr::error::Error| broken(KIND, error);
        let block = UncompressedBlock::decompress_chunk(chunk, self.chunks.meta_data(), false).map_err(failed)?;
        let window = &self.window;
        let band = block.index.pixel_position.y() / window.band;
        // Of what is not shown and of what was taken already nothing is kept.
        if !window.shows(band) || window.data_row(self.at).is_some_and(|row| band < row / window.band) {
            return Ok(());
        }
        let kept = match self.kept.entry(band) {
            Entry::Occupied(there) => there.into_mut(),
            Entry::Vacant(place) => {
                let samples = filled(f64::NAN, window.width * window.band_rows(band))?;
                place.insert(Band { samples, seen: 0 })
            }
        };
        kept.seen += block.index.pixel_size.area();
        self.window.copy(&block, &self.kinds, &self.pick, &mut kept.samples)
    }
}

impl Rows for Bands<'_> {
    fn next(&mut self, row: &mut [f64]) -> Result<()> {
        match self.window.data_row(self.at) {
            None => row.fill(f64::NAN),
            Some(from) => {
                let band = from / self.window.band;
                self.complete(band)?;
                self.kept.retain(|&there, _| there >= band);
                let start = (from - band * self.window.band) * row.len();
                row.copy_from_slice(&self.kept[&band].samples[start..start + row.len()]);
            }
        }
        self.at += 1;
        Ok(())
    }
}

impl Window {
    /// Copies the heights of a block to their places in its band.
    fn copy(&self, block: &UncompressedBlock, kinds: &[SampleType], pick: &Pick, to: &mut [f64]) -> Result<()> {
        let (size, from) = (block.index.pixel_size, block.index.pixel_position);
        let bytes = |kind: &SampleType| if *kind == SampleType::F16 { 2 } else { 4 };
        let line: usize = kinds.iter().map(|kind| bytes(kind) * size.width()).sum();
        let mut pixel = vec![0.0; kinds.len()];
        for y in 0..size.height() {
            let Some(row) = inside(self.top + (from.y() + y) as i64, self.height) else { continue };
            let Some(line) = block.data.get(y * line..(y + 1) * line) else {
                return Err(broken(KIND, "a block ends early"));
            };
            let place = (from.y() + y) % self.band * self.width;
            for x in 0..size.width() {
                let Some(column) = inside(self.left + (from.x() + x) as i64, self.width) else { continue };
                let mut start = 0;
                for (c, kind) in kinds.iter().enumerate() {
                    if pick.needs(c) {
                        pixel[c] = sample(&line[start..], x, *kind);
                    }
                    start += bytes(kind) * size.width();
                }
                to[place + column] = pick.take(&pixel, column, row)?;
            }
        }
        Ok(())
    }
}

/// Sample `at` of a line, in the machine's order of bytes.
fn sample(line: &[u8], at: usize, kind: SampleType) -> f64 {
    let four = |at: usize| [line[4 * at], line[4 * at + 1], line[4 * at + 2], line[4 * at + 3]];
    match kind {
        SampleType::F16 => super::packed::half(u16::from_ne_bytes([line[2 * at], line[2 * at + 1]])),
        SampleType::F32 => f64::from(f32::from_ne_bytes(four(at))),
        SampleType::U32 => f64::from(u32::from_ne_bytes(four(at))),
    }
}
