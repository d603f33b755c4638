//! Lists of rays from CSV files.
use crate::error::{Error, Result};
use std::path::Path;

const COLUMNS: [&str; 4] = ["u", "v", "du", "dv"];

/// Rays of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct RayTable {
    /// Entry point and travel: `u`, `v`, `du`, `dv`.
    pub rays: Vec<[f64; 4]>,
    /// The finest level of each ray, if the table has a column `lod`.
    pub lods: Option<Vec<u32>>,
}

/// Reads rays from a CSV file whose first line names the columns `u`, `v`, `du`, `dv` and perhaps `lod` in any order; other columns are
/// ignored. Entry points are in tiles, directions in tiles per full height. Numbers must be finite, but need not be
/// rays that the unit accepts: that is the unit's to say.
///
/// # Errors
/// [`Error::File`] if it can't be read; [`Error::Input`] naming line (from 1, the header's) and column.
pub fn read_rays(path: impl AsRef<Path>) -> Result<RayTable> {
    let path = path.as_ref();
    let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
    parse_table(&bytes, &path.display().to_string())
}

/// As [`parse_table`], without the finest levels.
///
/// # Errors
/// [`Error::Input`] naming line and column.
pub fn parse_rays(bytes: &[u8], name: &str) -> Result<Vec<[f64; 4]>> {
    Ok(parse_table(bytes, name)?.rays)
}

/// As [`read_rays`], from bytes; `name` stands for the file in the sentences.
///
/// # Errors
/// [`Error::Input`] naming line and column.
pub fn parse_table(bytes: &[u8], name: &str) -> Result<RayTable> {
    // Spreadsheets like to put a byte order mark first; it is no part of the first column's name.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err(Error::input(format!("{name} is empty: a header u,v,du,dv and one line a ray are needed")));
    }
    let broken = |error: csv::Error| {
        let line = error.position().map_or(String::new(), |position| format!(", line {}", position.line()));
        let what = match error.kind() {
            csv::ErrorKind::Utf8 { .. } => "is not UTF-8 text".to_owned(),
            _ => format!("is not CSV: {error}"),
        };
        Error::input(format!("{name}{line}: {what}"))
    };
    // Lines of another length are let through here, for a better sentence below.
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).flexible(true).from_reader(bytes);
    let header = reader.headers().map_err(broken)?.clone();
    let mut place = [0; 4];
    for (place, column) in place.iter_mut().zip(COLUMNS) {
        let mut found = header.iter().enumerate().filter(|(_, name)| *name == column);
        *place = found.next().map(|(at, _)| at).ok_or_else(|| {
            Error::input(format!("{name}, line 1: no column {column}: the header must name u, v, du and dv"))
        })?;
        if found.next().is_some() {
            return Err(Error::input(format!("{name}, line 1: two columns are named {column}: one is needed")));
        }
    }
    let lod_at = header.iter().position(|name| name == "lod");
    let (mut rays, mut lods) = (Vec::new(), Vec::new());
    for record in reader.records() {
        let record = record.map_err(broken)?;
        let line = record.position().map_or(0, csv::Position::line);
        if record.len() > header.len() {
            return Err(Error::input(format!(
                "{name}, line {line}: {} values for {} columns: a decimal point, not a comma, is needed",
                record.len(),
                header.len()
            )));
        }
        let mut ray = [0.0f64; 4];
        for ((number, at), column) in ray.iter_mut().zip(place).zip(COLUMNS) {
            let text = record.get(at).unwrap_or_default();
            if text.is_empty() {
                return Err(Error::input(format!("{name}, line {line}, column {column}: the number is missing")));
            }
            *number = text
                .parse()
                .map_err(|_| Error::input(format!("{name}, line {line}, column {column}: {text:?} is not a number")))?;
            if !number.is_finite() {
                return Err(Error::input(format!(
                    "{name}, line {line}, column {column}: {text} is not a finite number"
                )));
            }
        }
        rays.push(ray);
        if let Some(at) = lod_at {
            let text = record.get(at).unwrap_or_default();
            let bad = |_| Error::input(format!("{name}, line {line}, column lod: {text:?} is not a level (0 or more)"));
            lods.push(text.parse::<u32>().map_err(bad)?);
        }
    }
    if rays.is_empty() {
        return Err(Error::input(format!("{name} holds no ray: a line below the header is needed")));
    }
    Ok(RayTable { rays, lods: lod_at.map(|_| lods) })
}
