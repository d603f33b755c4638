//! Files without a header: R16, RAW, and the tiles of the Shuttle Radar Topography Mission.
use super::opened::{Info, Opened, Samples, sized};
use super::packed::{Layout, Packed, Stored};
use super::pick::Pick;
use crate::source::Source;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::{ByteOrder, MapConfig};

pub(super) const RAW: &str = "RAW";
pub(super) const HGT: &str = "HGT";

/// What SRTM stores where it saw nothing.
const VOID: f64 = -32768.0;

fn samples(stored: Stored) -> Samples {
    match stored {
        Stored::Ink => Samples::bits(1),
        Stored::U8 => Samples::bits(8),
        Stored::U16 => Samples::bits(16),
        Stored::I16 => Samples::Signed(16),
        Stored::F16 => Samples::Float(16),
        Stored::F32 => Samples::Float(32),
    }
}

/// The side of a square of so many texels.
fn square(texels: u64) -> Option<u64> {
    let side = texels.isqrt();
    (side > 0 && side * side == texels).then_some(side)
}

fn rows<'a>(
    source: &'a Source,
    map: &'a MapConfig,
    (width, height): (u64, u64),
    stored: Stored,
    (big, format, nodata): (bool, &'static str, Option<f64>),
) -> Result<Opened<'a>> {
    let (width, height) = sized(width, height, map)?;
    let samples = samples(stored);
    let pick = Pick::new(&["Y"], samples.full(), map)?;
    let layout = Layout { offset: 0, width, height, stored, big, upward: false, max: f64::INFINITY };
    let info = Info { channel: pick.label(), nodata, ..Info::new(format, width, height, samples) };
    Ok(Opened { info, rows: Box::new(Packed::new(source, layout, pick, format)?) })
}

/// An SRTM tile: signed 16-bit metres, the most significant byte first, rows from the north.
pub(super) fn hgt<'a>(source: &'a Source, map: &'a MapConfig) -> Result<Opened<'a>> {
    let len = source.len();
    let size = match map.size {
        Some([width, height]) => (u64::from(width), u64::from(height)),
        None => {
            let side = square(len / 2).filter(|_| len.is_multiple_of(2)).ok_or_else(|| {
                Error::input(format!(
                    "{len} bytes are no square of 16-bit heights (1201 x 1201 or 3601 x 3601, as SRTM has): give its size with --set map.size=[width,height]"
                ))
            })?;
            (side, side)
        }
    };
    whole(len, size, 2)?;
    rows(source, map, size, Stored::I16, (true, HGT, Some(VOID)))
}

/// The file holds exactly that many samples.
fn whole(len: u64, (width, height): (u64, u64), bytes: u64) -> Result<()> {
    if u128::from(width) * u128::from(height) * u128::from(bytes) == u128::from(len) {
        return Ok(());
    }
    Err(Error::input(format!("{width} x {height} heights of {bytes} bytes are not the {len} bytes of the file")))
}

/// R16, R8, R32 (floats), or RAW, whose size tells how many bytes a height has.
pub(super) fn open<'a>(source: &'a Source, map: &'a MapConfig) -> Result<Opened<'a>> {
    let len = source.len();
    let ends = |ending: &str| source.name().to_ascii_lowercase().ends_with(ending);
    let named = [(".r8", 1), (".r16", 2), (".r32", 4)].into_iter().find(|(ending, _)| ends(ending)).map(|x| x.1);
    let (size, bytes) = match (map.size, named) {
        (Some([width, height]), named) => {
            let (width, height) = (u64::from(width), u64::from(height));
            let fits = |bytes: &u64| u128::from(width) * u128::from(height) * u128::from(*bytes) == u128::from(len);
            let bytes = match named {
                Some(bytes) => bytes,
                None => [1, 2, 4].into_iter().find(fits).ok_or_else(|| {
                    Error::input(format!(
                        "the file has {len} bytes, which are no {width} x {height} heights (map.size) of 1, 2 or 4 bytes (8-bit, 16-bit, 32-bit float)"
                    ))
                })?,
            };
            ((width, height), bytes)
        }
        (None, Some(bytes)) => {
            let side = square(len / bytes).filter(|_| len.is_multiple_of(bytes)).ok_or_else(|| {
                Error::input(format!(
                    "{len} bytes are no square of heights of {bytes} bytes: give its size with --set map.size=[width,height]"
                ))
            })?;
            ((side, side), bytes)
        }
        (None, None) => {
            return Err(Error::input(format!(
                "a RAW file has no header ({len} bytes): give its size with --set map.size=[width,height], and --set map.byte_order=big if the most significant byte comes first"
            )));
        }
    };
    whole(len, size, bytes)?;
    let stored = match bytes {
        1 => Stored::U8,
        2 => Stored::U16,
        _ => Stored::F32,
    };
    rows(source, map, size, stored, (map.byte_order == ByteOrder::Big, RAW, None))
}
