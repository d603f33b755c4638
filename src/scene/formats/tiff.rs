//! TIFF, BigTIFF and GeoTIFF: tags by the crate `tiff`, pages, palettes, and no-data values.
use super::opened::{Info, Opened, Samples, broken, noted, oblong, sized};
use super::orient::upright;
use super::pick::Pick;
use super::tiff_chunks::{Chunks, Grid, KIND, Meaning, Number};
use crate::source::Handle;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::MapConfig;
use reliefrtl_config::check::plain;
use std::borrow::Cow;
use std::io::{Read, Seek, SeekFrom};
use tiff::decoder::Decoder;
use tiff::tags::{CompressionMethod, PhotometricInterpretation as Photo, SampleFormat, Tag};

/// Tags that divide a picture into strips or tiles.
const SIDES: [(u64, &str); 3] = [(278, "RowsPerStrip"), (322, "TileWidth"), (323, "TileLength")];
const ZERO: [u8; 8] = [0; 8];
/// Pages that are looked at.
const PAGES: usize = 1000;

type Tags<'a> = Decoder<Handle<'a>>;

fn failed(error: tiff::TiffError) -> Error {
    broken(KIND, error)
}

pub(super) fn open<'a>(handle: Handle<'a>, len: u64, map: &MapConfig) -> Result<Opened<'a>> {
    let mut tags = Decoder::new(counted(handle, len)?).map_err(failed)?;
    let part = page(&mut tags, map)?;
    let number = |tags: &mut Tags<'a>, tag: Tag| tags.find_tag_unsigned::<u32>(tag).map_err(failed);
    let (width, height) = tags.dimensions().map_err(failed)?;
    let (width, height) = sized(width.into(), height.into(), map)?;
    let photo = number(&mut tags, Tag::PhotometricInterpretation)?.and_then(|code| Photo::from_u16(code as u16));
    let photo = photo.ok_or_else(|| broken(KIND, "it does not say what its pixels mean"))?;
    let per_pixel = number(&mut tags, Tag::SamplesPerPixel)?.unwrap_or(1) as usize;
    let bits = of_all(&mut tags, Tag::BitsPerSample, "bits")?.unwrap_or(1);
    let format = of_all(&mut tags, Tag::SampleFormat, "as their formats")?.unwrap_or(1);
    let format = SampleFormat::from_u16_exhaustive(format as u16);
    let numbers = match (format, bits) {
        (SampleFormat::Uint | SampleFormat::Void, 1..=32) => Number::Unsigned,
        (SampleFormat::Int, 2..=32) => Number::Signed,
        (SampleFormat::IEEEFP, 16 | 32 | 64) => Number::Float,
        (format, bits) => {
            let read = "whole numbers of at most 32 bits and floats of 16, 32 or 64 are read";
            return Err(broken(KIND, format!("its samples are {format:?} of {bits} bits: {read}")));
        }
    };
    let names = names(&mut tags, photo, per_pixel)?;
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let stored = match numbers {
        Number::Unsigned => Samples::bits(bits),
        Number::Signed => Samples::Signed(bits),
        Number::Float => Samples::Float(bits),
    };
    let (meaning, names, samples) = match photo {
        Photo::RGBPalette if numbers == Number::Unsigned && bits <= 16 && per_pixel == 1 => {
            let (palette, samples) = palette(&mut tags, bits)?;
            (Meaning::Palette(palette), vec!["R", "G", "B"], samples)
        }
        Photo::BlackIsZero | Photo::RGB => (Meaning::Plain, names, stored),
        Photo::WhiteIsZero if numbers != Number::Signed => (Meaning::Inverted, names, stored),
        other => {
            return Err(broken(
                KIND,
                format!("its pixels are {other:?} ({format:?}), and grey, RGB and grey palettes are read"),
            ));
        }
    };
    let pick = Pick::new(&names, samples.full(), &numbered(map, &names))?;
    let compression = number(&mut tags, Tag::Compression)?.unwrap_or(1) as u16;
    let compression = CompressionMethod::from_u16_exhaustive(compression);
    if matches!(compression, CompressionMethod::JPEG | CompressionMethod::ModernJPEG | CompressionMethod::WebP)
        && !map.lossy
    {
        return Err(Error::input(format!(
            "this TIFF is compressed with loss ({compression:?}): its heights are not those that were stored; use one without loss, or read it all the same with --set map.lossy=true"
        )));
    }
    let orientation = number(&mut tags, Tag::Orientation)?.unwrap_or(1);
    let nodata = nodata(&mut tags)?;
    let label = pick.label();
    let sample = names.iter().position(|name| *name == label).unwrap_or(0);
    let note = noted([scaled(&mut tags, sample), cells(&mut tags)]);
    let info = Info { channel: label, part, nodata, note, ..Info::new(KIND, width, height, samples) };
    let reversed = match number(&mut tags, Tag::FillOrder)?.unwrap_or(1) {
        1 => false,
        2 => true,
        other => return Err(broken(KIND, format!("its order of bits (FillOrder) is {other}, and 1 or 2 are legal"))),
    };
    let grid = Grid::new(&mut tags, (width, height), per_pixel, bits)?;
    let chunks = Chunks::new(tags, grid, (numbers, meaning), pick, (compression, reversed), len)?;
    upright(Opened { info, rows: Box::new(chunks) }, orientation)
}

