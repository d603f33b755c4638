//! Registers that a value of the table `latency` brings: which there are, from which value on, and what each stands between.
use super::LatencyConfig;

/// A register, or several of one kind, that a pipeline has or leaves out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Register {
    /// Before `level_decision`.
    BeforeDecision,
    /// After `window_choice`.
    WindowChoice,
    /// Inside `level_up`, the first.
    NodeDistance,
    /// After `level_decision`.
    AfterDecision,
    /// Inside `level_up`, the second.
    Neighbour,
    /// Inside `multi_level_down` and `block_descent`.
    Descent,
    /// Before `reciprocal`.
    Travel,
    /// Inside `hit_position`.
    HitOffset,
    /// After the clamp of `hit_position`.
    HitFraction,
    /// Inside `height_banks`.
    Bank,
    /// After `height_banks`.
    Height,
    /// Before `height_banks`.
    Address,
    /// After `axis_scale`.
    ScaledRay,
    /// Before the sums of `axis_slope`.
    Bias,
    /// After `node_planes` and `block_middle`.
    ExitPlanes,
    /// After `window_texel`.
    WindowTexel,
    /// Before the choice of the slot's ray.
    SlotRays,
    /// After it.
    SlotRay,
    /// Inside `node_planes` and `block_middle`.
    NodeExtent,
    /// After the choice of one of two ray parameters.
    Parameter,
    /// Inside `axis_slope`.
    BiasStep,
    /// After `start_level`.
    StartLevel,
}

/// What is known of a register.
pub struct RegisterFacts {
    /// Its key in the table `latency`.
    pub key: &'static str,
    /// The least value of that key with which it exists.
    pub from: u32,
    /// What it stands between.
    pub between: &'static str,
    value: fn(&LatencyConfig) -> u32,
}

macro_rules! facts {
    ($key:ident, $from:literal, $between:literal) => {
        RegisterFacts { key: stringify!($key), from: $from, between: $between, value: |l| l.$key }
    };
}

impl Register {
    /// All of them, by key and value.
    pub const ALL: [Self; 22] = [
        Self::BeforeDecision,
        Self::WindowChoice,
        Self::NodeDistance,
        Self::AfterDecision,
        Self::Neighbour,
        Self::Descent,
        Self::Travel,
        Self::HitOffset,
        Self::HitFraction,
        Self::Bank,
        Self::Height,
        Self::Address,
        Self::ScaledRay,
        Self::Bias,
        Self::ExitPlanes,
        Self::WindowTexel,
        Self::SlotRays,
        Self::SlotRay,
        Self::NodeExtent,
        Self::Parameter,
        Self::BiasStep,
        Self::StartLevel,
    ];

    /// Key, value, and what it stands between. The one place that knows them.
    pub const fn facts(self) -> RegisterFacts {
        match self {
            Self::BeforeDecision => facts!(decision, 2, "what an iteration found and `level_decision`"),
            Self::WindowChoice => facts!(decision, 2, "`window_choice` and `window_advance`"),
            Self::NodeDistance => facts!(decision, 3, "the distance of two nodes and what it says, in `level_up`"),
            Self::AfterDecision => facts!(decision, 4, "`level_decision` and what is written back"),
            Self::Neighbour => facts!(decision, 5, "the two axes and the rule, in `level_up`"),
            Self::Descent => {
                facts!(decision, 5, "comparisons and what they choose, in `multi_level_down` and `block_descent`")
            }
            Self::Travel => facts!(div, 2, "the magnitude of a ray's travel and its reciprocal (windows)"),
            Self::HitOffset => facts!(hit, 1, "difference and clamp, in `hit_position` (watertight)"),
            Self::HitFraction => facts!(hit, 2, "the clamp of `hit_position` and the pipeline's end (watertight)"),
            Self::Bank => facts!(memory, 2, "each bank and the choice of one, in `height_banks`"),
            Self::Height => facts!(memory, 3, "`height_banks` and what reads the height"),
            Self::Address => facts!(memory, 4, "the address and `height_banks`"),
            Self::ScaledRay => facts!(node, 1, "`axis_scale` and what is computed of the scaled ray (watertight)"),
            Self::Bias => facts!(node, 1, "the bias and the sums that it enters, in `axis_slope` (watertight)"),
            Self::ExitPlanes => facts!(node, 1, "`node_planes` or `block_middle` and `plane_time`"),
            Self::WindowTexel => facts!(node, 1, "`window_texel` and `window_address`"),
            Self::SlotRays => facts!(node, 2, "the two rays that a slot may hold and the choice of one"),
            Self::SlotRay => facts!(node, 2, "the slot's ray and its node"),
            Self::NodeExtent => facts!(node, 3, "extent and planes, in `node_planes` and `block_middle`"),
            Self::Parameter => {
                facts!(select, 1, "the choice of a ray parameter, or in fixed point `depth_limit`, and what reads it")
            }
            Self::BiasStep => facts!(setup, 1, "two steps of the bias, in `axis_slope` (watertight)"),
            Self::StartLevel => facts!(setup, 1, "`start_level` and the level of the first iteration (watertight)"),
        }
    }
}

impl LatencyConfig {
    /// Whether a register exists.
    pub fn has(&self, register: Register) -> bool {
        let facts = register.facts();
        (facts.value)(self) >= facts.from
    }
}
