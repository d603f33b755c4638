//! A set of vectors in memory.
use super::campaign::Campaign;
use crate::ir::Binding;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A column of words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// Port name.
    pub name: String,
    /// Bits, 1 to 64.
    pub width: u32,
}

/// How the rows came about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// Rows from tables of corner cases crossed with each other.
    pub corners: usize,
    /// Weighted random rows.
    pub random: usize,
    /// Rows that a traced ray could bring to the unit.
    #[serde(default)]
    pub rays: usize,
    /// Rows that were found to tell the unit from one with a slip in it.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub found: usize,
    /// Every input once (then the others are 0).
    pub exhaustive: usize,
}

/// Iterations of the rays of a set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Iterations {
    /// Those of the longest ray.
    pub most: u32,
    /// Those of all rays together, modulo 2^32, as a bench counts.
    pub sum: u32,
}

/// Stimulus and expected results of one unit at one set of parameter values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct VectorSet {
    /// Unit, as the emitted module is named.
    pub unit: String,
    /// Parameter values.
    pub params: Binding,
    /// Seed of the random rows (ChaCha8).
    pub seed: u64,
    /// How the rows came about.
    pub counts: Counts,
    /// The tables that were crossed whole, and the part of all rows that this is; `None` for a choice of corners.
    pub campaign: Option<Campaign>,
    /// The corner rows are planned rays, each whole, and no corners of words.
    pub planned: bool,
    /// Rows that reach each event of the operation, by its name; empty where none was counted.
    pub events: BTreeMap<String, usize>,
    /// Iterations of rays whose hits do not say them; a bench needs them to tell a lost ray from a long one.
    pub iterations: Option<Iterations>,
    /// Input columns, in port order.
    pub inputs: Vec<Column>,
    /// Output columns, in port order.
    pub outputs: Vec<Column>,
    /// Inputs of each row.
    pub stimulus: Vec<Vec<u64>>,
    /// Expected outputs of each row.
    pub expected: Vec<Vec<u64>>,
}

fn is_zero(n: &usize) -> bool {
    *n == 0
}

impl Counts {
    /// Rows in all.
    pub const fn total(&self) -> usize {
        self.corners + self.random + self.rays + self.found + self.exhaustive
    }
}

impl VectorSet {
    /// blake3 of columns, rows and iterations, in hex: what the description pins.
    pub fn hash(&self) -> String {
        let mut h = blake3::Hasher::new();
        for c in self.inputs.iter().chain(&self.outputs) {
            h.update(format!("{} {}\n", c.name, c.width).as_bytes());
        }
        for row in self.stimulus.iter().chain(&self.expected) {
            for v in row {
                h.update(&v.to_le_bytes());
            }
        }
        if let Some(Iterations { most, sum }) = self.iterations {
            h.update(format!("iterations {most} {sum}\n").as_bytes());
        }
        h.finalize().to_hex().to_string()
    }
}
