//! How much of the pyramid one iteration reads (`docs/cells.md`).
use serde::{Deserialize, Serialize};

/// What one iteration reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct FetchConfig {
    /// Cells of the pyramid that are read and judged in one iteration: 1, or 4 siblings.
    pub cells: u32,
}

impl Default for FetchConfig {
    fn default() -> Self {
        Self { cells: 1 }
    }
}

impl FetchConfig {
    /// Four siblings, a block of two by two.
    pub const BLOCK: Self = Self { cells: 4 };

    /// Four cells are read at once.
    pub const fn blocks(self) -> bool {
        self.cells > 1
    }
}
