//! What a verb looks at: one set of options for all verbs that trace or judge.
use clap::Args;
use clap::builder::{OsStringValueParser, TypedValueParser};
use std::ffi::OsString;
use std::path::PathBuf;

/// The height map of a verb.
#[derive(Args, Clone, Debug)]
pub struct MapArgs {
    /// Height map: PNG, PGM, PFM, TIFF, EXR, BMP, TGA, WebP, DDS, HGT, ESRI ASC, R16 or RAW; without it the configured one. The keys
    /// map.range, nodata, fill, channel, part, size and byte_order say how it is read.
    #[arg(long, value_name = "FILE")]
    pub map: Option<PathBuf>,
    /// Resamples the map (size and bit depth) to what the configuration asks for.
    #[arg(long)]
    pub resample: bool,
    /// Cuts a larger map to its first columns and rows, from the top left.
    #[arg(long)]
    pub crop: bool,
    /// Continues a smaller map by its last column and row.
    #[arg(long)]
    pub pad: bool,
    /// Reads maps of up to N texels instead of map.max_texels.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1 << 40))]
    pub max_texels: Option<u64>,
}

impl MapArgs {
    /// Puts what was asked for on the command line into the configuration; `resample` goes to whoever reads the map.
    pub fn apply(&self, map: &mut crate::config::MapConfig) {
        map.crop |= self.crop;
        map.pad |= self.pad;
        map.max_texels = self.max_texels.unwrap_or(map.max_texels);
    }
}

/// Map, views and rays of a verb.
#[derive(Args, Clone, Debug)]
pub struct SceneArgs {
    /// The height map.
    #[command(flatten)]
    pub map: MapArgs,
    /// Whose rays: views by name (front, oblique, grazing), or camera files (TOML: elevation, azimuth, distance, fov, width, height).
    #[arg(long, visible_alias = "views", value_name = "NAME|CAMERA.toml,...")]
    pub view: Vec<String>,
    /// Rays of a CSV file with the columns u, v, du, dv, instead of those of views, or beside those of `--view`. Or a number: how many rays.
    #[arg(long, value_name = "R.csv|N", value_parser = OsStringValueParser::new().try_map(RaysArg::of))]
    pub rays: Option<RaysArg>,
}

/// What `--rays` says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RaysArg {
    /// How many rays; each verb says of what.
    Count(usize),
    /// A table of rays.
    File(PathBuf),
}

/// Rays that can be asked for at once, which have their place in memory.
pub const MOST_RAYS: usize = 10_000_000;

impl RaysArg {
    /// A number is a count, everything else names a file (`./100` a file of that name).
    fn of(text: OsString) -> Result<Self, String> {
        match text.to_str() {
            Some(digits) if !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()) => {
                let count = digits.parse().ok().filter(|count| *count <= MOST_RAYS);
                count.map(Self::Count).ok_or_else(|| {
                    format!(
                        "{digits} rays are more than {MOST_RAYS}, the most at once (./{digits} is a file of that name)"
                    )
                })
            }
            Some("") => Err("it names no file and no number".into()),
            _ => Ok(Self::File(text.into())),
        }
    }
}

impl SceneArgs {
    /// The number of rays, if one is given.
    pub const fn count(&self) -> Option<usize> {
        match self.rays {
            Some(RaysArg::Count(n)) => Some(n),
            Some(RaysArg::File(_)) | None => None,
        }
    }

    /// The table of rays, if one is given.
    pub fn table(&self) -> Option<&PathBuf> {
        match &self.rays {
            Some(RaysArg::File(file)) => Some(file),
            Some(RaysArg::Count(_)) | None => None,
        }
    }

    /// Whether views or rays of the user's are given.
    pub fn chosen(&self) -> bool {
        !self.view.is_empty() || self.table().is_some()
    }
}
