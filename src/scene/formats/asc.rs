//! ESRI ASCII grids.
use super::opened::{Info, Opened, Rows, Samples, broken, oblong, sized};
use super::pick::Pick;
use super::plain::Words;
use crate::source::Source;
use reliefrtl_base::error::Result;
use reliefrtl_base::files::MARK;
use reliefrtl_config::MapConfig;
use std::io::{Read, Seek};

const KIND: &str = "ESRI ASC";
/// Words of the header, besides those that are read.
const PLACE: [&str; 5] = ["xllcorner", "yllcorner", "xllcenter", "yllcenter", "cellsize"];

/// Starts like one.
pub(super) fn is_asc(head: &[u8]) -> bool {
    let word = head.strip_prefix(MARK).unwrap_or(head).trim_ascii_start();
    [&b"ncols"[..], b"nrows"].iter().any(|key| word.len() > key.len() && word[..key.len()].eq_ignore_ascii_case(key))
}

/// The header: a key and a value each, in any order; the first number ends it.
pub(super) fn open<'a>(source: &'a Source, map: &'a MapConfig) -> Result<Opened<'a>> {
    let mut handle = source.open()?;
    let mut mark = Vec::new();
    handle.by_ref().take(MARK.len() as u64).read_to_end(&mut mark).map_err(|e| broken(KIND, e))?;
    if mark != MARK {
        handle.rewind().map_err(|e| broken(KIND, e))?;
    }
    let mut words = Words::new(handle, KIND, false);
    let (mut columns, mut rows, mut nodata) = (None, None, None);
    let (mut dx, mut dy) = (None, None);
    let first = loop {
        let Some(key) = words.next()? else { return Err(broken(KIND, "it ends in its header")) };
        if key.parse::<f64>().is_ok() {
            break key;
        }
        let lower = key.to_ascii_lowercase();
        let twice = || broken(KIND, format!("{key} stands there twice"));
        match lower.as_str() {
            "ncols" if columns.replace(words.whole("the number of columns")?).is_some() => return Err(twice()),
            "nrows" if rows.replace(words.whole("the number of rows")?).is_some() => return Err(twice()),
            "ncols" | "nrows" => {}
            "nodata_value" => {
                let value = words.next()?.and_then(|word| word.parse::<f64>().ok());
                let value = value.ok_or_else(|| broken(KIND, "NODATA_value is not a number"))?;
                if nodata.replace(value).is_some() {
                    return Err(twice());
                }
            }
            key @ ("dx" | "dy") => {
                let value = words.next()?.and_then(|word| word.parse::<f64>().ok()).filter(|size| size.is_finite());
                let value = value.ok_or_else(|| broken(KIND, format!("{key} is not a finite number")))?;
                let size = if key == "dx" { &mut dx } else { &mut dy };
                if size.replace(value).is_some() {
                    return Err(twice());
                }
            }
            key if PLACE.contains(&key) => drop(words.next()?),
            _ => {
                let shown: String = key.chars().take(20).collect();
                if key.contains(',') && key.replace(',', ".").parse::<f64>().is_ok() {
                    return Err(broken(KIND, format!("{shown:?} has a comma where a number has a point")));
                }
                return Err(broken(KIND, format!("{shown:?} is no key of its header")));
            }
        }
    };
    let missing = |key: &str| broken(KIND, format!("its header lacks {key}"));
    let (width, height) = sized(columns.ok_or_else(|| missing("ncols"))?, rows.ok_or_else(|| missing("nrows"))?, map)?;
    // A number takes a byte and one before the next.
    if (width as u64 * height as u64) * 2 - 1 > source.len() {
        return Err(broken(KIND, format!("{width} x {height} heights are announced in {} bytes", source.len())));
    }
    let pick = Pick::new(&["Y"], 1.0, map)?;
    let samples = Samples::Float(64);
    let note = dx.zip(dy).and_then(|(dx, dy)| oblong(dx, dy));
    let info = Info { channel: pick.label(), nodata, note, ..Info::new(KIND, width, height, samples) };
    Ok(Opened { info, rows: Box::new(Asc { words, first: Some(first), rows: height, at: 0 }) })
}

struct Asc<'a> {
    words: Words<'a>,
    /// The number that ended the header.
    first: Option<String>,
    rows: usize,
    at: usize,
}

impl Rows for Asc<'_> {
    fn next(&mut self, row: &mut [f64]) -> Result<()> {
        for (x, height) in row.iter_mut().enumerate() {
            *height = match self.first.take() {
                Some(word) => word.parse().map_err(|_| broken(KIND, "its first height is not a number"))?,
                None => self.words.number(x, self.at)?,
            };
        }
        self.at += 1;
        if self.at == self.rows { self.words.end() } else { Ok(()) }
    }
}
