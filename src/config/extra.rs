//! Units that no traversal needs.
use serde::{Deserialize, Serialize};

/// A unit that is only emitted where it is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ExtraUnit {
    /// Square root.
    FpSqrt,
    /// Reciprocal.
    FpRecip,
    /// Less, equal, greater, unordered.
    FpCompare,
    /// Sum of three.
    FpAdd3,
    /// Synchronous FIFO.
    Fifo,
    /// Round robin arbiter.
    Arbiter,
}

words!(ExtraUnit:
    FpSqrt = "fp_sqrt",
    FpRecip = "fp_recip",
    FpCompare = "fp_compare",
    FpAdd3 = "fp_add3",
    Fifo = "fifo",
    Arbiter = "arbiter",
);

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
