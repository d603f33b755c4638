//! An entry of the table of units: all that the project knows of a unit besides its hardware.
//!
//! The builder is no field of it: which modules a design has follows from the design (the parts of its datapath, its modes, its latencies), and a
//! module brings those that it instantiates; `units::all` says so where they are built. A field here would say it a second time, and `units`
//! could no longer stand below this table. The two are held together by tests: every module of every design has one entry, and every entry a module
//! (`tests/repo/units.rs`).
use super::clocked::Clocked;
use super::ray_stimulus::sample::RaySample;
use super::row::{Context, Row};
use crate::config::{DatapathKind, Part};
use crate::proofs::Proof;

/// Writes the expected word of every output for a row of inputs.
pub type Model = fn(&Context<'_>, &Row<'_>, &mut Row<'_>);
/// Changes a row into one that the unit can get: levels that exist, divisors that are normalized.
pub type Legal = fn(&Context<'_>, &mut Row<'_>);
/// The word of a port when a sampled ray comes by; `None`: no ray decides it.
pub type Stimulus = fn(&RaySample, &str) -> Option<u64>;

/// What is counted over the rows of a unit, for the description of its vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counted {
    /// Nothing.
    Nothing,
    /// Events of rounding: the one output is a rounded number.
    Rounding {
        /// Whether the exact result is a sum.
        sum: bool,
    },
    /// How often each answer of the outputs, of one bit each, comes.
    Answers,
    /// How often the one output, a signed word, is at an end of its range, zero or minus one.
    RangeEnds,
}

/// A unit. Its hardware stands in `units`, where its builder gives a module of this name.
#[derive(Debug)]
pub struct Unit {
    /// Name of the module.
    pub name: &'static str,
    /// The datapath whose unit it is, where units of one name differ or the other datapaths have none; `None`: of any.
    pub datapath: Option<DatapathKind>,
    /// Of a unit of arithmetic its key in the table `latency`, and what its clock counts for.
    pub clock: Option<(&'static str, Part)>,
    /// The golden model; `None`: rays through `traverse` are the unit's vectors, or it has a proof alone.
    pub model: Option<Model>,
    /// The golden model of a unit with a state: its rows are clocks.
    pub clocked: Option<Clocked>,
    /// Its vectors are rays through the whole traversal.
    pub takes_rays: bool,
    /// Legal operands; `None`: all are.
    pub legal: Option<Legal>,
    /// What a ray brings to the inputs; `None`: the unit gets no rows of rays.
    pub stimulus: Option<Stimulus>,
    /// Parameter values at which vectors are checked, besides the defaults and those that all units of a parameter's name have.
    pub bindings: &'static [&'static [(&'static str, i64)]],
    /// What is counted over its rows.
    pub counted: Counted,
    /// What is proved of it.
    pub proofs: &'static [Proof],
}

/// A unit of which only the name is said.
pub(super) const UNIT: Unit = Unit {
    name: "",
    datapath: None,
    clock: None,
    model: None,
    clocked: None,
    takes_rays: false,
    legal: None,
    stimulus: None,
    bindings: &[],
    counted: Counted::Nothing,
    proofs: &[],
};
