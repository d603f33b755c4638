//! Height maps from files: from the file's numbers to heights in 0 to 1, row by row.
use super::codes::{Fit, Sink, Ways};
use super::formats::{self, Samples};
use super::height_map::{Depth, HeightMap};
use super::source::Source;
use super::taken::Taken;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::check::plain;
use reliefrtl_config::{MapConfig, MapRange};
use std::path::Path;

/// Reads a map with the default choices; see [`load_codes`].
///
/// # Errors
/// As [`load_codes`].
pub fn load(path: impl AsRef<Path>) -> Result<HeightMap> {
    let source = Source::file(path.as_ref())?;
    named(&source, heights(&source, &MapConfig::default())).map(|x| x.0)
}

/// As [`load`], from bytes; `name` stands for the file in the sentences.
///
/// # Errors
/// As [`load`].
pub fn decode(bytes: &[u8], name: &str) -> Result<HeightMap> {
    decode_as(bytes, name, &MapConfig::default()).map(|x| x.0)
}

/// As [`decode`], with the choices of a configuration (range, no data, channel, part, size); and what was taken.
///
/// # Errors
/// As [`load`].
pub fn decode_as(bytes: &[u8], name: &str, map: &MapConfig) -> Result<(HeightMap, Taken)> {
    let source = Source::bytes(bytes, name);
    named(&source, heights(&source, map))
}

/// Reads a map as codes of `height_bits` bits for 2^levels x 2^levels texels, row by row (`docs/maps.md`); what the file is, its
/// content decides, and its name only where content can't. `resample` is asked for besides `map.resample`.
///
/// Whole numbers of n bits are divided by 2^n - 1 (a PGM's by its own maximum), floats count as they are, and with `map.range` both
/// are placed in that range. A pixel of red = green = blue has exactly that height.
///
/// # Errors
/// [`Error::File`] if it can't be read; [`Error::Input`] if it is of no known kind, broken, empty, of more than `map.max_texels`,
/// coloured, not opaque, has heights out of the range or texels without data, is ambiguous, or does not fit.
pub fn load_codes(
    path: &Path,
    map: &MapConfig,
    levels: u32,
    height_bits: u32,
    resample: bool,
) -> Result<(Vec<u32>, Taken)> {
    codes(&Source::file(path)?, map, levels, height_bits, resample)
}

/// As [`load_codes`], from bytes; `name` stands for the file.
///
/// # Errors
/// As [`load_codes`].
pub fn decode_codes(
    bytes: &[u8],
    name: &str,
    map: &MapConfig,
    levels: u32,
    height_bits: u32,
    resample: bool,
) -> Result<(Vec<u32>, Taken)> {
    codes(&Source::bytes(bytes, name), map, levels, height_bits, resample)
}

fn codes(source: &Source, map: &MapConfig, levels: u32, height_bits: u32, resample: bool) -> Result<(Vec<u32>, Taken)> {
    let own = levels - map.border.levels();
    let ways = Ways { resample: resample || map.resample, crop: map.crop, pad: map.pad };
    let kept = |size: (usize, usize)| ways.kept(size, 1 << own);
    let fit = |size: (usize, usize), depth: Depth| Fit::new(size, depth, map.border, own, height_bits, ways);
    let (fit, mut taken) = named(source, read(source, map, kept, fit))?;
    taken.fit = fit.told();
    Ok((super::border::prepared(map.border, own, fit.codes()), taken))
}

fn heights(source: &Source, map: &MapConfig) -> Result<(HeightMap, Taken)> {
    let start = |size: (usize, usize), depth: Depth| Ok(Heights { size, depth, samples: Vec::new() });
    let (heights, taken) = read(source, map, |size| size, start)?;
    let Heights { size: (width, height), depth, samples } = heights;
    Ok((HeightMap::new(width, height, samples, depth)?, taken))
}

/// Names the file in what is wrong with it.
fn named<T>(source: &Source, result: Result<T>) -> Result<T> {
    result.map_err(|error| match error {
        Error::Input(text) => Error::Input(format!("{}: {text}", source.name())),
        other => other,
    })
}

struct Heights {
    size: (usize, usize),
    depth: Depth,
    samples: Vec<f64>,
}

impl Sink for Heights {
    fn row(&mut self, heights: &[f64]) {
        self.samples.extend_from_slice(heights);
    }
}

/// What a file holds in the part of it that is kept.
#[derive(Default)]
struct Seen {
    /// Lowest and highest finite height.
    ends: Option<(f64, f64)>,
    /// Texels without data, and the first of them.
    missing: (u64, Option<(usize, usize)>),
    /// Heights out of the range that was asked about, or infinite.
    outside: u64,
    /// The first infinite height that does not stand for no data, and how many there are.
    infinite: Option<((usize, usize), f64, u64)>,
    texels: u64,
}

