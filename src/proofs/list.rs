//! Which proofs there are.
use crate::ir::Module;
use std::sync::Arc;

/// What a proof is about.
#[derive(Clone, Copy, Debug)]
pub struct Proof {
    /// Its name; the harness is `<prefix>fv_<name>.v`, the script `<prefix>fv_<name>.sby`.
    pub name: &'static str,
    /// Units that must be part of the design.
    pub units: &'static [&'static str],
    /// What is proved, in a sentence.
    pub claim: &'static str,
    pub(super) text: &'static str,
    /// The solver: `smtbmc z3` names the assertion that fails, `abc bmc3` ends where the bits are many.
    pub(super) engine: &'static str,
    /// Parameter values other than the defaults.
    pub(super) over: &'static [(&'static str, i64)],
    /// The units stand behind each other: the claim is about what leaves after all their clocks, not after those of the first.
    chained: bool,
    /// How far the solver goes.
    pub(super) reach: Reach,
    /// Wires of the harness and the registers of the unit that the script connects them to.
    pub(super) peeks: &'static [(&'static str, &'static str)],
}

/// How far a solver goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reach {
    /// Until the unit's outputs are those of its inputs, which stand still: for good.
    Latency,
    /// That many clocks from the beginning.
    Clocks(u32),
    /// By induction over that many clocks: for good.
    Induction(u32),
}

macro_rules! proof {
    ($name:literal, $units:expr, $claim:literal) => {
        proof!($name, $units, $claim, &[], false)
    };
    ($name:literal, $units:expr, $claim:literal, $over:expr) => {
        proof!($name, $units, $claim, $over, true)
    };
    ($name:literal, $units:expr, $claim:literal, $over:expr, $abc:expr) => {
        Proof {
            name: $name,
            units: $units,
            claim: $claim,
            text: include_str!(concat!("templates/fv_", $name, ".v")),
            engine: if $abc { "abc bmc3" } else { "smtbmc z3" },
            over: $over,
            chained: false,
            reach: Reach::Latency,
            peeks: &[],
        }
    };
}

impl Proof {
    const fn chained(self) -> Self {
        Self { chained: true, ..self }
    }
    const fn reaching(self, reach: Reach, peeks: &'static [(&'static str, &'static str)]) -> Self {
        Self { reach, peeks, ..self }
    }

    /// Clocks after which the outputs are those of the inputs.
    pub(super) fn clocks(&self, units: &[Arc<Module>]) -> u32 {
        let of = |name: &&str| units.iter().find(|m| m.name == **name).and_then(|m| m.latency).unwrap_or(0);
        if self.chained { self.units.iter().map(of).sum() } else { of(&self.units[0]) }
    }
}

/// Formats at which a solver compares whole arithmetic units.
const SMALL: &[(&str, i64)] = &[("EXP_W", 4), ("MAN_W", 3)];
/// A format at which two chains of an adder and a multiplier are compared.
const TINY: &[(&str, i64)] = &[("EXP_W", 4), ("MAN_W", 2), ("IDX_W", 5)];

/// The narrowest words of the fixed-point datapath, and a map whose texels are their units.
const NARROW: &[(&str, i64)] = &[("FRACTION_W", 8), ("RECIP_W", 8), ("LEVELS", 8), ("HEIGHT_W", 2), ("TILE_W", 1)];

const ALL: &[Proof] = &[
    proof!("lzc", &["lzc"], "zeros above the count, a one below it, at every width from 1 to 64", &[]),
    proof!("interleave", &["interleave"], "bits go where Morton order puts them, at every width from 1 to 32"),
    proof!("start_level", &["start_level"], "the lowest level whose node holds both ends of the ray"),
    proof!("height_address", &["height_address"], "inside the memory, and no two nodes share a word"),
    proof!("node_planes", &["node_planes"], "extent, exit plane and the texel behind it are those of the node"),
    proof!(
        "multi_level_down",
        &["multi_level_down"],
        "a descent goes at least one level down, stays in its bounds, and obeys the mode"
    ),
    proof!("level_up", &["level_up"], "the rule, and never above the root"),
    proof!("level_decision", &["level_decision"], "hit, descent or crossing: every output is that of the case", &[]),
    proof!(
        "progress",
        &["node_planes", "multi_level_down", "level_decision"],
        "a crossing moves the integer index forward, a descent never back: no ray visits a texel again"
    )
    .chained(),
    proof!("fp_lt", &["fp_lt"], "the order of the numbers, at full width"),
    proof!("fp_add", &["fp_add"], "the exact sum, rounded once (4/3)", SMALL),
    proof!("fp_mul", &["fp_mul"], "the exact product, rounded once (4/3)", SMALL),
    proof!("plane_time", &["plane_time", "fp_mul"], "a later plane never has a smaller parameter (4/2)", TINY),
    proof!(
        "fixed_plane_time",
        &["plane_time", "reciprocal"],
        "the product of distance and slope, rounded down, or all ones: monotone in the plane (8/8)",
        NARROW
    ),
    proof!(
        "fixed_predicted_hit",
        &["ray_setup", "plane_time", "predicted_hit", "reciprocal"],
        "an estimate passes no plane before its parameter (8/8)",
        NARROW
    )
    .chained(),
    proof!(
        "fixed_chord_end",
        &["ray_setup", "plane_time", "chord_end", "reciprocal"],
        "a chord ends behind every plane that is met by its parameter, and so does the ray at the bottom plane (8/8)",
        NARROW
    )
    .chained(),
    proof!(
        "delay_line",
        &["delay_line"],
        "what as many registers in a row do, at every length, held and moving, for 40 clocks",
        &[]
    )
    .reaching(Reach::Clocks(40), &[]),
    proof!(
        "stream_skid",
        &["stream_skid", "word_skid"],
        "words leave in the order in which they come, none lost and none twice, and an offered one stays, by induction"
    )
    .reaching(
        Reach::Induction(10),
        &[
            ("first_valid", "dut.first_valid"),
            ("second_valid", "dut.second_valid"),
            ("some_valid", "dut.some_valid"),
            ("writes_second", "dut.writes_second"),
            ("reads_second", "dut.reads_second"),
            ("awake", "dut.awake"),
            ("first_word", "word.first"),
            ("second_word", "word.second"),
        ],
    ),
    proof!(
        "stream_queue",
        &["stream_queue", "word_queue"],
        "places are filled and read in turn, none that is taken is written, and an offered word stays, behind a pipeline of any length, by induction"
    )
    .reaching(
        Reach::Induction(24),
        &[
            ("taken", "dut.taken"),
            ("held", "dut.held"),
            ("has_room", "dut.has_room"),
            ("has_set_out", "dut.has_set_out"),
            ("has_gone", "dut.has_gone"),
            ("is_offered", "dut.is_offered"),
        ],
    ),
    proof!("traverse", &["traverse"], "no ray is lost, none comes twice, and an offered result stays, by induction"),
];

/// The proofs that a design has; those of what stands inside of a unit are among them.
pub fn proofs(units: &[Arc<Module>]) -> Vec<&'static Proof> {
    let all: Vec<Arc<Module>> = units.iter().flat_map(|m| m.hierarchy()).collect();
    let has = |name: &&str| all.iter().any(|m| m.name == **name);
    ALL.iter().filter(|p| p.units.iter().all(&has)).collect()
}
