//! A flat design that grows: equal operations are shared, constants folded, and at the end all is levelized.
use super::eval::eval;
use super::netlist::*;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_ir::Binding;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Where a value comes from.
#[derive(Clone, Copy)]
enum Origin {
    Const(u64),
    /// The operation at this place in the list.
    Op(usize),
    /// A port, a register, a memory, or a copy.
    Source,
}

/// Growing flat design. Values are numbered in order of creation first and renumbered by `levelize`.
#[derive(Default)]
pub(super) struct Flat {
    widths: Vec<u32>,
    consts: FxHashMap<(u64, u32), Slot>,
    origins: Vec<Origin>,
    ops: Vec<(Slot, FlatOp)>,
    shared: FxHashMap<FlatOp, Slot>,
    pub regs: Vec<FlatReg>,
    pub mems: Vec<FlatMem>,
    pub names: BTreeMap<String, Slot>,
}

impl Flat {
    /// A value that no operation computes.
    pub fn source(&mut self, width: u32) -> Slot {
        self.value_of(width, Origin::Source)
    }
    fn value_of(&mut self, width: u32, origin: Origin) -> Slot {
        self.widths.push(width);
        self.origins.push(origin);
        self.widths.len() as Slot - 1
    }
    /// Names a value.
    pub fn name(&mut self, name: &str, s: Slot) {
        self.names.insert(name.to_string(), s);
    }
    /// Width of a value.
    pub fn width(&self, s: Slot) -> u32 {
        self.widths[s as usize]
    }
    /// Its value, if it is a constant.
    pub fn value(&self, s: Slot) -> Option<u64> {
        match self.origins[s as usize] {
            Origin::Const(v) => Some(v),
            _ => None,
        }
    }
    /// The operation that computes a value.
    pub fn made_by(&self, s: Slot) -> Option<FlatOp> {
        match self.origins[s as usize] {
            Origin::Op(i) => Some(self.ops[i].1),
            _ => None,
        }
    }
    /// A constant.
    pub fn constant(&mut self, v: u64, width: u32) -> Slot {
        if let Some(s) = self.consts.get(&(v, width)) {
            return *s;
        }
        let s = self.value_of(width, Origin::Const(v));
        self.consts.insert((v, width), s);
        s
    }
    /// Lets the source `to` carry the value `from`.
    pub fn copy(&mut self, to: Slot, from: Slot) {
        let width = self.width(to);
        self.ops.push((to, FlatOp { kind: Kind::Copy, args: [from; 3], width, arg_width: width, aux: 0 }));
    }
    /// An operation: a value that exists already if there is one that is equal.
    pub fn op(&mut self, kind: Kind, args: &[Slot], width: u32, aux: u32) -> Slot {
        let at = |i: usize| *args.get(i).unwrap_or(&args[0]);
        let mut op = FlatOp { kind, args: [at(0), at(1), at(2)], width, arg_width: self.width(at(0)), aux };
        if let [Some(a), Some(b), Some(c)] = op.args.map(|a| self.value(a)) {
            return self.constant(eval(&op, a, b, c), width);
        }
        if matches!(kind, Kind::And | Kind::Or | Kind::Xor | Kind::Add | Kind::Eq) && op.args[0] > op.args[1] {
            op.args = [op.args[1], op.args[0], op.args[1]];
        }
        if let Some(s) = self.simpler(&op) {
            return s;
        }
        if let Some(s) = self.shared.get(&op) {
            return *s;
        }
        let s = self.value_of(width, Origin::Op(self.ops.len()));
        self.ops.push((s, op));
        self.shared.insert(op, s);
        s
    }

    /// Renumbers: sources first, then operations, operands before their users.
    ///
    /// # Errors
    /// A combinational loop, with one of its values: a name, if any on the way has one.
    pub fn levelize(
        mut self,
        binding: Binding,
        mut inputs: Vec<FlatPort>,
        mut outputs: Vec<FlatPort>,
    ) -> Result<Netlist> {
        self.mems.sort_by_key(|m| m.own);
        let mut producer = vec![usize::MAX; self.widths.len()];
        self.ops.iter().enumerate().for_each(|(i, (s, _))| producer[*s as usize] = i);
        let mut map = vec![Slot::MAX; self.widths.len()];
        let mut widths = Vec::with_capacity(self.widths.len());
        for (s, w) in self.widths.iter().enumerate().filter(|(s, _)| producer[*s] == usize::MAX) {
            map[s] = widths.len() as Slot;
            widths.push(*w);
        }
        let first_op = widths.len() as Slot;
        let mut ops: Vec<FlatOp> = Vec::with_capacity(self.ops.len());
        // Depth first from each operation. One that is met again while it waits for what it reads waits for itself.
        let mut waits = vec![false; self.ops.len()];
        for root in 0..self.ops.len() {
            let mut stack = vec![root];
            while let Some(i) = stack.last().copied() {
                let (s, op) = &self.ops[i];
                if map[*s as usize] != Slot::MAX {
                    stack.pop();
                    continue;
                }
                let waiting: Vec<usize> =
                    op.args.iter().filter(|a| map[**a as usize] == Slot::MAX).map(|a| producer[*a as usize]).collect();
                if waiting.is_empty() {
                    map[*s as usize] = widths.len() as Slot;
                    widths.push(op.width);
                    ops.push(FlatOp { args: op.args.map(|a| map[a as usize]), ..*op });
                    stack.pop();
                } else if std::mem::replace(&mut waits[i], true) {
                    let around: Vec<Slot> = stack.iter().filter(|k| waits[**k]).map(|k| self.ops[*k].0).collect();
                    let named = self.names.iter().find(|(_, s)| around.contains(s));
                    let at = named.map_or_else(String::new, |(n, _)| format!(", through {n}"));
                    return Err(Error::input(format!("a combinational loop{at}")));
                } else {
                    stack.extend(waiting);
                }
            }
        }
        let at = |s: Slot| map[s as usize];
        inputs.iter_mut().for_each(|p| p.slot = at(p.slot));
        outputs.iter_mut().for_each(|p| p.slot = at(p.slot));
        let control = |s: Option<Slot>| s.map(at);
        let reg =
            |r: &FlatReg| FlatReg { q: at(r.q), d: at(r.d), enable: control(r.enable), reset: control(r.reset), ..*r };
        let mem = |m: &FlatMem| FlatMem {
            write_en: at(m.write_en),
            write_addr: at(m.write_addr),
            write_data: at(m.write_data),
            read_addr: at(m.read_addr),
            read_data: at(m.read_data),
            depth: m.depth,
            own: m.own,
        };
        let mut consts: Vec<(Slot, u64)> = self.consts.iter().map(|((v, _), s)| (at(*s), *v)).collect();
        consts.sort_unstable();
        Ok(Netlist {
            binding,
            widths,
            consts,
            inputs,
            outputs,
            ops,
            first_op,
            regs: self.regs.iter().map(reg).collect(),
            mems: self.mems.iter().map(mem).collect(),
            names: self.names.iter().map(|(n, s)| (n.clone(), at(*s))).collect(),
        })
    }
}