impl Seen {
    fn height(&mut self, value: f64) {
        let (low, high) = self.ends.unwrap_or((value, value));
        self.ends = Some((low.min(value), high.max(value)));
    }

    fn missing(&mut self, place: (usize, usize)) {
        self.missing = (self.missing.0 + 1, self.missing.1.or(Some(place)));
    }
}

/// What marks a texel without data.
#[derive(Clone, Copy)]
struct NoData {
    samples: Samples,
    value: Option<f64>,
}

impl NoData {
    fn is(self, sample: f64) -> bool {
        let marks = |value: f64| match value.is_infinite() {
            true => sample.is_infinite(),
            false => self.samples.same(sample, value),
        };
        sample.is_nan() || self.value.is_some_and(marks)
    }
}

/// Reads all that is kept, for sentences that tell about the whole, and for the range `auto`.
fn scan(
    source: &Source,
    map: &MapConfig,
    kept: impl Fn((usize, usize)) -> (usize, usize),
    range: Option<(f64, f64)>,
) -> Result<Seen> {
    let mut opened = formats::open(source, map)?;
    let nodata = NoData { samples: opened.info.samples, value: map.nodata.or(opened.info.nodata) };
    let (columns, rows) = kept((opened.info.width, opened.info.height));
    let mut row = formats::filled(0.0, opened.info.width)?;
    let mut seen = Seen { texels: columns as u64 * rows as u64, ..Seen::default() };
    for y in 0..rows {
        opened.rows.next(&mut row)?;
        for (x, &sample) in row[..columns].iter().enumerate() {
            if nodata.is(sample) {
                seen.missing((x, y));
            } else {
                let out = range.is_some_and(|(low, high)| !(low..=high).contains(&sample)) || sample.is_infinite();
                seen.outside += u64::from(out);
                if sample.is_finite() {
                    seen.height(sample);
                } else {
                    let (first, value, count) = seen.infinite.unwrap_or(((x, y), sample, 0));
                    seen.infinite = Some((first, value, count + 1));
                }
            }
        }
    }
    Ok(seen)
}

/// The range that is mapped to 0 and full height, and how finely the file tells heights apart in it.
fn range_of(
    source: &Source,
    map: &MapConfig,
    samples: Samples,
    kept: impl Fn((usize, usize)) -> (usize, usize),
) -> Result<((f64, f64), Depth)> {
    let whole = |low: f64, high: f64| {
        // Levels that whole numbers tell apart in it.
        let steps = (high - low).ceil().clamp(1.0, f64::from(u32::MAX)) as u32;
        if matches!(samples, Samples::Float(_)) { Depth::Ranged } else { Depth::Bits(steps.ilog2() + 1) }
    };
    match (map.range, samples) {
        (None, Samples::Unsigned(max)) => Ok(((0.0, max as f64), Depth::Bits(max.ilog2() + 1))),
        (None, Samples::Float(_)) => Ok(((0.0, 1.0), Depth::Float)),
        (None, Samples::Signed(_)) => {
            let ends = scan(source, map, kept, None)?.ends.unwrap_or((0.0, 1.0));
            Err(Error::input(format!(
                "its heights are {samples} numbers from {} to {}, and which become 0 and full height is not ours to guess: say it with {}",
                plain(ends.0),
                plain(ends.1),
                guess(ends)
            )))
        }
        (Some(MapRange::Limits([low, high])), _) => Ok(((low, high), whole(low, high))),
        (Some(MapRange::Auto(_)), _) => {
            let seen = scan(source, map, kept, None)?;
            if let Some(error) = infinite(&seen) {
                return Err(error);
            }
            let (low, high) = seen.ends.ok_or_else(|| Error::input("no texel has data"))?;
            Ok(((low, high), whole(low, high)))
        }
    }
}