/// The file from its start, after a look at its directories: no tag announces more values than the file has bytes for, which `tiff`
/// would allocate.
fn counted(mut handle: Handle<'_>, len: u64) -> Result<Handle<'_>> {
    let ended = |error: std::io::Error| broken(KIND, error);
    let mut head = [0; 4];
    handle.read_exact(&mut head).map_err(ended)?;
    let (little, big) = (head[0] == b'I', head.contains(&43));
    let number = |handle: &mut Handle<'_>, bytes: usize| -> Result<u64> {
        let mut word = [0; 8];
        handle.read_exact(&mut word[..bytes]).map_err(ended)?;
        let push = |word: u64, byte: &u8| word << 8 | u64::from(*byte);
        Ok(if little { word[..bytes].iter().rev().fold(0, push) } else { word[..bytes].iter().fold(0, push) })
    };
    let wide = if big { 8 } else { 4 };
    if big {
        number(&mut handle, 4)?;
    }
    let mut place = number(&mut handle, wide)?;
    for _ in 0..PAGES {
        if place == 0 || place >= len {
            break;
        }
        handle.seek(SeekFrom::Start(place)).map_err(ended)?;
        let entries = number(&mut handle, if big { 8 } else { 2 })?;
        if entries > len {
            return Err(broken(KIND, format!("a directory of {entries} entries is announced in {len} bytes")));
        }
        for _ in 0..entries {
            let (tag, kind) = (number(&mut handle, 2)?, number(&mut handle, 2)?);
            let count = number(&mut handle, wide)?;
            let mut word = [0; 8];
            handle.read_exact(&mut word[..wide]).map_err(ended)?;
            let size = match kind {
                3 | 8 => 2,
                4 | 9 | 11 | 13 => 4,
                5 | 10 | 12 | 16..=18 => 8,
                _ => 1,
            };
            if count.saturating_mul(size) > len {
                return Err(broken(KIND, format!("{count} values of tag {tag} are announced in {len} bytes")));
            }
            let named = SIDES
                .iter()
                .find(|(side, _)| *side == tag)
                .filter(|_| count == 1 && word[..size as usize] == ZERO[..size as usize]);
            if let Some((_, name)) = named {
                return Err(broken(KIND, format!("its {name} (tag {tag}) is 0, and at least 1 is legal")));
            }
        }
        place = number(&mut handle, wide)?;
    }
    handle.rewind().map_err(ended)?;
    Ok(handle)
}

/// The number that a tag gives for all samples of a pixel.
fn of_all(tags: &mut Tags<'_>, tag: Tag, what: &str) -> Result<Option<u32>> {
    let list = tags.find_tag_unsigned_vec::<u32>(tag).map_err(failed)?.unwrap_or_default();
    match list.iter().find(|number| **number != list[0]) {
        None => Ok(list.first().copied()),
        Some(other) => Err(broken(
            KIND,
            format!("the samples of a pixel have {} and {other} {what}: samples of one kind are read", list[0]),
        )),
    }
}

/// The choice of a channel, where it is by the number of the sample, by its name.
fn numbered<'a>(map: &'a MapConfig, names: &[&str]) -> Cow<'a, MapConfig> {
    let number = map.channel.as_ref().filter(|asked| !names.contains(&asked.as_str()));
    match number.and_then(|asked| names.get(asked.parse::<usize>().ok()?.checked_sub(1)?)) {
        Some(name) => Cow::Owned(MapConfig { channel: Some((*name).to_owned()), ..map.clone() }),
        None => Cow::Borrowed(map),
    }
}

/// Goes to the page that is asked for, or the only one that is no reduced copy and no mask.
fn page(tags: &mut Tags<'_>, map: &MapConfig) -> Result<Option<String>> {
    let mut pages = Vec::new();
    loop {
        let kind = tags.find_tag_unsigned::<u32>(Tag::NewSubfileType).map_err(failed)?.unwrap_or(0);
        pages.push((tags.dimensions().map_err(failed)?, kind & 5 == 0));
        if !tags.more_images() || pages.len() == PAGES {
            break;
        }
        tags.next_image().map_err(failed)?;
    }
    let listed = || {
        let one = |(at, ((width, height), _)): (usize, &((u32, u32), bool))| format!("{at} ({width} x {height})");
        pages.iter().enumerate().take(20).map(one).collect::<Vec<_>>().join(", ")
    };
    let mut whole = (0..pages.len()).filter(|&at| pages[at].1);
    let at = match (&map.part, whole.next(), whole.next()) {
        (Some(asked), ..) => {
            asked.parse().ok().filter(|&at: &usize| at < pages.len()).ok_or_else(|| {
                Error::input(format!("there is no page {asked:?} (map.part): the file has {}", listed()))
            })?
        }
        (None, Some(at), None) => at,
        (None, None, _) => 0,
        (None, Some(_), Some(_)) => {
            return Err(Error::input(format!(
                "the file has the pages {}, and which one is the map is not ours to guess: choose it with --set map.part=0",
                listed()
            )));
        }
    };
    tags.seek_to_image(at).map_err(failed)?;
    Ok((pages.len() > 1).then(|| at.to_string()))
}

