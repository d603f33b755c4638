//! The table of units: all that the project knows of a unit besides its hardware, in one entry.
use super::entries;
use super::ray_stimulus::RaySample;
use super::row::{Context, Row};
use crate::config::{DatapathKind, Design};
use crate::ir::Module;
use crate::proofs::Proof;
use std::sync::Arc;

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
    /// The golden model; `None`: rays through `traverse` are the unit's vectors, or it has a proof alone.
    pub model: Option<Model>,
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
    model: None,
    legal: None,
    stimulus: None,
    bindings: &[],
    counted: Counted::Nothing,
    proofs: &[],
};

/// Every unit that a design may have, by area; proofs are listed in this order.
pub static UNITS: [&[&Unit]; 8] = [
    entries::integer::UNITS,
    entries::traversal::UNITS,
    entries::float::UNITS,
    entries::watertight::UNITS,
    entries::fixed::UNITS,
    entries::published::UNITS,
    entries::bilinear::UNITS,
    entries::stream::UNITS,
];

/// Every entry, in the order of [`UNITS`].
pub fn unit_entries() -> impl Iterator<Item = &'static Unit> {
    UNITS.iter().flat_map(|area| area.iter().copied())
}

/// The entry of the unit `name` of a design.
pub fn entry(d: &Design, name: &str) -> Option<&'static Unit> {
    unit_entries().find(|u| u.name == name && u.datapath.is_none_or(|kind| kind == d.datapath.kind))
}

/// The proofs that a design has; those of what stands inside of a unit are among them.
pub fn proofs(units: &[Arc<Module>]) -> Vec<&'static Proof> {
    let all: Vec<Arc<Module>> = units.iter().flat_map(|m| m.hierarchy()).collect();
    let has = |name: &&str| all.iter().any(|m| m.name == **name);
    unit_entries().flat_map(|u| u.proofs).filter(|p| p.units.iter().all(&has)).collect()
}
