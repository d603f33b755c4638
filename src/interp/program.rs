//! A netlist laid out for execution: every slot gets a row of narrow or wide words, every operation its loop.
use super::kernel::{BLOCK, Narrow, Wide, cut, divide, narrow, next, wide, widen};
use super::netlist::*;
use std::collections::HashMap;

/// Where a slot's words stand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Row {
    /// In [`Block::narrow`].
    Narrow(u32),
    /// In [`Block::wide`].
    Wide(u32),
}

/// One step of [`Program::eval`]; rows of operands stand before rows of results.
enum Step {
    /// All words are narrow.
    Narrow { op: FlatOp, out: u32, args: [u32; 3] },
    /// Remainder and quotient of narrow words at once.
    Divide { op: FlatOp, rem: u32, quot: u32, args: [u32; 2] },
    /// All words are wide.
    Wide { op: FlatOp, out: u32, args: [u32; 3] },
    /// Some of each.
    Mixed { op: FlatOp, out: Row, args: [Row; 3], count: usize },
}

/// A register: rows of one kind, control always narrow.
#[derive(Clone, Copy)]
struct Update {
    q: Row,
    d: Row,
    enable: Option<u32>,
    reset: Option<u32>,
}

/// The layout and the steps.
pub(super) struct Program {
    rows: Vec<Row>,
    sizes: (u32, u32),
    consts: Vec<(Row, u64)>,
    steps: Vec<Step>,
    /// Values that are kept aside before anything is written, and where they go afterwards.
    aside: Vec<(Update, Row)>,
    updates: Vec<Update>,
    /// Index of each memory, its read address, the row for the word aside, the row of the word.
    pub reads: Vec<(usize, Row, Row, Row)>,
}

/// Registers in an order in which none is written before all have read it, and those that stand in rings.
fn order(regs: &[Update]) -> (Vec<usize>, Vec<usize>) {
    let owner: HashMap<Row, usize> = regs.iter().enumerate().map(|(i, r)| (r.q, i)).collect();
    let reads = |i: usize| {
        let r = &regs[i];
        let rows = [Some(r.d), r.enable.map(Row::Narrow), r.reset.map(Row::Narrow)];
        rows.into_iter().flatten().filter_map(|row| owner.get(&row).copied()).filter(move |o| *o != i)
    };
    let mut readers = vec![0usize; regs.len()];
    (0..regs.len()).for_each(|i| reads(i).for_each(|o| readers[o] += 1));
    let mut ready: Vec<usize> = (0..regs.len()).filter(|i| readers[*i] == 0).collect();
    let mut done = Vec::with_capacity(regs.len());
    while let Some(i) = ready.pop() {
        done.push(i);
        for o in reads(i) {
            readers[o] -= 1;
            if readers[o] == 0 {
                ready.push(o);
            }
        }
    }
    let ring = (0..regs.len()).filter(|i| readers[*i] > 0).collect();
    (done, ring)
}

/// The values of [`BLOCK`] lanes.
pub(super) struct Block {
    narrow: Vec<Narrow>,
    wide: Vec<Wide>,
}

impl Program {
    /// Lays out `net`.
    pub fn new(net: &Netlist) -> Self {
        let mut p = Self {
            rows: Vec::with_capacity(net.widths.len()),
            sizes: (0, 0),
            consts: vec![],
            steps: vec![],
            aside: vec![],
            updates: vec![],
            reads: vec![],
        };
        for w in &net.widths[..net.first_op as usize] {
            let row = p.row(*w);
            p.rows.push(row);
        }
        p.rows.resize(net.widths.len(), Row::Narrow(u32::MAX));
        for i in 0..net.ops.len() {
            p.step(net, i);
        }
        p.consts = net.consts.iter().map(|(s, v)| (p.at(*s), *v)).collect();
        for (i, m) in net.mems.iter().enumerate() {
            let hold = p.row(net.widths[m.read_data as usize]);
            p.reads.push((i, p.at(m.read_addr), hold, p.at(m.read_data)));
        }
        let regs: Vec<Update> = net.regs.iter().map(|r| p.update(r)).collect();
        let (in_place, ring) = order(&regs);
        for i in ring {
            let hold = p.row(net.widths[net.regs[i].q as usize]);
            p.aside.push((regs[i], hold));
        }
        p.updates = in_place.into_iter().map(|i| regs[i]).collect();
        p
    }
    /// The row of a slot.
    pub fn at(&self, s: Slot) -> Row {
        self.rows[s as usize]
    }
    fn row(&mut self, width: u32) -> Row {
        let (n, w) = &mut self.sizes;
        if width <= 32 {
            *n += 1;
            Row::Narrow(*n - 1)
        } else {
            *w += 1;
            Row::Wide(*w - 1)
        }
    }
    fn update(&self, r: &FlatReg) -> Update {
        let control = |s: Option<Slot>| match s.map(|s| self.at(s)) {
            None => None,
            Some(Row::Narrow(i)) => Some(i),
            Some(Row::Wide(_)) => unreachable!("control signals have one bit"),
        };
        Update { q: self.at(r.q), d: self.at(r.d), enable: control(r.enable), reset: control(r.reset) }
    }

