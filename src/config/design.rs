//! What is to be generated: format, traversal parameters, modes, latencies.
use super::{DatapathConfig, ExtraUnits, FetchConfig, WindowsConfig};
use reliefrtl_base::format::FloatFormat;
use serde::{Deserialize, Serialize};

/// When a crossing goes one pyramid level up (`docs/datapath.md`; PIDM-HW section 3.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LevelUp {
    /// Never (PDM).
    None,
    /// When the crossing leaves the parent node.
    Tevs,
    /// As `tevs`, but not when the predicted hit is in a neighbouring node.
    Selective,
    /// When the previous iteration was a crossing too.
    Coherent,
    /// On every crossing.
    Always,
}

words!(LevelUp: None = "none", Tevs = "tevs", Selective = "selective", Coherent = "coherent", Always = "always");

/// Whether a node is exchanged for the smallest one that holds the rest of the ray inside of it, before its height is read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Trim {
    /// Never.
    #[default]
    None,
    /// After a descent.
    Descent,
    /// Always; a crossing returns to the untrimmed level where its plane allows.
    Always,
}

words!(Trim: None = "none", Descent = "descent", Always = "always");

/// Independent choices of the traversal; only what is chosen is emitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ModeConfig {
    /// Start at the lowest level whose node holds the whole ray, instead of at the root.
    pub start_level: bool,
    /// Levels per descent until the first crossing, 1 to 4.
    pub levels_down: u32,
    /// Levels per descent after it, 1 to 3; without it 1, and 2 where four cells are read at once ([`Design::levels_down_after`]).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub levels_down_after: Option<u32>,
    /// Level-up rule.
    pub level_up: LevelUp,
    /// Chord trim.
    pub trim: Trim,
    /// The finest level is an input of each ray (PDM section 3.4).
    pub lod: bool,
    /// The hit is refined to the surface interpolated between the centres of texels (PDM section 3.3).
    pub bilinear: bool,
}

impl Default for ModeConfig {
    fn default() -> Self {
        Self {
            start_level: true,
            levels_down: 2,
            levels_down_after: None,
            level_up: LevelUp::Selective,
            trim: Trim::None,
            lod: false,
            bilinear: false,
        }
    }
}

/// Sizes of the traverse unit; each is a Verilog parameter of the emitted modules.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct TraverseConfig {
    /// LEVELS: the map has 2^levels x 2^levels texels; 2 to 12.
    pub levels: u32,
    /// HEIGHT_W: bits of a height code; 2 to 16.
    pub height_bits: u32,
    /// TILE_W: a ray travels less than 2^tile_bits tiles along each axis; 1 to 8.
    pub tile_bits: u32,
    /// FRAC_W: fraction bits of the hit position inside its texel; 1 to 16.
    pub frac_bits: u32,
    /// TAG_W: bits of a ray's tag; 1 to 32.
    pub tag_bits: u32,
    /// STEP_LIMIT: iterations after which a ray is given up; 1 to 65535.
    pub step_limit: u32,
}

impl Default for TraverseConfig {
    fn default() -> Self {
        Self { levels: 8, height_bits: 8, tile_bits: 4, frac_bits: 12, tag_bits: 8, step_limit: 65535 }
    }
}

impl TraverseConfig {
    /// IDX_W: bits of a signed, unwrapped texel coordinate.
    pub const fn idx_bits(&self) -> u32 {
        self.levels + self.tile_bits + 2
    }
}

/// How `fp_div` finds a quotient (`docs/arithmetic.md`, Division by a table).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Divider {
    /// One quotient bit a row, no multiplier: any format, many clocks.
    #[default]
    Rows,
    /// A table of reciprocals and three multipliers: few clocks, at most 16 fraction bits.
    Table,
}
words!(Divider: Rows = "rows", Table = "table");

/// The counters that `traverse` gives with each hit; what is not given has no port, no register and no column in the vectors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Counters {
    /// Iterations, node crossings and levels gone up, as far as the datapath has them.
    #[default]
    All,
    /// Iterations alone.
    Steps,
    /// None: iterations are counted inside of the loop for the step limit alone.
    None,
}

words!(Counters: All = "all", Steps = "steps", None = "none");

