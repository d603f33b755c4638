//! One copy of a design with undefined values tracked bit by bit: power-up state, memory that nobody wrote.
//!
//! A slot is a value and a mask of unknown bits (which read 0 in the value). What known bits compute to comes from the same
//! `eval` as everywhere.
use super::eval::eval;
use super::netlist::*;
use crate::bits::mask;

/// A value and its unknown bits.
pub type Bits = (u64, u64);

/// The state of one copy.
pub struct Tracked<'n> {
    net: &'n Netlist,
    values: Vec<Bits>,
    mems: Vec<Vec<Option<u64>>>,
}

impl<'n> Tracked<'n> {
    /// Power-up: registers, memories and inputs unknown.
    pub fn new(net: &'n Netlist) -> Self {
        let mut values: Vec<Bits> = net.widths.iter().map(|w| (0, mask(*w))).collect();
        net.consts.iter().for_each(|(s, v)| values[*s as usize] = (*v, 0));
        Self { net, values, mems: net.mems.iter().map(|m| vec![None; m.depth]).collect() }
    }
    /// Value and unknown bits of a slot.
    pub fn get(&self, s: Slot) -> Bits {
        self.values[s as usize]
    }
    /// Sets an input to a known value.
    pub fn set(&mut self, s: Slot, v: u64) {
        self.values[s as usize] = (v, 0);
    }
    /// Sets an input to a partly unknown value.
    pub fn set_bits(&mut self, s: Slot, v: Bits) {
        self.values[s as usize] = v;
    }
    /// Fills memory `index`.
    pub fn load(&mut self, index: usize, words: &[u64]) {
        self.mems[index].iter_mut().zip(words).for_each(|(m, w)| *m = Some(*w));
    }
    /// Propagates inputs and registers.
    pub fn eval(&mut self) {
        for (i, op) in self.net.ops.iter().enumerate() {
            let [a, b, c] = op.args.map(|s| self.values[s as usize]);
            self.values[self.net.first_op as usize + i] = apply(op, a, b, c);
        }
    }
    /// One rising clock edge.
    pub fn clock(&mut self) {
        let next: Vec<Bits> = self.net.regs.iter().map(|r| self.next(r)).collect();
        let reads: Vec<Bits> = self.net.mems.iter().enumerate().map(|(i, m)| self.read(i, m)).collect();
        for (i, m) in self.net.mems.iter().enumerate() {
            let [en, at, data] = [m.write_en, m.write_addr, m.write_data].map(|s| self.values[s as usize]);
            match (en, at) {
                ((0, 0), _) => {}
                ((1, 0), (a, 0)) => {
                    if let Some(w) = self.mems[i].get_mut(a as usize) {
                        *w = (data.1 == 0).then_some(data.0);
                    }
                }
                // Perhaps a write, or a write somewhere: nothing is known any more.
                _ => self.mems[i].fill(None),
            }
        }
        self.net.regs.iter().zip(next).for_each(|(r, v)| self.values[r.q as usize] = v);
        self.net.mems.iter().zip(reads).for_each(|(m, v)| self.values[m.read_data as usize] = v);
    }
    fn next(&self, r: &FlatReg) -> Bits {
        let of = |s: Slot| self.values[s as usize];
        let (q, d) = (of(r.q), of(r.d));
        let held = match r.enable.map(of) {
            None | Some((1, 0)) => d,
            Some((0, 0)) => q,
            Some(_) => either(d, q),
        };
        match r.reset.map(of) {
            None | Some((0, 0)) => held,
            Some((1, 0)) => (0, 0),
            Some(_) => either(held, (0, 0)),
        }
    }
    fn read(&self, index: usize, m: &FlatMem) -> Bits {
        let unknown = (0, mask(self.net.widths[m.read_data as usize]));
        match self.values[m.read_addr as usize] {
            (a, 0) => self.mems[index].get(a as usize).copied().flatten().map_or(unknown, |w| (w, 0)),
            _ => unknown,
        }
    }
}

/// One of two values: bits on which they agree stay known.
fn either(a: Bits, b: Bits) -> Bits {
    let x = a.1 | b.1 | (a.0 ^ b.0);
    (a.0 & !x, x)
}

/// An operation on partly unknown operands.
fn apply(op: &FlatOp, a: Bits, b: Bits, c: Bits) -> Bits {
    let v = eval(op, a.0, b.0, c.0);
    let m = mask(op.width);
    let x = match op.kind {
        Kind::Copy | Kind::Not => a.1,
        Kind::Slice | Kind::Sext | Kind::Rep => eval(op, a.1, 0, 0),
        Kind::Join => eval(op, a.1, b.1, 0),
        Kind::And => (a.1 | b.1) & (a.0 | a.1) & (b.0 | b.1),
        Kind::Or => (a.1 | b.1) & !a.0 & !b.0,
        Kind::Xor => a.1 | b.1,
        Kind::Mux => match a {
            (_, 0) => return if a.0 == 1 { b } else { c },
            _ => return either(b, c),
        },
        Kind::RedOr => u64::from(a.0 == 0 && a.1 != 0),
        Kind::RedAnd => u64::from(a.1 != 0 && (a.0 | a.1) == mask(op.arg_width)),
        Kind::Eq => u64::from((a.1 | b.1) != 0 && (a.0 ^ b.0) & !(a.1 | b.1) == 0),
        Kind::Add | Kind::Sub | Kind::Mul => {
            let low = (a.1 | b.1).trailing_zeros();
            if low >= 64 { 0 } else { m & !mask(low) }
        }
        _ if a.1 | b.1 == 0 => 0,
        _ => m,
    };
    let x = x & m;
    (v & !x, x)
}
