//! What was taken of a map's file, for the summary.
use reliefrtl_config::check::plain;
use serde::Serialize;
use std::fmt;

/// A file as it was read.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Taken {
    /// The file.
    pub file: String,
    /// Its kind.
    pub format: String,
    /// Its columns.
    pub width: usize,
    /// Its rows.
    pub height: usize,
    /// Its numbers, in words.
    pub samples: String,
    /// The part or page, where it has several.
    pub part: Option<String>,
    /// The channel.
    pub channel: String,
    /// What becomes 0 and full height, in the file's units.
    pub range: [f64; 2],
    /// The lowest height, in the file's units; `None` where no texel has data.
    pub lowest: Option<f64>,
    /// The highest height, in the file's units.
    pub highest: Option<f64>,
    /// The value of no data, if there is one.
    pub nodata: Option<f64>,
    /// Texels without data.
    pub nodata_texels: u64,
    /// The height that they took, in the file's units.
    pub fill: Option<f64>,
    /// Columns and rows that were kept, from the top left.
    pub kept: [usize; 2],
    /// What became of them, in words; nothing, if they are the map's texels.
    pub fit: Option<String>,
    /// What else the file says.
    pub note: Option<String>,
}

impl fmt::Display for Taken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}, {} x {}, {}", self.file, self.format, self.width, self.height, self.samples)?;
        if let Some(part) = &self.part {
            write!(f, ", part {part}")?;
        }
        write!(f, ", channel {}", self.channel)?;
        if let (Some(lowest), Some(highest)) = (self.lowest, self.highest) {
            write!(f, ", heights {} to {}", plain(lowest), plain(highest))?;
        }
        write!(f, " (range {} to {})", plain(self.range[0]), plain(self.range[1]))?;
        match (self.nodata_texels, self.fill) {
            (0, _) => f.write_str(", 0 texels without data")?,
            (count, Some(fill)) => write!(f, ", {count} texels without data filled with {}", plain(fill))?,
            (count, None) => write!(f, ", {count} texels without data")?,
        }
        if self.kept != [self.width, self.height] {
            write!(f, "; cut to {} x {}", self.kept[0], self.kept[1])?;
        }
        for more in [&self.fit, &self.note].into_iter().flatten() {
            write!(f, "; {more}")?;
        }
        Ok(())
    }
}
