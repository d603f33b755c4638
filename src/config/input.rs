//! The sections of the configuration that do not shape the hardware, and the named choices of the number format.
use super::{Counters, ExtraUnit};
use reliefrtl_base::format::{FloatFormat, Rounding, Specials, Subnormals};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// Which NaN comes out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum NanRule {
    /// One: sign 0, top fraction bit 1, rest 0.
    #[default]
    Canonical,
}

/// The number format, and its policies by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct FormatConfig {
    /// EXP_W: exponent bits; 2 to 8.
    pub exp: u32,
    /// MAN_W: fraction bits, the hidden one not counted; 2 to 23 (the traverse unit needs 7).
    pub man: u32,
    /// Rounding.
    pub rounding: Rounding,
    /// Numbers below the smallest normal one.
    pub subnormals: Subnormals,
    /// Whether there are infinities and NaN.
    pub specials: Specials,
    /// The NaN of results.
    pub nan: NanRule,
}

impl FormatConfig {
    /// The format's widths and choices.
    pub const fn float(&self) -> FloatFormat {
        let Self { exp, man, rounding, subnormals, specials, .. } = *self;
        FloatFormat { exp, man, rounding, subnormals, specials }
    }
}

impl Default for FormatConfig {
    fn default() -> Self {
        Self {
            exp: FloatFormat::FP24.exp,
            man: FloatFormat::FP24.man,
            rounding: Rounding::NearestEven,
            subnormals: Subnormals::Flush,
            specials: Specials::Ieee,
            nan: NanRule::Canonical,
        }
    }
}

/// Where the height map comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MapKind {
    /// A bed of worn stones of several sizes.
    #[default]
    Rocks,
    /// A wall of bricks in running bond, with mortar.
    Bricks,
    /// Asymmetric wind ripples.
    Dunes,
    /// A field of cones.
    Spikes,
    /// A stepped pyramid with a flight of stairs up the middle of each side.
    Stairs,
    /// Everything at mid height.
    Flat,
    /// One texel at full height, the rest at 0.
    Spike,
    /// One texel at 0, the rest at full height.
    Pit,
    /// Texels alternate between 0 and full height.
    Checker,
    /// The image `map.file`.
    File,
}
words!(MapKind: Rocks = "rocks", Bricks = "bricks", Dunes = "dunes", Spikes = "spikes", Stairs = "stairs", Flat = "flat",
    Spike = "spike", Pit = "pit", Checker = "checker", File = "file");

/// What lies beyond the map's border.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Border {
    /// The map again.
    #[default]
    Wrap,
    /// The border texels, continued outward.
    Clamp,
    /// The map's mirror image.
    Mirror,
}
words!(Border: Wrap = "wrap", Clamp = "clamp", Mirror = "mirror");

/// Which byte of a sample comes first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ByteOrder {
    /// The least significant.
    #[default]
    Little,
    /// The most significant.
    Big,
}
words!(ByteOrder: Little = "little", Big = "big");

/// The one word among the ranges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Auto {
    /// The lowest and the highest height of the file.
    Auto,
}

/// Which heights of a file become 0 and full height.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(untagged)]
pub enum MapRange {
    /// What the file holds.
    Auto(Auto),
    /// These two, in the file's units; the first is smaller.
    Limits([f64; 2]),
}

impl Border {
    /// Levels of the design that the map itself does not have: a map that is not repeated is prepared into one of twice the side.
    pub const fn levels(self) -> u32 {
        match self {
            Self::Wrap => 0,
            Self::Clamp | Self::Mirror => 1,
        }
    }
}

/// The height map and how it lies in the world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MapConfig {
    /// A procedural map, or `file`.
    pub kind: MapKind,
    /// The image if `kind` is `file`; a relative path in a TOML file starts at that file's directory.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
    /// Seed of the procedural maps.
    pub seed: u64,
    /// Height of a full-height texel, in world units (the quad is 200 x 200); 0 to 1000.
    pub scale: f64,
    /// How many times the map repeats along each side of the quad; 1 to 64.
    pub repeat: u32,
    /// Whether an image of another size or depth may be resampled to 2^levels texels and height_bits bits.
    pub resample: bool,
    /// What lies beyond the map's border. Other borders than `wrap` take a map of 2^(levels-1) texels a side.
    pub border: Border,
    /// The heights of the file, in its own units, that become 0 and full height; `None`: whole numbers are codes, floats lie in \[0, 1\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range: Option<MapRange>,
    /// The value that marks a texel without data, in the file's units; goes before what the file itself says.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nodata: Option<f64>,
    /// The height that texels without data take, in the file's units; without it they are an error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fill: Option<f64>,
    /// The channel of the file that holds the heights, by name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub channel: Option<String>,
    /// The part (OpenEXR) or page (TIFF) of the file, by name or number from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<String>,
    /// Width and height of a file without a header (R16, RAW, HGT).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size: Option<[u32; 2]>,
    /// Order of the bytes of a sample in a file without a header (R16, RAW).
    #[serde(skip_serializing_if = "is_default")]
    pub byte_order: ByteOrder,
    /// The largest number of texels of a file that is read.
    #[serde(skip_serializing_if = "is_default_limit")]
    pub max_texels: u64,
    /// Whether a file that was compressed with loss may be read.
    #[serde(skip_serializing_if = "is_default")]
    pub lossy: bool,
    /// Whether a larger file is cut to its first columns and rows, from the top left.
    #[serde(skip_serializing_if = "is_default")]
    pub crop: bool,
    /// Whether a smaller file is continued by its last column and row.
    #[serde(skip_serializing_if = "is_default")]
    pub pad: bool,
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

