//! A netlist laid out for execution: every slot has a row of narrow or wide words, every operation its loop.
use super::kernel::*;
use super::netlist::{FlatOp, Slot};
use multiversion::multiversion;

/// Where a slot's words stand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Row {
    /// In [`Block::narrow`].
    Narrow(u32),
    /// In [`Block::wide`].
    Wide(u32),
}

/// One step of [`Program::eval`]. The row of a result is none of its operands'.
pub(super) enum Step {
    /// All words are narrow.
    Narrow { code: Code, op: FlatOp, out: u32, args: [u32; 3] },
    /// Remainder and quotient of narrow words at once.
    Divide { op: FlatOp, rem: u32, quot: u32, args: [u32; 2] },
    /// All words are wide.
    Wide { op: FlatOp, out: u32, args: [u32; 3] },
    /// A narrow slice of wide words.
    Cut { op: FlatOp, out: u32, arg: u32 },
    /// The wide product of narrow words.
    Product { op: FlatOp, out: u32, args: [u32; 2] },
    /// Some of each; the first `count` operands are read.
    Mixed { op: FlatOp, out: Row, args: [Row; 3], count: usize },
}

/// A register: rows of one kind, control always narrow.
#[derive(Clone, Copy)]
pub(super) struct Update {
    pub q: Row,
    pub d: Row,
    pub enable: Option<u32>,
    pub reset: Option<u32>,
}

/// The read of a memory: its index, the row of the address, where the word is kept until the clock, where it goes.
pub(super) struct Read {
    pub mem: usize,
    pub addr: Row,
    pub hold: Row,
    pub word: Row,
}

/// The layout and the steps.
#[derive(Default)]
pub(super) struct Program {
    /// Row of each slot; `None` for those whose row went to others.
    pub rows: Vec<Option<Row>>,
    /// Narrow and wide rows.
    pub sizes: (u32, u32),
    pub consts: Vec<(Row, u64)>,
    pub steps: Vec<Step>,
    /// Registers that others still need when they are written: kept aside before anything is written.
    pub aside: Vec<(Row, Row)>,
    /// Registers, each after all that read it.
    pub updates: Vec<Update>,
    pub reads: Vec<Read>,
}

/// The values of `L` lanes.
pub(super) struct Block<const L: usize> {
    narrow: Vec<Narrow<L>>,
    wide: Vec<Wide<L>>,
}

impl Program {
    /// The row of a slot.
    ///
    /// # Panics
    /// If its row went to others.
    #[inline]
    pub fn at(&self, s: Slot) -> Row {
        self.rows[s as usize].expect("only ports and registers can be read where rows are shared")
    }
    /// Values of registers and inputs at zero.
    pub fn block<const L: usize>(&self) -> Block<L> {
        let mut b = Block { narrow: vec![[0; L]; self.sizes.0 as usize], wide: vec![[0; L]; self.sizes.1 as usize] };
        for (row, v) in &self.consts {
            (0..L).for_each(|lane| b.set(*row, lane, *v));
        }
        b
    }

    /// Runs all operations.
    pub fn eval<const L: usize>(&self, b: &mut Block<L>) {
        eval(self, b);
    }
    /// Clocks all registers; memories' words have been put aside before.
    pub fn clock<const L: usize>(&self, b: &mut Block<L>) {
        clock(self, b);
    }
}

/// Runs all operations.
#[multiversion(targets("x86_64+avx2+lzcnt"))]
fn eval<const L: usize>(program: &Program, block: &mut Block<L>) {
    let mut x: [Wide<L>; 3] = [[0; L]; 3];
    for step in &program.steps {
        match step {
            Step::Narrow { code, op, out, args } => {
                let (out, others) = apart(&mut block.narrow, *out);
                narrow(*code, op, out, others.row(args[0]), others.row(args[1]), others.row(args[2]));
            }
            Step::Divide { op, rem, quot, args } => {
                let [a, b] = args.map(|a| block.narrow[a as usize]);
                let (mut r, mut q) = ([0; L], [0; L]);
                divide(op, &a, &b, &mut r, &mut q);
                (block.narrow[*rem as usize], block.narrow[*quot as usize]) = (r, q);
            }
            Step::Wide { op, out, args } => {
                let (out, others) = apart(&mut block.wide, *out);
                wide(op, out, others.row(args[0]), others.row(args[1]), others.row(args[2]));
            }
            Step::Cut { op, out, arg } => {
                slice(op, &mut block.narrow[*out as usize], &block.wide[*arg as usize]);
            }
            Step::Product { op, out, args } => {
                let [a, b] = args.map(|a| &block.narrow[a as usize]);
                product(op, &mut block.wide[*out as usize], a, b);
            }
            Step::Mixed { op, out, args, count } => {
                for (x, a) in x.iter_mut().zip(args).take(*count) {
                    match a {
                        Row::Narrow(a) => widen(x, &block.narrow[*a as usize]),
                        Row::Wide(a) => *x = block.wide[*a as usize],
                    }
                }
                let mut y = [0; L];
                wide(op, &mut y, &x[0], &x[1], &x[2]);
                match out {
                    Row::Narrow(i) => truncate(&mut block.narrow[*i as usize], &y),
                    Row::Wide(i) => block.wide[*i as usize] = y,
                }
            }
        }
    }
}

/// Clocks all registers; memories' words have been put aside before.
#[multiversion(targets("x86_64+avx2"))]
fn clock<const L: usize>(program: &Program, b: &mut Block<L>) {
    for (from, hold) in &program.aside {
        b.copy(*from, *hold);
    }
    program.updates.iter().for_each(|u| b.update(u));
    for r in &program.reads {
        b.copy(r.hold, r.word);
    }
}

/// All rows but one.
struct Others<'b, T, const L: usize> {
    before: &'b [[T; L]],
    after: &'b [[T; L]],
}

/// A row to write, and the others to read.
#[inline(always)]
fn apart<T, const L: usize>(rows: &mut [[T; L]], out: u32) -> (&mut [T; L], Others<'_, T, L>) {
    let (before, rest) = rows.split_at_mut(out as usize);
    let (out, after) = rest.split_first_mut().expect("the row exists");
    (out, Others { before, after })
}

impl<'b, T, const L: usize> Others<'b, T, L> {
    #[inline(always)]
    fn row(&self, i: u32) -> &'b [T; L] {
        let i = i as usize;
        if i < self.before.len() { &self.before[i] } else { &self.after[i - self.before.len() - 1] }
    }
}

impl<const L: usize> Block<L> {
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
    fn update(&mut self, u: &Update) {
        match (u.q, u.d) {
            _ if u.enable.is_none() && u.reset.is_none() => self.copy(u.d, u.q),
            (Row::Narrow(q), Row::Narrow(d)) => {
                let (q, rows) = apart(&mut self.narrow, q);
                let [enable, reset] = [u.enable, u.reset].map(|i| i.map(|i| rows.row(i)));
                next_narrow(q, rows.row(d), enable, reset);
            }
            (Row::Wide(q), Row::Wide(d)) => {
                let [enable, reset] = [u.enable, u.reset].map(|i| i.map(|i| &self.narrow[i as usize]));
                let (q, rows) = apart(&mut self.wide, q);
                next_wide(q, rows.row(d), enable, reset);
            }
            _ => unreachable!("a register's input and output have the same width"),
        }
    }
}