/// Reads a file into a sink, which is made for the columns and rows that `kept` keeps of it.
fn read<S: Sink>(
    source: &Source,
    map: &MapConfig,
    kept: impl Fn((usize, usize)) -> (usize, usize) + Copy,
    start: impl FnOnce((usize, usize), Depth) -> Result<S>,
) -> Result<(S, Taken)> {
    let first = formats::open(source, map)?;
    let samples = first.info.samples;
    // Only one reader of a file at a time, where a scan comes between.
    let scans = matches!((map.range, samples), (Some(MapRange::Auto(_)), _) | (None, Samples::Signed(_)));
    let first = (!scans).then_some(first);
    let ((low, high), depth) = range_of(source, map, samples, kept)?;
    if let Some(fill) = map.fill.filter(|fill| !(low..=high).contains(fill)) {
        return Err(Error::input(format!(
            "map.fill = {} is no height from {} to {}: give one, in the file's units, or another map.range",
            plain(fill),
            plain(low),
            plain(high)
        )));
    }
    let mut opened = first.map_or_else(|| formats::open(source, map), Ok)?;
    let size = (opened.info.width, opened.info.height);
    let (columns, rows) = kept(size);
    let value = map.nodata.or(opened.info.nodata);
    let nodata = NoData { samples, value };
    let mut sink = start((columns, rows), depth)?;
    let mut row = formats::filled(0.0, size.0)?;
    let mut seen = Seen::default();
    // A map of one height is flat at the bottom.
    let span = if high > low { high - low } else { 1.0 };
    for y in 0..rows {
        opened.rows.next(&mut row)?;
        for (x, sample) in row[..columns].iter_mut().enumerate() {
            if nodata.is(*sample) {
                seen.missing((x, y));
                let Some(fill) = map.fill else {
                    let note = opened.info.note.take();
                    drop(opened);
                    return Err(missing(&scan(source, map, kept, None)?, value, note, low));
                };
                *sample = fill;
            } else if (low..=high).contains(sample) {
                seen.height(*sample);
            } else {
                let note = opened.info.note.take();
                drop(opened);
                let seen = scan(source, map, kept, Some((low, high)))?;
                return Err(outside((x, y), *sample, (low, high), map, &seen, note));
            }
            *sample = (*sample - low) / span;
        }
        sink.row(&row[..columns]);
    }
    let info = opened.info;
    let taken = Taken {
        file: source.name().to_owned(),
        format: info.format.to_owned(),
        width: size.0,
        height: size.1,
        samples: samples.to_string(),
        part: info.part,
        channel: info.channel,
        range: [low, high],
        lowest: seen.ends.map(|ends| ends.0),
        highest: seen.ends.map(|ends| ends.1),
        nodata: value,
        nodata_texels: seen.missing.0,
        fill: map.fill.filter(|_| seen.missing.0 > 0),
        kept: [columns, rows],
        fit: None,
        note: info.note,
    };
    Ok((sink, taken))
}

/// How the range is asked for that a file with these heights needs.
fn guess((low, high): (f64, f64)) -> String {
    let limits = if low < high { format!("--set map.range={},{} or ", plain(low), plain(high)) } else { String::new() };
    format!("{limits}--set map.range=auto")
}

fn missing(seen: &Seen, value: Option<f64>, note: Option<String>, low: f64) -> Error {
    let (count, first) = seen.missing;
    let (x, y) = first.unwrap_or_default();
    let mark = value.map_or_else(|| "not a number".to_owned(), |value| format!("{}, or not a number", plain(value)));
    let why = note.map(|note| format!("; {note}")).unwrap_or_default();
    let low = plain(seen.ends.map_or(low, |ends| ends.0));
    Error::input(format!(
        "{count} of {} texels have no data ({mark}), the first is pixel ({x}, {y}){why}: give the height that they take, in the file's units, as --set map.fill={low}",
        seen.texels
    ))
}

/// No range holds an infinite height.
fn infinite(seen: &Seen) -> Option<Error> {
    let ((x, y), value, count) = seen.infinite?;
    let fill = plain(seen.ends.map_or(0.0, |ends| ends.0));
    Some(Error::input(format!(
        "pixel ({x}, {y}) is {}, as {count} of {} heights are infinite: if that stands for no data, say so and give the height that they take, \
         in the file's units, as --set map.nodata=inf --set map.fill={fill}",
        plain(value),
        seen.texels
    )))
}

fn outside(
    (x, y): (usize, usize),
    sample: f64,
    (low, high): (f64, f64),
    map: &MapConfig,
    seen: &Seen,
    note: Option<String>,
) -> Error {
    if let Some(error) = infinite(seen) {
        return error;
    }
    let needed = match map.range {
        None => "heights must be in 0 to 1".to_owned(),
        Some(_) => format!("map.range = [{}, {}]", plain(low), plain(high)),
    };
    let ends = seen.ends.unwrap_or((0.0, 1.0));
    let note = note.map(|note| format!("{note}; ")).unwrap_or_default();
    Error::input(format!(
        "pixel ({x}, {y}) is {}: {needed}; {note}{} of {} texels lie outside, and the file's heights go from {} to {}: use {}",
        plain(sample),
        seen.outside,
        seen.texels,
        plain(ends.0),
        plain(ends.1),
        guess(ends)
    ))
}
