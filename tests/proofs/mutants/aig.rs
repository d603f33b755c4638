//! And-inverter graphs, as equivalence checkers read them.
use std::collections::HashMap;

/// A node's number times two, plus one where it is inverted; [`FALSE`] and [`TRUE`] are constants.
pub type Lit = u32;
pub const FALSE: Lit = 0;
pub const TRUE: Lit = 1;

/// A graph: inputs first, then ANDs, each of two earlier literals; no AND stands twice.
pub struct Aig {
    inputs: u32,
    ands: Vec<(Lit, Lit)>,
    known: HashMap<(Lit, Lit), Lit>,
}

impl Aig {
    /// A graph of this many inputs and nothing else.
    pub fn new(inputs: u32) -> Self {
        Self { inputs, ands: Vec::new(), known: HashMap::new() }
    }

    /// Input `k`, from 0.
    pub fn input(&self, k: u32) -> Lit {
        assert!(k < self.inputs);
        2 * (k + 1)
    }

    pub fn and(&mut self, a: Lit, b: Lit) -> Lit {
        let (a, b) = (a.max(b), a.min(b));
        match (a, b) {
            (_, FALSE) => FALSE,
            (a, TRUE) => a,
            (a, b) if a == b => a,
            (a, b) if a == b ^ 1 => FALSE,
            pair => *self.known.entry(pair).or_insert_with(|| {
                self.ands.push(pair);
                2 * (self.inputs + self.ands.len() as u32)
            }),
        }
    }

    pub fn or(&mut self, a: Lit, b: Lit) -> Lit {
        self.and(a ^ 1, b ^ 1) ^ 1
    }

    pub fn mux(&mut self, c: Lit, a: Lit, b: Lit) -> Lit {
        let (yes, no) = (self.and(c, a), self.and(c ^ 1, b));
        self.or(yes, no)
    }

    pub fn xor(&mut self, a: Lit, b: Lit) -> Lit {
        self.mux(a, b ^ 1, b)
    }

    /// Sum bit and carry.
    pub fn add(&mut self, a: Lit, b: Lit, c: Lit) -> (Lit, Lit) {
        let half = self.xor(a, b);
        let both = self.and(a, b);
        let through = self.and(half, c);
        (self.xor(half, c), self.or(both, through))
    }

    /// The value of a literal at these inputs.
    pub fn value(&self, lit: Lit, inputs: &[bool]) -> bool {
        assert_eq!(inputs.len(), self.inputs as usize);
        let mut nodes = vec![false];
        nodes.extend_from_slice(inputs);
        let of = |nodes: &[bool], l: Lit| nodes[l as usize / 2] ^ (l % 2 == 1);
        for (a, b) in &self.ands {
            nodes.push(of(&nodes, *a) && of(&nodes, *b));
        }
        of(&nodes, lit)
    }

    /// The graph with these outputs in the binary AIGER format.
    pub fn aiger(&self, outputs: &[Lit]) -> Vec<u8> {
        let nodes = self.inputs + self.ands.len() as u32;
        let mut text = format!("aig {nodes} {} 0 {} {}\n", self.inputs, outputs.len(), self.ands.len()).into_bytes();
        outputs.iter().for_each(|o| text.extend(format!("{o}\n").into_bytes()));
        for (k, (a, b)) in self.ands.iter().enumerate() {
            for mut delta in [2 * (self.inputs + 1 + k as u32) - a, a - b] {
                while delta > 0x7f {
                    text.push(delta as u8 | 0x80);
                    delta >>= 7;
                }
                text.push(delta as u8);
            }
        }
        text
    }
}
