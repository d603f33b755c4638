//! The kinds of datapaths, and what is chosen of one.
use serde::{Deserialize, Serialize};

/// How hits are found (`docs/datapath.md`, `docs/published.md`, `docs/fixed.md`, `docs/windows.md`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DatapathKind {
    /// Parameters of integer planes are compared in floating point; no position is moved.
    #[default]
    Watertight,
    /// Positions are moved in floating point, boundaries found by division in the loop (PIDM-HW section 4.2).
    Published,
    /// The watertight comparison in fixed point, with a reciprocal of chosen width.
    Fixed,
    /// The same comparison and hits in fixed point, found by windows ahead of the ray: `kind = "fixed"` with `search = "windows"`.
    Windows,
}

/// What a datapath in fixed point searches (`docs/windows.md`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Search {
    /// Nodes of the height pyramid, one an iteration.
    #[default]
    Pyramid,
    /// Windows of all sizes that begin at the ray's place, together in one iteration.
    Windows,
}

words!(Search: Pyramid = "pyramid", Windows = "windows");

/// Which arithmetic traces the rays, and its widths.
// In a file it has two keys for the kind (`written.rs`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DatapathConfig {
    /// How hits are found.
    pub kind: DatapathKind,
    /// A search that was asked of a kind which has none to choose; [`DatapathKind::Fixed`] and [`DatapathKind::Windows`] say theirs.
    pub search: Search,
    /// `published`: a crossing lands 2^-nudge_bits texels beyond its plane; 0 is no nudge.
    pub nudge_bits: u32,
    /// `fixed`: fraction bits of entry point, travel (tiles) and ray parameter.
    pub fraction_bits: u32,
    /// `fixed`: significant bits of the reciprocal of the travel.
    pub reciprocal_bits: u32,
}

impl Default for DatapathConfig {
    fn default() -> Self {
        Self {
            kind: Default::default(),
            search: Default::default(),
            nudge_bits: 7,
            fraction_bits: 24,
            reciprocal_bits: 24,
        }
    }
}