/// The names of the samples of a pixel: what their meaning gives, `A` for opacity, else numbers from 1.
fn names(tags: &mut Tags<'_>, photo: Photo, per_pixel: usize) -> Result<Vec<String>> {
    let extra = tags.find_tag_unsigned_vec::<u32>(Tag::ExtraSamples).map_err(failed)?.unwrap_or_default();
    let own: &[&str] = if photo == Photo::RGB { &["R", "G", "B"] } else { &["Y"] };
    if per_pixel < own.len() || per_pixel > 64 {
        return Err(broken(KIND, format!("it has {per_pixel} samples a pixel")));
    }
    let opacity = extra.iter().position(|kind| matches!(kind, 1 | 2));
    let one = |at: usize| match own.get(at) {
        Some(name) => (*name).to_owned(),
        None if opacity == Some(at - own.len()) => "A".to_owned(),
        // Colours with a fourth sample that is not explained are taken for colours with opacity.
        None if extra.is_empty() && photo == Photo::RGB && at == 3 => "A".to_owned(),
        None => (at + 1).to_string(),
    };
    Ok((0..per_pixel).map(one).collect())
}

/// Red, green and blue of each number: of 8 bits, if none needs more, else of 16.
fn palette(tags: &mut Tags<'_>, bits: u32) -> Result<(Vec<[f64; 3]>, Samples)> {
    let list = tags.find_tag_unsigned_vec::<u16>(Tag::ColorMap).map_err(failed)?.unwrap_or_default();
    let colours = 1usize << bits;
    if list.len() != 3 * colours {
        return Err(broken(KIND, format!("its palette has {} numbers instead of {}", list.len(), 3 * colours)));
    }
    let wide = list.iter().any(|word| word % 257 != 0);
    let value = |at: usize| f64::from(if wide { list[at] } else { list[at] / 257 });
    let palette = (0..colours).map(|at| [value(at), value(colours + at), value(2 * colours + at)]).collect();
    Ok((palette, Samples::bits(if wide { 16 } else { 8 })))
}

/// What GDAL wrote down as the value of no data.
fn nodata(tags: &mut Tags<'_>) -> Result<Option<f64>> {
    if tags.find_tag(Tag::GdalNodata).map_err(failed)?.is_none() {
        return Ok(None);
    }
    let text = tags.get_tag_ascii_string(Tag::GdalNodata).map_err(failed)?;
    let text = text.trim_matches(|c: char| c == '\0' || c.is_whitespace());
    text.parse().map(Some).map_err(|_| {
        let shown: String = text.chars().take(20).collect();
        broken(KIND, format!("its no-data value {shown:?} (tag 42113) is not a number"))
    })
}

/// What is said of the scale and the offset that GDAL wrote down for this sample: the heights are taken as they are stored.
fn scaled(tags: &mut Tags<'_>, sample: usize) -> Option<String> {
    const GDAL_METADATA: Tag = Tag::Unknown(42112);
    let text = tags.get_tag_ascii_string(GDAL_METADATA).ok()?;
    let of = |role: &str, neutral: f64| {
        let value = text.split("<Item").skip(1).find_map(|item| {
            let (head, rest) = item.split_once('>')?;
            let attribute = |name: &str| Some(head.split_once(&format!(" {name}=\""))?.1.split('"').next()?.trim());
            let band = attribute("sample").map_or(Some(0), |band| band.parse().ok())?;
            let mine = attribute("role").is_some_and(|r| r.eq_ignore_ascii_case(role)) && band == sample;
            mine.then(|| rest.split('<').next()?.trim().parse::<f64>().ok())?
        });
        value.filter(|value| *value != neutral).map(|value| format!("{role} {}", plain(value)))
    };
    let said: Vec<String> = [of("scale", 1.0), of("offset", 0.0)].into_iter().flatten().collect();
    let said = (!said.is_empty()).then(|| said.join(" and "))?;
    Some(format!("not applied: GDAL's {said} (tag 42112), so range, nodata and fill are in the numbers as stored"))
}

/// What is said of cells that are not square in the world.
fn cells(tags: &mut Tags<'_>) -> Option<String> {
    let sizes = tags.get_tag_f64_vec(Tag::ModelPixelScaleTag).ok()?;
    let sizes = sizes.get(..2).filter(|sizes| sizes.iter().all(|size| size.is_finite() && *size > 0.0))?;
    oblong(sizes[0], sizes[1])
}
