//! Laying out a netlist: rows for its slots, steps for its operations, an order for its registers.
use super::fuse::fuse;
use super::kernel::Code;
use super::netlist::*;
use super::program::{Program, Read, Row, Step, Update};
use rustc_hash::FxHashMap;

/// Lays out `net`. With `share`, words that are neither ports nor registers share rows as soon as nothing needs them any
/// more: then most of what is computed stays in the first-level cache.
pub(super) fn layout(net: &Netlist, share: bool) -> Program {
    let shapes = if share { fuse(net) } else { net.ops.iter().map(|op| Some((Code::Plain, *op))).collect() };
    let uses = uses(net, &shapes);
    let mut l = Layout { p: Program::default(), uses, left: FxHashMap::default(), free: [vec![], vec![]], share };
    l.p.rows = vec![None; net.widths.len()];
    for s in 0..net.first_op {
        let row = l.row(net.widths[s as usize]);
        l.place(s, row);
    }
    for (i, shape) in shapes.iter().enumerate() {
        if let Some((code, op)) = shape {
            l.step(net, i, *code, op);
            op.args.iter().for_each(|a| l.used(*a));
        }
    }
    let mut p = l.p;
    p.consts = net.consts.iter().map(|(s, v)| (p.at(*s), *v)).collect();
    for (mem, m) in net.mems.iter().enumerate() {
        let hold = new_row(&mut p.sizes, net.widths[m.read_data as usize]);
        p.reads.push(Read { mem, addr: p.at(m.read_addr), hold, word: p.at(m.read_data) });
    }
    let regs: Vec<Update> = net.regs.iter().map(|r| update(&p, r)).collect();
    order(net, &mut p, regs);
    if share {
        let kept = l.uses.iter().map(|u| *u >= KEPT);
        p.rows.iter_mut().zip(kept).filter(|(_, kept)| !kept).for_each(|(row, _)| *row = None);
    }
    p
}

struct Layout {
    p: Program,
    /// Operands that each slot is, in all operations; at least [`KEPT`] where it is needed beyond them.
    uses: Vec<u32>,
    /// Of these, those to come, for all slots of a row.
    left: FxHashMap<Row, u32>,
    free: [Vec<Row>; 2],
    share: bool,
}

/// More uses than there can be.
const KEPT: u32 = 1 << 30;

fn uses(net: &Netlist, shapes: &[Option<(Code, FlatOp)>]) -> Vec<u32> {
    let mut uses = vec![0; net.widths.len()];
    shapes.iter().flatten().flat_map(|(_, op)| op.args).for_each(|a| uses[a as usize] += 1);
    let sources = 0..net.first_op;
    let ports = net.outputs.iter().map(|p| p.slot);
    let regs = net.regs.iter().flat_map(|r| [Some(r.d), r.enable, r.reset].into_iter().flatten());
    let mems = net.mems.iter().flat_map(|m| [m.write_en, m.write_addr, m.write_data, m.read_addr]);
    sources.chain(ports).chain(regs).chain(mems).for_each(|s| uses[s as usize] = KEPT);
    uses
}

fn new_row(sizes: &mut (u32, u32), width: u32) -> Row {
    if width <= 32 {
        sizes.0 += 1;
        Row::Narrow(sizes.0 - 1)
    } else {
        sizes.1 += 1;
        Row::Wide(sizes.1 - 1)
    }
}

impl Layout {
    fn row(&mut self, width: u32) -> Row {
        self.free[usize::from(width > 32)].pop().unwrap_or_else(|| new_row(&mut self.p.sizes, width))
    }
    fn place(&mut self, s: Slot, row: Row) {
        self.p.rows[s as usize] = Some(row);
        let left = self.left.entry(row).or_insert(0);
        *left = left.saturating_add(self.uses[s as usize]);
    }
    /// One operand has been read: the row is free after the last.
    fn used(&mut self, s: Slot) {
        let row = self.p.at(s);
        let left = self.left.get_mut(&row).expect("the row was placed");
        *left -= 1;
        if *left == 0 && self.share {
            self.free[usize::from(matches!(row, Row::Wide(_)))].push(row);
        }
    }

