//! One row of words by port name, and what a model is told besides it.
use crate::bits::{mask, signed};
use crate::config::Design;
use crate::ir::Binding;
use std::ops::{Index, IndexMut};

/// A word for each of a unit's data ports of one direction, by the ports' names. A word has the bits of its port, signed or not.
///
/// # Panics
/// `row["x"]` panics if the unit has no port `x`: entry and hardware went apart.
#[derive(Clone, Debug)]
pub struct Row<'a> {
    ports: &'a [&'a str],
    words: Vec<u64>,
    /// Bit k: port k was written.
    written: u64,
}

impl<'a> Row<'a> {
    /// A row of these words, in the order of the ports.
    ///
    /// # Panics
    /// If there are not as many words as ports, or more than 64.
    pub fn new(ports: &'a [&'a str], words: Vec<u64>) -> Self {
        assert!(words.len() == ports.len() && ports.len() <= 64, "{} words for {ports:?}", words.len());
        Self { ports, words, written: 0 }
    }

    /// A row of zeros, not yet written.
    pub fn blank(ports: &'a [&'a str]) -> Self {
        Self::new(ports, vec![0; ports.len()])
    }

    fn position(&self, port: &str) -> Option<usize> {
        self.ports.iter().position(|p| *p == port)
    }

    fn slot(&self, port: &str) -> usize {
        self.position(port).unwrap_or_else(|| panic!("no port is named {port}; there are {}", self.ports.join(", ")))
    }

    /// The word of a port that only some modes have.
    pub fn get(&self, port: &str) -> Option<u64> {
        self.position(port).map(|k| self.words[k])
    }

    /// Whether a 1 stands at a port of one bit; false where the unit has no such port.
    pub fn is_set(&self, port: &str) -> bool {
        self.get(port) == Some(1)
    }

    /// Writes a port that only some modes have.
    pub fn set(&mut self, port: &str, word: u64) {
        if self.position(port).is_some() {
            self[port] = word;
        }
    }

    /// Changes the word of a port that only some modes have.
    pub fn map(&mut self, port: &str, change: impl FnOnce(u64) -> u64) {
        if let Some(word) = self.get(port) {
            self[port] = change(word);
        }
    }

    /// Writes the same word to every port.
    pub fn fill(&mut self, word: u64) {
        self.ports.iter().for_each(|p| self[*p] = word);
    }

    /// Ports that are not yet written.
    pub fn unwritten(&self) -> impl Iterator<Item = &'a str> {
        self.ports.iter().enumerate().filter(|(k, _)| self.written >> k & 1 == 0).map(|(_, p)| *p)
    }

    /// The words, in the order of the ports.
    pub fn words(&self) -> &[u64] {
        &self.words
    }

    /// As [`words`](Self::words).
    pub fn into_words(self) -> Vec<u64> {
        self.words
    }
}

impl Index<&str> for Row<'_> {
    type Output = u64;
    fn index(&self, port: &str) -> &u64 {
        &self.words[self.slot(port)]
    }
}

impl IndexMut<&str> for Row<'_> {
    fn index_mut(&mut self, port: &str) -> &mut u64 {
        let slot = self.slot(port);
        self.written |= 1 << slot;
        &mut self.words[slot]
    }
}

/// What a model is told besides the row.
#[derive(Clone, Copy, Debug)]
pub struct Context<'a> {
    /// The design, at the parameter values.
    pub design: Design,
    /// The parameter values.
    pub binding: &'a Binding,
    /// IDX_W: bits of a signed texel coordinate.
    pub idx_w: u32,
}

impl<'a> Context<'a> {
    /// `design` is that of the parameter values `binding`.
    pub fn new(design: Design, binding: &'a Binding) -> Self {
        let idx_w = binding.get("IDX_W").map_or(design.traverse.idx_bits(), |v| *v as u32);
        Self { design, binding, idx_w }
    }

    /// A parameter's value.
    ///
    /// # Panics
    /// If the unit has no such parameter.
    pub fn param(&self, name: &str) -> u32 {
        self.binding[name] as u32
    }

    /// The coordinate that a word of IDX_W bits says.
    pub const fn signed(&self, word: u64) -> i64 {
        signed(word, self.idx_w)
    }

    /// The word of IDX_W bits of a coordinate.
    pub const fn index(&self, coordinate: i64) -> u64 {
        coordinate as u64 & mask(self.idx_w)
    }

    /// Levels of the pyramid above the texels.
    pub const fn levels(&self) -> u64 {
        self.design.traverse.levels as u64
    }

    /// The word of a level, cut to the bits that a level has.
    pub const fn level(&self, level: u64) -> u64 {
        level & mask((self.design.traverse.levels + 1).next_power_of_two().trailing_zeros())
    }
}