    fn step(&mut self, net: &Netlist, i: usize) {
        let (op, slot) = (net.ops[i], net.first_op as usize + i);
        if self.rows[slot] != Row::Narrow(u32::MAX) {
            return;
        }
        let args = op.args.map(|a| self.at(a));
        // Zeros on top change no word: the value shares its operand's row.
        let same_kind = (op.width <= 32) == matches!(args[0], Row::Narrow(_));
        if op.kind == Kind::Copy || (op.kind == Kind::Slice && op.aux == 0 && op.width >= op.arg_width && same_kind) {
            self.rows[slot] = args[0];
            return;
        }
        let twin = |k| net.ops[i + 1..].iter().position(|o| *o == FlatOp { kind: k, width: o.width, ..op });
        let twin = match op.kind {
            Kind::DivRem => twin(Kind::DivQuot),
            Kind::DivQuot => twin(Kind::DivRem),
            _ => None,
        };
        let out = self.row(op.width);
        self.rows[slot] = out;
        let step = match (out, args) {
            (Row::Narrow(x), [Row::Narrow(a), Row::Narrow(b), Row::Narrow(c)]) => {
                let twin = twin.filter(|t| net.ops[i + 1 + t].width <= 32).map(|t| slot + 1 + t);
                match twin {
                    None => Step::Narrow { op, out: x, args: [a, b, c] },
                    Some(other) => {
                        let y = self.row(1);
                        self.rows[other] = y;
                        let Row::Narrow(y) = y else { unreachable!("a row for one bit is narrow") };
                        let (rem, quot) = if op.kind == Kind::DivRem { (x, y) } else { (y, x) };
                        Step::Divide { op, rem, quot, args: [a, b] }
                    }
                }
            }
            (Row::Wide(x), [Row::Wide(a), Row::Wide(b), Row::Wide(c)]) => Step::Wide { op, out: x, args: [a, b, c] },
            _ => {
                let count = (1..3).filter(|k| op.args[*k] != op.args[0]).max().map_or(1, |k| k + 1);
                Step::Mixed { op, out, args, count }
            }
        };
        self.steps.push(step);
    }

    /// Values of registers and inputs at zero.
    pub fn block(&self) -> Block {
        let mut b =
            Block { narrow: vec![[0; BLOCK]; self.sizes.0 as usize], wide: vec![[0; BLOCK]; self.sizes.1 as usize] };
        for (row, v) in &self.consts {
            (0..BLOCK).for_each(|lane| b.set(*row, lane, *v));
        }
        b
    }

