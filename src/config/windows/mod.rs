//! The windows of `datapath.search = "windows"` (`docs/windows.md`): sets of sizes, and the widths that follow from a design.
mod given;
mod set;
mod widths;

pub(super) use given::ignored;
pub use set::{Window, WindowSet};
pub use widths::WindowWidths;

use serde::{Deserialize, Serialize};

/// Which windows there are beside the map.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct WindowsConfig {
    /// The set; without it, that of [`WindowSet::usual`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub set: Option<WindowSet>,
}

impl WindowsConfig {
    /// The set of a map with 2^`levels` texels a side.
    pub fn at(&self, levels: u32) -> WindowSet {
        self.set.unwrap_or_else(|| WindowSet::usual(levels))
    }
}
