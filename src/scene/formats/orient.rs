//! Pictures that are stored turned or mirrored.
use super::opened::{Info, Opened, Rows, filled};
use reliefrtl_base::error::{Error, Result};

/// A picture whose stored rows must be turned, as the tag of TIFF and EXIF says: 1 is upright, 2 mirrored, 3 upside down, 4 both, 5 to 8
/// with rows and columns exchanged.
pub(super) fn upright(opened: Opened<'_>, orientation: u32) -> Result<Opened<'_>> {
    match orientation {
        1 => return Ok(opened),
        2..=8 => {}
        other => {
            return Err(Error::input(format!(
                "its orientation is {other}, and 1 (upright) to 8 are legal: save it upright"
            )));
        }
    }
    let Opened { info, mut rows } = opened;
    let (width, height) = (info.width, info.height);
    let mut samples = filled(0.0, width * height)?;
    samples.chunks_exact_mut(width).try_for_each(|row| rows.next(row))?;
    let turned = orientation >= 5;
    let info = if turned { Info { width: height, height: width, ..info } } else { info };
    Ok(Opened { info, rows: Box::new(Turned { samples, width, height, orientation, at: 0 }) })
}

/// The orientation that EXIF data give; 1 where they give none.
pub(super) fn of_exif(data: Option<&[u8]>) -> u32 {
    /// Its tag.
    const ORIENTATION: usize = 0x112;
    let find = |data: &[u8]| {
        let little = data.starts_with(b"II*\0");
        if !little && !data.starts_with(b"MM\0*") {
            return None;
        }
        let number = |at: usize, bytes: usize| {
            let bytes = data.get(at..at.checked_add(bytes)?)?;
            let push = |word: usize, byte: &u8| word << 8 | usize::from(*byte);
            Some(if little { bytes.iter().rev().fold(0, push) } else { bytes.iter().fold(0, push) })
        };
        let table = number(4, 4)?;
        let entries = (0..number(table, 2)?).map(|k| table + 2 + 12 * k);
        let entry = entries.take_while(|at| at + 12 <= data.len()).find(|at| number(*at, 2) == Some(ORIENTATION))?;
        number(entry + 8, 2)
    };
    data.and_then(find).map_or(1, |orientation| orientation as u32)
}

struct Turned {
    samples: Vec<f64>,
    /// As stored.
    width: usize,
    /// As stored.
    height: usize,
    orientation: u32,
    at: usize,
}

impl Rows for Turned {
    fn next(&mut self, row: &mut [f64]) -> Result<()> {
        let (right, bottom) = (self.width - 1, self.height - 1);
        let y = self.at;
        for (x, height) in row.iter_mut().enumerate() {
            let (column, line) = match self.orientation {
                2 => (right - x, y),
                3 => (right - x, bottom - y),
                4 => (x, bottom - y),
                5 => (y, x),
                6 => (y, bottom - x),
                7 => (right - y, bottom - x),
                _ => (right - y, x),
            };
            *height = self.samples[line * self.width + column];
        }
        self.at += 1;
        Ok(())
    }
}