    /// Runs all operations.
    pub fn eval(&self, b: &mut Block) {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("lzcnt") {
            // SAFETY: the processor has the instructions that the function is compiled with.
            return unsafe { self.eval_avx2(b) };
        }
        self.eval_any(b);
    }
    /// Clocks all registers; memories' words have been put aside before.
    pub fn clock(&self, b: &mut Block) {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has the instructions that the function is compiled with.
            return unsafe { self.clock_avx2(b) };
        }
        self.clock_any(b);
    }
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,lzcnt")]
    fn eval_avx2(&self, b: &mut Block) {
        self.eval_any(b);
    }
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn clock_avx2(&self, b: &mut Block) {
        self.clock_any(b);
    }

    #[inline(always)]
    fn eval_any(&self, block: &mut Block) {
        let mut x: [Wide; 3] = [[0; BLOCK]; 3];
        for step in &self.steps {
            match step {
                Step::Narrow { op, out, args } => {
                    let (before, rest) = block.narrow.split_at_mut(*out as usize);
                    let [a, b, c] = args.map(|a| &before[a as usize]);
                    narrow(op, &mut rest[0], a, b, c);
                }
                Step::Divide { op, rem, quot, args } => {
                    let first = *rem.min(quot) as usize;
                    let (before, rest) = block.narrow.split_at_mut(first);
                    let (x, y) = rest.split_at_mut(1);
                    let (r, q) = if rem < quot { (&mut x[0], &mut y[0]) } else { (&mut y[0], &mut x[0]) };
                    let [a, b] = args.map(|a| &before[a as usize]);
                    divide(op, a, b, r, q);
                }
                Step::Wide { op, out, args } => {
                    let (before, rest) = block.wide.split_at_mut(*out as usize);
                    let [a, b, c] = args.map(|a| &before[a as usize]);
                    wide(op, &mut rest[0], a, b, c);
                }
                Step::Mixed { op, out, args, count } => {
                    for (x, a) in x.iter_mut().zip(args).take(*count) {
                        match a {
                            Row::Narrow(a) => widen(x, &block.narrow[*a as usize]),
                            Row::Wide(a) => *x = block.wide[*a as usize],
                        }
                    }
                    let mut y = [0; BLOCK];
                    wide(op, &mut y, &x[0], &x[1], &x[2]);
                    match out {
                        Row::Narrow(i) => cut(&mut block.narrow[*i as usize], &y),
                        Row::Wide(i) => block.wide[*i as usize] = y,
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn clock_any(&self, b: &mut Block) {
        for (u, hold) in &self.aside {
            b.update(u, *hold);
        }
        for u in &self.updates {
            b.update(u, u.q);
        }
        for (u, hold) in &self.aside {
            b.copy(*hold, u.q);
        }
        for (_, _, hold, word) in &self.reads {
            b.copy(*hold, *word);
        }
    }
}

impl Block {
    /// One lane of a row.
    pub fn get(&self, row: Row, lane: usize) -> u64 {
        match row {
            Row::Narrow(i) => u64::from(self.narrow[i as usize][lane]),
            Row::Wide(i) => self.wide[i as usize][lane],
        }
    }
    /// The first lanes of a row.
    pub fn read(&self, row: Row, out: &mut [u64]) {
        match row {
            Row::Narrow(i) => out.iter_mut().zip(&self.narrow[i as usize]).for_each(|(o, v)| *o = u64::from(*v)),
            Row::Wide(i) => out.copy_from_slice(&self.wide[i as usize][..out.len()]),
        }
    }
    /// Writes one lane of a row.
    pub fn set(&mut self, row: Row, lane: usize, v: u64) {
        match row {
            Row::Narrow(i) => self.narrow[i as usize][lane] = v as u32,
            Row::Wide(i) => self.wide[i as usize][lane] = v,
        }
    }
    #[inline(always)]
    fn copy(&mut self, from: Row, to: Row) {
        match (from, to) {
            (Row::Narrow(f), Row::Narrow(t)) => self.narrow[t as usize] = self.narrow[f as usize],
            (Row::Wide(f), Row::Wide(t)) => self.wide[t as usize] = self.wide[f as usize],
            _ => unreachable!("a register's input and output have the same width"),
        }
    }
    #[inline(always)]
    fn update(&mut self, u: &Update, to: Row) {
        if u.enable.is_none() && u.reset.is_none() {
            return self.copy(u.d, to);
        }
        let control = |i: Option<u32>| i.map(|i| &self.narrow[i as usize]);
        let (enable, reset) = (control(u.enable), control(u.reset));
        match (u.q, u.d, to) {
            (Row::Narrow(q), Row::Narrow(d), Row::Narrow(t)) => {
                let mut v = self.narrow[q as usize];
                next(&mut v, &self.narrow[d as usize], enable, reset);
                self.narrow[t as usize] = v;
            }
            (Row::Wide(q), Row::Wide(d), Row::Wide(t)) => {
                let mut v = self.wide[q as usize];
                next(&mut v, &self.wide[d as usize], enable, reset);
                self.wide[t as usize] = v;
            }
            _ => unreachable!("a register's input and output have the same width"),
        }
    }
}
