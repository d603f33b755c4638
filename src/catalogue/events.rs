//! How often the rows of a unit reach what it has to get right, for the description of its vectors.
use super::modelled::Modelled;
use super::row::Context;
use super::table::entry;
use super::unit::Counted;
use crate::config::Design;
use crate::golden::float::{Events, events};
use crate::ir::Module;
use crate::vectors::VectorSet;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Rows of each event that `set` reaches in the unit `m`, by its name, as its entry says what counts; none where nothing does.
pub fn count_events(d: &Design, m: &Module, set: &VectorSet) -> BTreeMap<String, usize> {
    let at = super::design_at(d, &set.params);
    match entry(&at, &m.name).map_or(Counted::Nothing, |u| u.counted) {
        Counted::Nothing => BTreeMap::new(),
        Counted::Rounding { sum } => rounding(&at, m, set, sum),
        Counted::Answers => answers(set),
        Counted::RangeEnds => range_ends(set),
    }
}

fn rounding(at: &Design, m: &Module, set: &VectorSet, sum: bool) -> BTreeMap<String, usize> {
    let float: Vec<bool> = m.data_inputs().map(|(_, p)| p.unit.is_float()).collect();
    let unit = Modelled::of(at, m);
    let of = |x: &Vec<u64>| {
        let op = |format, row: &[u64]| unit.results(&Context::new(Design { format, ..*at }, &set.params), row)[0];
        events(at.format, sum, x, &float, &op)
    };
    let all: Vec<Events> = set.stimulus.par_iter().map(of).collect();
    let count = |event: Events| all.iter().filter(|e| e.has(event)).count();
    reached(Events::ALL.iter().map(|(event, name)| (name.to_string(), count(*event))))
}

fn answers(set: &VectorSet) -> BTreeMap<String, usize> {
    let of = |(k, value): (usize, u64)| {
        let n = set.expected.iter().filter(|r| r[k] == value).count();
        (format!("{} = {value}", set.outputs[k].name), n)
    };
    reached((0..set.outputs.len()).flat_map(|k| [(k, 0), (k, 1)]).map(of))
}

fn range_ends(set: &VectorSet) -> BTreeMap<String, usize> {
    let largest = crate::bits::mask(set.outputs[0].width) >> 1;
    let words = [("largest", largest), ("smallest", largest + 1), ("zero", 0), ("minus one", 2 * largest + 1)];
    reached(words.map(|(name, v)| (name.to_string(), set.expected.iter().filter(|r| r[0] == v).count())).into_iter())
}

fn reached(counts: impl Iterator<Item = (String, usize)>) -> BTreeMap<String, usize> {
    counts.filter(|c| c.1 > 0).collect()
}
