//! Lists of rays from CSV files.
use reliefrtl_base::alike::similarity;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_base::files::{MARK, TABLE, read_named};
use std::path::Path;

const COLUMNS: [&str; 4] = ["u", "v", "du", "dv"];
const LOD: &str = "lod";

/// Rays of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct RayTable {
    /// Entry point and travel: `u`, `v`, `du`, `dv`.
    pub rays: Vec<[f64; 4]>,
    /// The finest level of each ray, if the table has a column `lod`.
    pub lods: Option<Vec<u32>>,
}

/// Reads rays from a CSV file whose first line names the columns `u`, `v`, `du`, `dv` and perhaps `lod`, each once, in any order. Other
/// columns are passed over, but for one that looks like a misspelt `lod`; with `lod_expected` there are none unless `lod` is there. Entry points are in tiles, directions in tiles per full height. Numbers must be finite, but need not be
/// rays that the unit accepts: that is the unit's to say.
///
/// # Errors
/// [`Error::File`] if it can't be read; [`Error::Input`] naming line (from 1, the header's) and column.
pub fn read_rays(path: impl AsRef<Path>, lod_expected: bool) -> Result<RayTable> {
    let path = path.as_ref();
    let bytes = read_named(path, TABLE)?;
    parse_table(&bytes, &path.display().to_string(), lod_expected)
}

/// As [`parse_table`], without the finest levels.
///
/// # Errors
/// [`Error::Input`] naming line and column.
pub fn parse_rays(bytes: &[u8], name: &str) -> Result<Vec<[f64; 4]>> {
    Ok(parse_table(bytes, name, false)?.rays)
}

/// Where the columns stand: those of a ray, and the finest level if there is one.
fn columns(header: &csv::StringRecord, name: &str, lod_expected: bool) -> Result<([usize; 4], Option<usize>)> {
    let told = |at: usize, text: String| Error::input(format!("{name}, line 1, column {}: {text}", at + 1));
    let known = || COLUMNS.iter().chain(std::iter::once(&LOD));
    let lod = header.iter().position(|column| column == LOD);
    for (at, column) in header.iter().enumerate() {
        let lower = column.to_ascii_lowercase();
        if known().any(|known| *known == column) {
            if header.iter().take(at).any(|before| before == column) {
                return Err(told(at, format!("a second column {column}: each stands there once")));
            }
        } else if let Some(known) = known().find(|known| **known == lower) {
            return Err(told(at, format!("{column:?} is written {known}")));
        } else if similarity(&lower, LOD) > 0.6 || (lod_expected && lod.is_none()) {
            return Err(told(at, format!("{column:?} is none of u, v, du, dv and lod: did you mean lod?")));
        }
    }
    let mut places = [0; 4];
    for (at, column) in places.iter_mut().zip(COLUMNS) {
        *at = header.iter().position(|name| name == column).ok_or_else(|| {
            let other = [(';', "semicolons"), ('\t', "tabs"), (' ', "blanks")];
            let one = header.get(0).filter(|_| header.len() == 1).unwrap_or_default();
            let by = other.iter().find(|(by, _)| one.contains(*by));
            let by = by.map_or(String::new(), |(_, by)| format!(", separated by commas, not by {by}"));
            Error::input(format!("{name}, line 1: no column {column}: the header must name u, v, du and dv{by}"))
        })?;
    }
    Ok((places, lod))
}

/// A quoted field ends in its own line: one that does not would swallow the lines below it.
fn quotes_closed(bytes: &[u8], name: &str) -> Result<()> {
    for (line, text) in bytes.split(|&byte| byte == b'\n').enumerate() {
        let (mut column, mut start, mut quoted) = (1, true, false);
        for &byte in text {
            match byte {
                b'"' if start || quoted => quoted = !quoted,
                b',' if !quoted => column += 1,
                _ => {}
            }
            // A doubled quote opens the field again.
            start = !quoted && (byte == b',' || byte == b'"');
        }
        if quoted {
            return Err(Error::input(format!("{name}, line {}, column {column}: a quote is not closed", line + 1)));
        }
    }
    Ok(())
}

/// As [`read_rays`], from bytes; `name` stands for the file in the sentences.
///
/// # Errors
/// [`Error::Input`] naming line and column.
pub fn parse_table(bytes: &[u8], name: &str, lod_expected: bool) -> Result<RayTable> {
    // Spreadsheets like to put a byte order mark first; it is no part of the first column's name.
    let bytes = bytes.strip_prefix(MARK).unwrap_or(bytes);
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err(Error::input(format!("{name} is empty: a header u,v,du,dv and one line a ray are needed")));
    }
    quotes_closed(bytes, name)?;
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
    let (place, lod_at) = columns(&header, name, lod_expected)?;
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