/// Clocks from operand to result of each kind of unit; the pipelines rebalance around them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct LatencyConfig {
    /// `fp_add`.
    pub add: u32,
    /// `fp_mul`.
    pub mul: u32,
    /// `fp_div`, `fp_recip`.
    pub div: u32,
    /// How `fp_div` is built.
    pub divider: Divider,
    /// `fp_lt`, `fp_compare`.
    pub compare: u32,
    /// `fp_from_int`, `fp_from_fixed`.
    pub from_int: u32,
    /// `fp_to_int`, `fp_to_fixed`.
    pub to_int: u32,
    /// `fp_sqrt`.
    pub sqrt: u32,
    /// `fp_add3`.
    pub add3: u32,
    /// `level_decision` and what stands before it: 1 to 5.
    pub decision: u32,
    /// After the choice of the slot's ray, inside the node's planes and after them (watertight, fixed): 0 to 3.
    pub node: u32,
    /// The read of a height: 1 to 4.
    pub memory: u32,
    /// After the choice of one of two parameters (watertight): 0 or 1.
    pub select: u32,
    /// Inside `ray_setup`, around what is not a unit of its own (watertight): 0 or 1.
    pub setup: u32,
    /// After the difference of `hit_position` and after its result (watertight, fixed): 0 to 2.
    pub hit: u32,
    /// Between ready in and ready out, before the loop and after the hit: 0 to 3.
    pub handshake: u32,
    /// What waits this many clocks or longer waits in a `delay_line` instead of registers: 3 to 17; 0: nothing does.
    pub delay_line: u32,
}

/// Widths of the conversions alone (`fp_from_int`, `fp_to_int`, `fp_from_fixed`, `fp_to_fixed`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ConvertConfig {
    /// INT_W: bits of the integer or fixed-point word; 0: what the traversal needs.
    pub int_bits: u32,
    /// FRAC_W: of these, bits after the point.
    pub frac_bits: u32,
}

/// Everything that shapes the hardware.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Design {
    /// Number format.
    pub format: FloatFormat,
    /// Sizes.
    pub traverse: TraverseConfig,
    /// What one iteration reads.
    pub fetch: FetchConfig,
    /// Modes.
    pub mode: ModeConfig,
    /// Latencies.
    pub latency: LatencyConfig,
    /// Arithmetic of the traversal.
    pub datapath: DatapathConfig,
    /// The windows of a search by windows.
    pub windows: WindowsConfig,
    /// Units besides what the traversal needs.
    pub extra: ExtraUnits,
    /// Widths of conversions alone.
    pub convert: ConvertConfig,
    /// Counters of a hit.
    pub counters: Counters,
}

impl Design {
    /// INT_W of `fp_from_int` and `fp_to_int`; INT_W and FRAC_W of `fp_from_fixed`, and of `fp_to_fixed`. Of a traversal its own.
    pub fn conversions(&self) -> (u32, [(u32, u32); 2]) {
        let (ConvertConfig { int_bits, frac_bits }, t) = (self.convert, &self.traverse);
        if int_bits > 0 {
            return (int_bits, [(int_bits, frac_bits); 2]);
        }
        let hit = (t.idx_bits() + t.frac_bits, t.frac_bits);
        (t.idx_bits(), [(self.datapath.kind.facts().from_fixed)(self), hit])
    }

    /// What `convert` asks for and the format does not allow, a sentence a problem.
    pub(super) fn convert_problems(&self) -> Vec<String> {
        let (ConvertConfig { int_bits, frac_bits }, most) = (self.convert, 61 - self.format.man);
        let mut problems = Vec::new();
        if int_bits == 0 && frac_bits > 0 {
            problems
                .push(format!("convert.frac_bits = {frac_bits} needs convert.int_bits, the bits of the whole word"));
        }
        if int_bits == 1 || int_bits > most {
            problems.push(format!(
                "convert.int_bits = {int_bits} is too {}: 2 to 61 - format.man = {most} are legal, or 0 for what the traversal needs",
                if int_bits == 1 { "small" } else { "large" }
            ));
        }
        if int_bits > 0 && frac_bits > int_bits {
            problems.push(format!(
                "convert.frac_bits = {frac_bits} is too large: at most convert.int_bits = {int_bits} is legal"
            ));
        }
        problems
    }
}

impl Default for Design {
    fn default() -> Self {
        Self {
            format: FloatFormat::FP24,
            traverse: TraverseConfig::default(),
            fetch: FetchConfig::default(),
            mode: ModeConfig::default(),
            latency: LatencyConfig::default(),
            datapath: DatapathConfig::default(),
            windows: WindowsConfig::default(),
            extra: ExtraUnits::default(),
            convert: ConvertConfig::default(),
            counters: Counters::default(),
        }
    }
}
