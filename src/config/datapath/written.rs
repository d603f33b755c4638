//! The section `datapath` as it stands in a file: one word for the arithmetic, one for the search.
use super::kind::{DatapathConfig, DatapathKind, Search};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;

/// Which arithmetic traces the rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Arithmetic {
    /// Parameters of integer planes are compared in floating point; no position is moved.
    Watertight,
    /// Positions are moved in floating point, boundaries found by division in the loop (PIDM-HW section 4.2).
    Published,
    /// The watertight comparison in fixed point, with a reciprocal of chosen width.
    Fixed,
}

/// Which arithmetic traces the rays, and its widths.
#[derive(Clone, Copy, Debug, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
struct Written {
    /// The arithmetic.
    kind: Arithmetic,
    /// `fixed`: what is searched.
    #[serde(skip_serializing_if = "is_pyramid")]
    search: Search,
    /// `published`: a crossing lands 2^-nudge_bits texels beyond its plane; 0 is no nudge.
    nudge_bits: u32,
    /// `fixed`: fraction bits of entry point, travel (tiles) and ray parameter.
    fraction_bits: u32,
    /// `fixed`: significant bits of the reciprocal of the travel.
    reciprocal_bits: u32,
}

fn is_pyramid(search: &Search) -> bool {
    *search == Search::Pyramid
}

impl Default for Written {
    fn default() -> Self {
        DatapathConfig::default().into()
    }
}

impl From<DatapathConfig> for Written {
    fn from(c: DatapathConfig) -> Self {
        let (kind, search) = match c.kind {
            DatapathKind::Watertight => (Arithmetic::Watertight, c.search),
            DatapathKind::Published => (Arithmetic::Published, c.search),
            DatapathKind::Fixed => (Arithmetic::Fixed, Search::Pyramid),
            DatapathKind::Windows => (Arithmetic::Fixed, Search::Windows),
        };
        let DatapathConfig { nudge_bits, fraction_bits, reciprocal_bits, .. } = c;
        Self { kind, search, nudge_bits, fraction_bits, reciprocal_bits }
    }
}

impl From<Written> for DatapathConfig {
    fn from(w: Written) -> Self {
        let (kind, search) = match (w.kind, w.search) {
            (Arithmetic::Watertight, search) => (DatapathKind::Watertight, search),
            (Arithmetic::Published, search) => (DatapathKind::Published, search),
            (Arithmetic::Fixed, Search::Pyramid) => (DatapathKind::Fixed, Search::Pyramid),
            (Arithmetic::Fixed, Search::Windows) => (DatapathKind::Windows, Search::Pyramid),
        };
        let Written { nudge_bits, fraction_bits, reciprocal_bits, .. } = w;
        Self { kind, search, nudge_bits, fraction_bits, reciprocal_bits }
    }
}

impl Serialize for DatapathConfig {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        Written::from(*self).serialize(to)
    }
}

impl<'de> Deserialize<'de> for DatapathConfig {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        Written::deserialize(from).map(Self::from)
    }
}

impl schemars::JsonSchema for DatapathConfig {
    fn schema_name() -> Cow<'static, str> {
        "DatapathConfig".into()
    }

    fn json_schema(of: &mut schemars::SchemaGenerator) -> schemars::Schema {
        Written::json_schema(of)
    }
}
