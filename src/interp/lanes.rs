//! Two-valued simulation of many independent copies of a design side by side.
//!
//! Every slot holds one word a lane; an operation is one loop over the lanes, which the compiler vectorizes.
//! Memories are shared by all lanes: what is written must be the same in each.
use super::eval::eval;
use super::netlist::*;
use std::sync::Arc;

/// The state of `lanes` copies of a netlist.
pub struct Lanes<'n> {
    net: &'n Netlist,
    lanes: usize,
    values: Vec<u64>,
    aside: Vec<u64>,
    mems: Vec<Arc<Vec<u64>>>,
}

impl<'n> Lanes<'n> {
    /// `lanes` copies with registers and memories at zero.
    pub fn new(net: &'n Netlist, lanes: usize) -> Self {
        let mut values = vec![0; net.widths.len() * lanes];
        for (s, v) in &net.consts {
            values[*s as usize * lanes..][..lanes].fill(*v);
        }
        let aside = vec![0; net.updates.len() * lanes];
        let mems = net.mems.iter().map(|m| Arc::new(vec![0; m.depth])).collect();
        Self { net, lanes, values, aside, mems }
    }
    /// Number of lanes.
    pub fn lanes(&self) -> usize {
        self.lanes
    }
    /// The words of a slot, one a lane.
    pub fn get(&self, s: Slot) -> &[u64] {
        &self.values[s as usize * self.lanes..][..self.lanes]
    }
    /// The words of an input, to be written.
    pub fn set(&mut self, s: Slot) -> &mut [u64] {
        &mut self.values[s as usize * self.lanes..][..self.lanes]
    }
    /// Puts `words` into memory `index` (a back door; the write port does the same, word by word).
    pub fn load(&mut self, index: usize, words: Arc<Vec<u64>>) {
        assert_eq!(words.len(), self.net.mems[index].depth, "memory image has the memory's depth");
        self.mems[index] = words;
    }

    /// Propagates inputs and registers through the combinational operations.
    pub fn eval(&mut self) {
        let l = self.lanes;
        for (i, op) in self.net.ops.iter().enumerate() {
            let (before, rest) = self.values.split_at_mut((self.net.first_op as usize + i) * l);
            let arg = |k: usize| &before[op.args[k] as usize * l..][..l];
            run(op, arg(0), arg(1), arg(2), &mut rest[..l]);
        }
    }

    /// One rising clock edge (after [`Lanes::eval`]).
    ///
    /// # Panics
    /// If lanes write different things to a memory.
    pub fn clock(&mut self) {
        let l = self.lanes;
        let net = self.net;
        for (k, u) in net.updates.iter().enumerate() {
            match *u {
                Update::Read(i) => {
                    let m = &net.mems[i];
                    let addr = &self.values[m.read_addr as usize * l..][..l];
                    let out = &mut self.aside[k * l..][..l];
                    for (o, a) in out.iter_mut().zip(addr) {
                        *o = self.mems[i].get(*a as usize).copied().unwrap_or(0);
                    }
                }
                Update::RegAside(i) => {
                    let r = net.regs[i];
                    let (q, d) = (r.q as usize * l, r.d as usize * l);
                    for lane in 0..l {
                        self.aside[k * l + lane] = self.next(&r, self.values[q + lane], self.values[d + lane], lane);
                    }
                }
                Update::Reg(_) => {}
            }
        }
        self.write_memories();
        for u in &net.updates {
            if let Update::Reg(i) = *u {
                self.update(&net.regs[i]);
            }
        }
        for (k, u) in net.updates.iter().enumerate() {
            let q = match *u {
                Update::Read(i) => net.mems[i].read_data,
                Update::RegAside(i) => net.regs[i].q,
                Update::Reg(_) => continue,
            };
            self.values[q as usize * l..][..l].copy_from_slice(&self.aside[k * l..][..l]);
        }
    }

    fn next(&self, r: &FlatReg, q: u64, d: u64, lane: usize) -> u64 {
        let on = |s: Option<Slot>, absent: bool| s.map_or(absent, |s| self.values[s as usize * self.lanes + lane] != 0);
        if on(r.reset, false) {
            0
        } else if on(r.enable, true) {
            d
        } else {
            q
        }
    }

    fn update(&mut self, r: &FlatReg) {
        let l = self.lanes;
        let (q, d) = (r.q as usize * l, r.d as usize * l);
        if r.reset.is_none() && r.enable.is_none() {
            self.values.copy_within(d..d + l, q);
            return;
        }
        for lane in 0..l {
            self.values[q + lane] = self.next(r, self.values[q + lane], self.values[d + lane], lane);
        }
    }

    fn write_memories(&mut self) {
        let l = self.lanes;
        for (i, m) in self.net.mems.iter().enumerate() {
            let of = |s: Slot| &self.values[s as usize * l..][..l];
            let en = of(m.write_en);
            if en.iter().all(|e| *e == 0) {
                continue;
            }
            let (addr, data) = (of(m.write_addr), of(m.write_data));
            let same = |v: &[u64]| v.iter().all(|x| *x == v[0]);
            assert!(same(en) && same(addr) && same(data), "lanes share their memories and must write the same");
            let (a, d) = (addr[0] as usize, data[0]);
            if let Some(word) = Arc::make_mut(&mut self.mems[i]).get_mut(a) {
                *word = d;
            }
        }
    }
}

/// One operation over all lanes: `eval` with the kind pulled out of the loop.
fn run(op: &FlatOp, a: &[u64], b: &[u64], c: &[u64], out: &mut [u64]) {
    macro_rules! kinds {
        ($($k:ident),*) => {
            match op.kind {
                $(Kind::$k => {
                    let op = FlatOp { kind: Kind::$k, ..*op };
                    for (o, ((a, b), c)) in out.iter_mut().zip(a.iter().zip(b).zip(c)) {
                        *o = eval(&op, *a, *b, *c);
                    }
                })*
            }
        };
    }
    kinds!(
        Copy, Not, And, Or, Xor, RedOr, RedAnd, Add, Sub, Mul, Eq, Ult, Slt, Shl, Shr, Sar, Mux, Join, Slice, Sext,
        Rep, Lzc, Interleave, DivRem, DivQuot
    );
}
