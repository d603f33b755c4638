//! What a verb looks at: one set of options for all verbs that trace or judge.
use super::MapArgs;
use clap::Args;
use clap::builder::{OsStringValueParser, TypedValueParser};
use std::ffi::OsString;
use std::path::PathBuf;

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