fn is_default_limit(value: &u64) -> bool {
    *value == MapConfig::MAX_TEXELS
}

impl MapConfig {
    /// The largest number of texels that is read where nothing else is asked for.
    pub const MAX_TEXELS: u64 = 1 << 26;

    /// Whether the map may stand beside the published tables.
    ///
    /// # Errors
    /// It does not repeat.
    pub fn published_border(&self) -> reliefrtl_base::error::Result<()> {
        if self.border == Border::Wrap {
            return Ok(());
        }
        Err(reliefrtl_base::error::Error::input(format!(
            "map.border = \"{}\" does not go with --scenes: the published maps repeat",
            self.border
        )))
    }
}

impl Default for MapConfig {
    fn default() -> Self {
        Self {
            kind: MapKind::Rocks,
            file: None,
            seed: 1,
            scale: 20.0,
            repeat: 1,
            resample: false,
            border: Border::Wrap,
            range: None,
            nodata: None,
            fill: None,
            channel: None,
            part: None,
            size: None,
            byte_order: ByteOrder::Little,
            max_texels: Self::MAX_TEXELS,
            lossy: false,
            crop: false,
            pad: false,
        }
    }
}

/// The three standard views of the 200 x 200 quad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum View {
    /// From straight above.
    Front,
    /// 22 degrees above the plane.
    Oblique,
    /// 3 degrees above the plane.
    Grazing,
}
words!(View: Front = "front", Oblique = "oblique", Grazing = "grazing");

/// The pictures whose pixels give the rays.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ViewConfig {
    /// Which views.
    pub names: Vec<View>,
    /// Width in pixels; 1 to 8192.
    pub width: u32,
    /// Height in pixels; 1 to 8192.
    pub height: u32,
    /// Every n-th pixel in each direction is traced; 1 to 256.
    pub stride: u32,
}

impl Default for ViewConfig {
    fn default() -> Self {
        Self { names: View::ALL.to_vec(), width: 1024, height: 768, stride: 4 }
    }
}

/// Where random bits come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Generator {
    /// ChaCha with 8 rounds: the same bits on every machine.
    #[default]
    Chacha8,
}

/// How many vectors are made, and from which random bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct VectorsConfig {
    /// The generator's name.
    pub generator: Generator,
    /// The generator's seed.
    pub seed: u64,
    /// Vectors of each arithmetic unit; 1 to 1000000.
    pub arithmetic: u32,
    /// Rays of each view; 1 to 1000000.
    pub rays: u32,
    /// Whether `traverse` also gets the rays that are planned to reach every refusal, limit, exponent and a spread of the texels.
    pub planned: bool,
}

impl Default for VectorsConfig {
    fn default() -> Self {
        Self { generator: Generator::Chacha8, seed: 1, arithmetic: 2000, rays: 300, planned: true }
    }
}

/// What the `` `default_nettype`` is after an emitted file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DefaultNettype {
    /// Verilog's own: an undeclared net is a wire. The file itself is read with `none`.
    #[default]
    Wire,
    /// As in the file itself: an undeclared net is an error.
    None,
    /// What it was before the file, which says nothing of it.
    Keep,
}

words!(DefaultNettype: Wire = "wire", None = "none", Keep = "keep");

/// What the emitted files look like.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct EmitConfig {
    /// Put before the name of every emitted module and file; empty, or a Verilog identifier.
    pub prefix: String,
    /// The operand of the `` `timescale`` of every emitted file; empty: they have none.
    pub timescale: String,
    /// What undeclared nets are after every emitted file.
    pub default_nettype: DefaultNettype,
    /// Units besides what the traversal needs.
    pub units: Vec<ExtraUnit>,
    /// Counters of a hit.
    #[serde(skip_serializing_if = "is_default")]
    pub counters: Counters,
    /// Clock of the constraints in `flow/`, MHz; 1 to 1000.
    pub clock_mhz: u32,
}

impl Default for EmitConfig {
    fn default() -> Self {
        Self {
            prefix: "relief_".into(),
            timescale: String::new(),
            default_nettype: DefaultNettype::Wire,
            units: Vec::new(),
            counters: Counters::default(),
            clock_mhz: 84,
        }
    }
}