    fn step(&mut self, net: &Netlist, i: usize, code: Code, op: &FlatOp) {
        let (op, slot) = (*op, net.first_op + i as Slot);
        if self.p.rows[slot as usize].is_some() {
            return;
        }
        let args = op.args.map(|a| self.p.at(a));
        // Zeros on top change no word: the value shares its operand's row.
        let same_kind = (op.width <= 32) == matches!(args[0], Row::Narrow(_));
        if op.kind == Kind::Copy || (op.kind == Kind::Slice && op.aux == 0 && op.width >= op.arg_width && same_kind) {
            return self.place(slot, args[0]);
        }
        let out = self.row(op.width);
        self.place(slot, out);
        let step = match (out, args) {
            (Row::Narrow(x), [Row::Narrow(a), Row::Narrow(b), Row::Narrow(c)]) => match twin(net, i) {
                None => Step::Narrow { code, op, out: x, args: [a, b, c] },
                Some(t) => {
                    let other = self.row(1);
                    self.place(net.first_op + t as Slot, other);
                    let Row::Narrow(y) = other else { unreachable!("a row for one bit is narrow") };
                    let (rem, quot) = if op.kind == Kind::DivRem { (x, y) } else { (y, x) };
                    Step::Divide { op, rem, quot, args: [a, b] }
                }
            },
            (Row::Wide(x), [Row::Wide(a), Row::Wide(b), Row::Wide(c)]) => Step::Wide { op, out: x, args: [a, b, c] },
            (Row::Narrow(x), [Row::Wide(a), ..]) if op.kind == Kind::Slice => Step::Cut { op, out: x, arg: a },
            (Row::Wide(x), [Row::Narrow(a), Row::Narrow(b), _]) if op.kind == Kind::Mul => {
                Step::Product { op, out: x, args: [a, b] }
            }
            _ => {
                let count = (1..3).filter(|k| op.args[*k] != op.args[0]).max().map_or(1, |k| k + 1);
                Step::Mixed { op, out, args, count }
            }
        };
        self.p.steps.push(step);
    }
}

/// The operation that takes the other result of the same division, if it is narrow, too.
fn twin(net: &Netlist, i: usize) -> Option<usize> {
    let op = net.ops[i];
    let kind = match op.kind {
        Kind::DivRem => Kind::DivQuot,
        Kind::DivQuot => Kind::DivRem,
        _ => return None,
    };
    let is_twin = |o: &FlatOp| *o == FlatOp { kind, width: o.width, ..op } && o.width <= 32;
    (i + 1..net.ops.len()).find(|t| is_twin(&net.ops[*t]))
}

fn update(p: &Program, r: &FlatReg) -> Update {
    let control = |s: Option<Slot>| match s.map(|s| p.at(s)) {
        None => None,
        Some(Row::Narrow(i)) => Some(i),
        Some(Row::Wide(_)) => unreachable!("control signals have one bit"),
    };
    Update { q: p.at(r.q), d: p.at(r.d), enable: control(r.enable), reset: control(r.reset) }
}

/// Puts registers in an order in which none is written before all have read it. Those that stand in rings, or read
/// themselves, read copies of what was there.
fn order(net: &Netlist, p: &mut Program, mut regs: Vec<Update>) {
    let reads = |r: &Update| [Some(r.d), r.enable.map(Row::Narrow), r.reset.map(Row::Narrow)].into_iter().flatten();
    let owner: FxHashMap<Row, usize> = regs.iter().enumerate().map(|(i, r)| (r.q, i)).collect();
    let sources = |i: usize, r: &Update| {
        reads(r).filter_map(|row| owner.get(&row).copied()).filter(|o| *o != i).collect::<Vec<_>>()
    };
    let mut readers = vec![0usize; regs.len()];
    regs.iter().enumerate().for_each(|(i, r)| sources(i, r).into_iter().for_each(|o| readers[o] += 1));
    let mut ready: Vec<usize> = (0..regs.len()).filter(|i| readers[*i] == 0).collect();
    let mut done = Vec::with_capacity(regs.len());
    while let Some(i) = ready.pop() {
        done.push(i);
        for o in sources(i, &regs[i]) {
            readers[o] -= 1;
            if readers[o] == 0 {
                ready.push(o);
            }
        }
    }
    let ring: Vec<usize> = (0..regs.len()).filter(|i| readers[*i] > 0).collect();
    let mut copies = FxHashMap::default();
    for i in 0..regs.len() {
        let q = regs[i].q;
        if readers[i] > 0 || reads(&regs[i]).any(|row| row == q) {
            let hold = new_row(&mut p.sizes, net.widths[net.regs[i].q as usize]);
            p.aside.push((q, hold));
            copies.insert(q, hold);
        }
    }
    let copy = |row: Row| copies.get(&row).copied().unwrap_or(row);
    for r in &mut regs {
        r.d = copy(r.d);
        for control in [&mut r.enable, &mut r.reset].into_iter().flatten() {
            let Row::Narrow(i) = copy(Row::Narrow(*control)) else { unreachable!("control signals have one bit") };
            *control = i;
        }
    }
    p.updates = done.into_iter().chain(ring).map(|i| regs[i]).collect();
}
