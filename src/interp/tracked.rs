//! One copy of a design with undefined values tracked bit by bit: power-up state, memory that was never written.
//!
//! A slot is a value and a mask of unknown bits (which read 0 in the value). What known bits compute to comes from the same
//! `eval` as everywhere.
use super::eval::eval;
use super::netlist::*;
use reliefrtl_base::bits::mask;

/// A value and its unknown bits.
pub type Bits = (u64, u64);

/// The state of one copy.
pub struct Tracked<'n> {
    net: &'n Netlist,
    values: Vec<Bits>,
    mems: Vec<Vec<Bits>>,
}

impl<'n> Tracked<'n> {
    /// Power-up: registers, memories and inputs unknown.
    pub fn new(net: &'n Netlist) -> Self {
        let mut values: Vec<Bits> = net.widths.iter().map(|w| (0, mask(*w))).collect();
        net.consts.iter().for_each(|(s, v)| values[*s as usize] = (*v, 0));
        let unknown = |m: &FlatMem| (0, mask(net.widths[m.read_data as usize]));
        let mems = net.mems.iter().map(|m| vec![unknown(m); m.depth]).collect();
        Self { net, values, mems }
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
        self.mems[index].iter_mut().zip(words).for_each(|(m, w)| *m = (*w, 0));
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
            // Where the address is unknown, every word may have been written.
            let words = match at {
                (a, 0) => self.mems[i].get_mut(a as usize).map(std::slice::from_mut).unwrap_or_default(),
                _ => &mut self.mems[i][..],
            };
            match en {
                (0, 0) => {}
                (1, 0) if at.1 == 0 => words.fill(data),
                _ => words.iter_mut().for_each(|w| *w = either(*w, data)),
            }
        }
        self.net.regs.iter().zip(next).for_each(|(r, v)| self.values[r.q as usize] = v);
        self.net.mems.iter().zip(reads).for_each(|(m, v)| self.values[m.read_data as usize] = v);
    }
    fn next(&self, r: &FlatReg) -> Bits {
        let of = |s: Slot| self.values[s as usize];
        let d = match (of(r.d), r.unknown) {
            ((_, 1), Some(as_known)) => (u64::from(as_known), 0),
            (d, _) => d,
        };
        let q = of(r.q);
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
    /// A read outside the memory gives unknown bits, as in Verilog.
    fn read(&self, index: usize, m: &FlatMem) -> Bits {
        let unknown = (0, mask(self.net.widths[m.read_data as usize]));
        match self.values[m.read_addr as usize] {
            (a, 0) => self.mems[index].get(a as usize).copied().unwrap_or(unknown),
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
    // The largest values that the operands can have; the smallest ones have 0 for each unknown bit.
    let (top_a, top_b) = (a.0 | a.1, b.0 | b.1);
    let x = match op.kind {
        // These move bits: unknown ones go where their values go.
        Kind::Copy | Kind::Slice | Kind::Sext | Kind::Rep => eval(op, a.1, 0, 0),
        Kind::Join | Kind::Interleave => eval(op, a.1, b.1, 0),
        Kind::Shl | Kind::Shr | Kind::Sar if b.1 == 0 => eval(op, a.1, b.0, 0),
        Kind::Shl | Kind::Shr | Kind::Sar if top_a == 0 => 0,
        Kind::Not => a.1,
        Kind::And => (a.1 | b.1) & top_a & top_b,
        Kind::Or => (a.1 | b.1) & !a.0 & !b.0,
        Kind::Xor => a.1 | b.1,
        Kind::Mux => match a {
            (_, 0) => return if a.0 == 1 { b } else { c },
            _ => return either(b, c),
        },
        // Where the extreme operands give the same, all between them do.
        Kind::RedOr | Kind::RedAnd => v ^ eval(op, top_a, 0, 0),
        Kind::Ult => eval(op, top_a, b.0, 0) ^ eval(op, a.0, top_b, 0),
        Kind::Slt => {
            let sign = 1 << (op.arg_width - 1);
            let (low, high) = (|v: Bits| v.0 | (v.1 & sign), |v: Bits| v.0 | (v.1 & !sign));
            let (least, most) = (eval(op, high(a), low(b), 0), eval(op, low(a), high(b), 0));
            return (least, least ^ most);
        }
        Kind::Lzc => {
            let (most, least) = (v, eval(op, top_a, 0, 0));
            below(most ^ least)
        }
        Kind::Eq => u64::from((a.1 | b.1) != 0 && (a.0 ^ b.0) & !(a.1 | b.1) == 0),
        // A carry runs up from the lowest unknown bit.
        Kind::Add | Kind::Sub => from_lowest(a.1 | b.1),
        Kind::Mul => from_lowest(a.1 | b.1) & below(eval(op, top_a, top_b, 0)),
        Kind::DivRem | Kind::DivQuot if a.1 | b.1 == 0 => 0,
        Kind::RecipTable if a.1 == 0 => 0,
        Kind::Shl | Kind::Shr | Kind::Sar | Kind::DivRem | Kind::DivQuot | Kind::RecipTable => m,
    };
    let x = x & m;
    (v & !x, x)
}

/// Ones from the lowest 1 up.
fn from_lowest(x: u64) -> u64 {
    x | x.wrapping_neg()
}

/// Ones from the highest 1 down.
fn below(x: u64) -> u64 {
    mask(64 - x.leading_zeros())
}
