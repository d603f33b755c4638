//! The configuration: one description of the design, the input and the vectors.
//!
//! A [`Config`] comes from its defaults, a TOML file ([`Config::load`]) and `--set key=value` ([`Config::apply_set`]), in this order.
//! Both check names, types and ranges where the place of the mistake is still known; what holds between keys is
//! checked once by [`Config::validate`].
mod cells;
pub mod check;
#[macro_use]
mod words;
mod clock;
mod commented;
mod counters;
mod datapath;
mod design;
mod divider;
mod extra;
mod fetch;
mod given;
mod input;
pub mod keys;
pub mod lines;
pub mod modes;
mod profile;
mod registers;
mod source;
pub mod validate;
mod windows;

pub use clock::{Choice, Part, Scope, Timed, for_clock};
pub use datapath::{DatapathConfig, DatapathFacts, DatapathKind, Reads, Search, datapaths, searches};
pub use design::{ConvertConfig, Counters, Design, Divider, LatencyConfig, LevelUp, ModeConfig, TraverseConfig, Trim};
pub use extra::{ExtraUnit, ExtraUnits};
pub use fetch::FetchConfig;
pub use given::Given;
pub use input::{
    Auto, Border, ByteOrder, DefaultNettype, EmitConfig, FormatConfig, Generator, MapConfig, MapKind, MapRange,
    NanRule, VectorsConfig, View, ViewConfig,
};
pub use profile::Profile;
pub use registers::{Register, RegisterFacts};
pub use reliefrtl_base::format::{Rounding, Specials, Subnormals};
pub use windows::{Window, WindowSet, WindowWidths, WindowsConfig};

use serde::{Deserialize, Serialize};

/// The complete configuration; every key has a default.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Config {
    /// Number format of the datapath.
    pub format: FormatConfig,
    /// Sizes of the traverse unit.
    pub traverse: TraverseConfig,
    /// Arithmetic of the traversal.
    pub datapath: DatapathConfig,
    /// The windows of a search by windows.
    #[serde(skip_serializing_if = "is_default")]
    pub windows: WindowsConfig,
    /// What one iteration reads.
    #[serde(skip_serializing_if = "is_default")]
    pub fetch: FetchConfig,
    /// Choices of the traversal.
    pub mode: ModeConfig,
    /// Clocks of each kind of unit.
    pub latency: LatencyConfig,
    /// Widths of conversions alone.
    pub convert: ConvertConfig,
    /// The height map.
    pub map: MapConfig,
    /// The views whose rays are traced.
    pub view: ViewConfig,
    /// How many vectors, and their seed.
    pub vectors: VectorsConfig,
    /// What the emitted files look like.
    pub emit: EmitConfig,
    /// Which keys were written.
    #[serde(skip)]
    pub given: Given,
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

impl Config {
    /// What shapes the hardware; maps, views and vectors left out.
    pub fn design(&self) -> Design {
        Design {
            format: self.format.float(),
            traverse: self.traverse,
            fetch: self.fetch,
            mode: self.mode,
            latency: self.latency,
            datapath: self.datapath,
            windows: self.windows,
            extra: self.emit.units.iter().copied().collect(),
            convert: self.convert,
            counters: self.emit.counters,
        }
    }

    /// The same with another datapath; what that one does not read is at its default, as if it had not been given.
    pub fn choose_datapath(&mut self, kind: DatapathKind) {
        let usual = self.usual_levels_down();
        (self.datapath.kind, self.datapath.search) = (kind, Search::default());
        self.given = Given::default();
        if !kind.facts().has_blocks {
            self.mode.levels_down_after = None;
            self.follow_cells(usual);
            self.fetch = FetchConfig::default();
        }
        (kind.facts().forget)(self);
    }

    /// Twelve hex digits that name this configuration: blake3 of its canonical JSON.
    ///
    /// Only the file name of `map.file` counts, so that the same project gives the same digits in any directory.
    pub fn hash(&self) -> String {
        let mut canonical = self.clone();
        canonical.map.file = self.map.file.as_ref().and_then(|path| path.file_name()).map(Into::into);
        let json = serde_json::to_string(&canonical).expect("a configuration is plain data");
        blake3::hash(json.as_bytes()).to_hex()[..12].to_owned()
    }

    /// The JSON schema of the TOML file, with the legal ranges.
    pub fn schema() -> serde_json::Value {
        let mut schema = serde_json::to_value(schemars::schema_for!(Self)).expect("a schema is plain data");
        for key in keys::KEYS {
            let (section, name) = key.split();
            let reference = schema["properties"][section]["$ref"].as_str().unwrap_or_default();
            let place = format!("{}/properties/{name}", reference.trim_start_matches('#'));
            // schemars writes a section with a description of its own as a $ref beside that description.
            if let Some(serde_json::Value::Object(entry)) = schema.pointer_mut(&place) {
                key.legal.describe(entry);
            }
        }
        schema
    }
}
