//! Units that no traversal needs.
use serde::{Deserialize, Serialize};

/// A unit that is only emitted where it is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
pub enum ExtraUnit {
    /// Square root.
    #[serde(rename = "fp_sqrt")]
    Sqrt,
    /// Reciprocal.
    #[serde(rename = "fp_recip")]
    Recip,
    /// Less, equal, greater, unordered.
    #[serde(rename = "fp_compare")]
    Compare,
    /// Sum of three.
    #[serde(rename = "fp_add3")]
    Add3,
    /// Synchronous FIFO.
    #[serde(rename = "fifo")]
    Fifo,
    /// Round robin arbiter.
    #[serde(rename = "arbiter")]
    Arbiter,
}

impl ExtraUnit {
    /// All.
    pub const ALL: [Self; 6] = [Self::Sqrt, Self::Recip, Self::Compare, Self::Add3, Self::Fifo, Self::Arbiter];
    /// Their names, in the same order.
    pub const WORDS: &'static [&'static str] = &["fp_sqrt", "fp_recip", "fp_compare", "fp_add3", "fifo", "arbiter"];
}

/// A set of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ExtraUnits(u8);

impl ExtraUnits {
    /// All of them.
    pub const ALL: Self = Self((1 << ExtraUnit::ALL.len()) - 1);

    /// In the order of [`ExtraUnit::ALL`].
    pub fn iter(self) -> impl Iterator<Item = ExtraUnit> {
        ExtraUnit::ALL.into_iter().filter(move |u| self.0 >> *u as u8 & 1 == 1)
    }
}

impl FromIterator<ExtraUnit> for ExtraUnits {
    fn from_iter<I: IntoIterator<Item = ExtraUnit>>(units: I) -> Self {
        Self(units.into_iter().fold(0, |set, u| set | 1 << u as u8))
    }
}
