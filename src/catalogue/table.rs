//! The table of units: every entry, and the entries of a design.
use super::entries;
use super::unit::Unit;
use crate::config::{Design, Timed};
use crate::ir::Module;
use crate::proofs::Proof;
use std::sync::Arc;

/// Every unit that a design may have, by area; proofs are listed in this order.
pub static UNITS: [&[&Unit]; 10] = [
    entries::integer::UNITS,
    entries::traversal::UNITS,
    entries::float::UNITS,
    entries::watertight::UNITS,
    entries::fixed::UNITS,
    entries::windows::UNITS,
    entries::cells::UNITS,
    entries::published::UNITS,
    entries::bilinear::UNITS,
    entries::stream::UNITS,
];

/// Every entry, in the order of [`UNITS`].
pub fn unit_entries() -> impl Iterator<Item = &'static Unit> {
    UNITS.iter().flat_map(|area| area.iter().copied())
}

/// Every unit of arithmetic with the latency that is its own.
pub fn timed() -> Vec<Timed> {
    unit_entries().filter_map(|u| u.clock.map(|(key, part)| Timed { unit: u.name, key, part })).collect()
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
