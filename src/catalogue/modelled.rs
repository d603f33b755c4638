//! A unit's hardware beside its entry: the golden model on whole rows.
use super::row::{Context, Row};
use super::table::entry;
use super::unit::{Model, Unit};
use crate::config::Design;
use crate::ir::Module;

/// A unit that has a golden model, with the names of its ports.
pub struct Modelled<'a> {
    unit: &'static Unit,
    model: Model,
    inputs: Vec<&'a str>,
    outputs: Vec<&'a str>,
}

impl<'a> Modelled<'a> {
    /// The unit `m` of a design.
    ///
    /// # Panics
    /// If the unit has no entry, or no model in it: table and hardware went apart.
    pub fn of(d: &Design, m: &'a Module) -> Self {
        let found = entry(d, &m.name).and_then(|u| Some((u, u.model?)));
        let (unit, model) = found.unwrap_or_else(|| panic!("{} has no golden model", m.name));
        let inputs = m.data_inputs().map(|(_, p)| p.name.as_str()).collect();
        let outputs = m.data_outputs().map(|(_, p)| p.name.as_str()).collect();
        Self { unit, model, inputs, outputs }
    }

    /// The row, or one beside it that the unit can get.
    pub fn legal(&self, c: &Context<'_>, inputs: Vec<u64>) -> Vec<u64> {
        let Some(legal) = self.unit.legal else { return inputs };
        let mut row = Row::new(&self.inputs, inputs);
        legal(c, &mut row);
        row.into_words()
    }

    /// Expected outputs for a row of inputs, both in the order of the ports.
    ///
    /// # Panics
    /// If the model asks for a port that the unit has not, or leaves an output out.
    pub fn results(&self, c: &Context<'_>, inputs: &[u64]) -> Vec<u64> {
        let mut out = Row::blank(&self.outputs);
        (self.model)(c, &Row::new(&self.inputs, inputs.to_vec()), &mut out);
        if let Some(port) = out.unwritten().next() {
            panic!("the model of {} says nothing about {port}", self.unit.name);
        }
        out.into_words()
    }
}
