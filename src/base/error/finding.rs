//! What differs, as a sentence and, for machines, as fields.
use serde::Serialize;
use std::fmt;

/// Results that differ.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The whole sentence.
    pub text: String,
    /// Where the first difference is, if it is one of vectors.
    pub place: Option<Box<Place>>,
}

/// The first of a unit's vectors whose result differs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Place {
    /// Unit.
    pub unit: String,
    /// `interp`, `icarus` or `verilator`.
    pub engine: String,
    /// Rows compared.
    pub checked: usize,
    /// Rows that differ.
    pub mismatched: usize,
    /// Row, from 0.
    pub vector: usize,
    /// Output port.
    pub output: String,
    /// Stage at which it leaves, in clocks after the operands; none for a handshaked unit.
    pub stage: Option<u32>,
    /// Expected word, hex.
    pub expected: String,
    /// Word that came, hex.
    pub got: String,
}

impl Finding {
    /// The same, with more to say.
    pub fn and(self, more: impl fmt::Display) -> Self {
        Self { text: format!("{}; {more}", self.text), ..self }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
