//! From modules to a flat netlist: parameters become numbers, hierarchy dissolves, equal operations are shared,
//! constants are folded, operations are levelized.
use super::eval::eval;
use super::netlist::*;
use crate::bits::mask;
use crate::error::{Error, Result};
use crate::ir::{Binding, Body, Module, NodeId, Op, Prim};
use std::collections::{BTreeMap, HashMap};

/// Elaborates `m` at `over` (its defaults where `over` is silent).
///
/// # Errors
/// If a parameter is unknown or a condition on the parameters does not hold, here or in an instance.
pub fn elaborate(m: &Module, over: &Binding) -> Result<Netlist> {
    if let Some(k) = over.keys().find(|k| !m.params.iter().any(|p| &p.name == *k)) {
        let known: Vec<&str> = m.params.iter().map(|p| p.name.as_str()).collect();
        return Err(Error::input(format!("module {} has no parameter {k}; it has {}", m.name, known.join(", "))));
    }
    let binding = m.binding_with(over);
    let mut f = Flat::default();
    let mut inputs = BTreeMap::new();
    let mut ports = Vec::new();
    for (i, p) in m.ports.iter().enumerate() {
        if p.dir == crate::ir::Dir::In && Some(i) != m.clk {
            let width = p.width.eval(&binding) as u32;
            let s = f.source(width);
            inputs.insert(i, s);
            f.name(&p.name, s);
            ports.push(FlatPort { name: p.name.clone(), slot: s, width });
        }
    }
    let outs = f.module(m, &binding, &inputs, "")?;
    let outputs = m.data_outputs().map(|(i, p)| FlatPort {
        name: p.name.clone(),
        slot: outs[&i],
        width: p.width.eval(&binding) as u32,
    });
    let outputs = outputs.collect();
    Ok(f.levelize(binding, ports, outputs))
}

/// Growing flat design. Values are numbered in order of creation first and renumbered by `levelize`.
#[derive(Default)]
struct Flat {
    widths: Vec<u32>,
    consts: HashMap<(u64, u32), Slot>,
    const_of: HashMap<Slot, u64>,
    ops: Vec<(Slot, FlatOp)>,
    shared: HashMap<FlatOp, Slot>,
    regs: Vec<FlatReg>,
    mems: Vec<FlatMem>,
    names: BTreeMap<String, Slot>,
}

impl Flat {
    fn source(&mut self, width: u32) -> Slot {
        self.widths.push(width);
        self.widths.len() as Slot - 1
    }
    fn name(&mut self, name: &str, s: Slot) {
        self.names.insert(name.to_string(), s);
    }
    fn constant(&mut self, v: u64, width: u32) -> Slot {
        if let Some(s) = self.consts.get(&(v, width)) {
            return *s;
        }
        let s = self.source(width);
        self.consts.insert((v, width), s);
        self.const_of.insert(s, v);
        s
    }
    fn op(&mut self, kind: Kind, args: &[Slot], width: u32, aux: u32) -> Slot {
        let at = |i: usize| *args.get(i).unwrap_or(&args[0]);
        let op = FlatOp { kind, args: [at(0), at(1), at(2)], width, arg_width: self.widths[args[0] as usize], aux };
        let known: Vec<Option<u64>> = op.args.iter().map(|a| self.const_of.get(a).copied()).collect();
        if let [Some(a), Some(b), Some(c)] = known[..] {
            return self.constant(eval(&op, a, b, c), width);
        }
        match (kind, known[0]) {
            (Kind::Mux, Some(c)) => return if c == 1 { op.args[1] } else { op.args[2] },
            (Kind::Slice, _) if aux == 0 && width == op.arg_width => return op.args[0],
            (Kind::Sext | Kind::Rep, _) if width == op.arg_width => return op.args[0],
            _ => {}
        }
        if let Some(s) = self.shared.get(&op) {
            return *s;
        }
        let s = self.source(width);
        self.ops.push((s, op));
        self.shared.insert(op, s);
        s
    }

    /// Flattens one module; `inputs` gives the slots of its input ports, the result those of its outputs.
    fn module(
        &mut self,
        m: &Module,
        b: &Binding,
        inputs: &BTreeMap<usize, Slot>,
        path: &str,
    ) -> Result<BTreeMap<usize, Slot>> {
        let failed = m.failed_checks(b);
        if !failed.is_empty() {
            return Err(Error::input(format!("illegal parameters: {}", failed.join("; "))));
        }
        match m.body {
            Body::Prim(p) => Ok(self.primitive(p, m, b, inputs)),
            Body::Graph => self.graph(m, b, inputs, path),
        }
    }

    fn primitive(&mut self, p: Prim, m: &Module, b: &Binding, inputs: &BTreeMap<usize, Slot>) -> BTreeMap<usize, Slot> {
        let i = |name: &str| inputs[&m.port(name).expect("primitive has its ports").0];
        let o = |name: &str| {
            let (k, port) = m.port(name).expect("primitive has its ports");
            (k, port.width.eval(b) as u32)
        };
        match p {
            Prim::Lzc => {
                let (k, w) = o("count");
                BTreeMap::from([(k, self.op(Kind::Lzc, &[i("bits")], w, 0))])
            }
            Prim::Interleave => {
                let (k, w) = o("result");
                BTreeMap::from([(k, self.op(Kind::Interleave, &[i("a"), i("b")], w, 0))])
            }
            Prim::DivRows => {
                let (rows, (kr, wr), (kq, wq)) = (b["ROWS"] as u32, o("rem_out"), o("quot"));
                let args = [i("rem_in"), i("div")];
                let r = self.op(Kind::DivRem, &args, wr, rows);
                let q = self.op(Kind::DivQuot, &args, wq, rows);
                BTreeMap::from([(kr, r), (kq, q)])
            }
            Prim::Memory => {
                let (k, w) = o("read_data");
                let read_data = self.source(w);
                self.mems.push(FlatMem {
                    write_en: i("write_en"),
                    write_addr: i("write_addr"),
                    write_data: i("write_data"),
                    read_addr: i("read_addr"),
                    read_data,
                    depth: b["DEPTH"] as usize,
                });
                BTreeMap::from([(k, read_data)])
            }
        }
    }

    fn graph(
        &mut self,
        m: &Module,
        b: &Binding,
        inputs: &BTreeMap<usize, Slot>,
        path: &str,
    ) -> Result<BTreeMap<usize, Slot>> {
        let names = crate::ir::Names::new(m);
        let mut slot: Vec<Slot> = vec![Slot::MAX; m.nodes.len()];
        let mut inst_outs: Vec<Option<BTreeMap<usize, Slot>>> = vec![None; m.insts.len()];
        let (mut pending, mut wires) = (Vec::new(), Vec::new());
        for (i, n) in m.nodes.iter().enumerate() {
            let width = n.width.eval(b) as u32;
            let s = match &n.op {
                Op::Input(p) => inputs[p],
                Op::Reg { reset, .. } => {
                    let q = self.source(width);
                    pending.push((q, n.args[0], *reset));
                    q
                }
                Op::Wire => {
                    let w = self.source(width);
                    wires.push((w, n.args[0]));
                    w
                }
                Op::InstOut(k, port) => {
                    let inst = &m.insts[k.0 as usize];
                    if inst_outs[k.0 as usize].is_none() {
                        let ins = inst.inputs.iter().map(|(p, id)| (*p, slot[id.0 as usize])).collect();
                        let inner: Binding = inst.params.iter().map(|(n, e)| (n.clone(), e.eval(b))).collect();
                        let outs = self.module(&inst.module, &inner, &ins, &format!("{path}{}.", inst.name))?;
                        inst_outs[k.0 as usize] = Some(outs);
                    }
                    inst_outs[k.0 as usize].as_ref().expect("just filled")[port]
                }
                op => {
                    let args: Vec<Slot> = n.args.iter().map(|a| slot[a.0 as usize]).collect();
                    self.node(op, &args, width, b)
                }
            };
            slot[i] = s;
            if let Some(net) = names.net(NodeId(i as u32)) {
                self.name(&format!("{path}{net}"), s);
            }
        }
        for (w, d) in wires {
            self.ops.push((
                w,
                FlatOp {
                    kind: Kind::Copy,
                    args: [slot[d.0 as usize]; 3],
                    width: self.widths[w as usize],
                    arg_width: 1,
                    aux: 0,
                },
            ));
        }
        let control = |p: Option<usize>| p.map(|p| inputs[&p]);
        let enable = control(m.ce).filter(|e| self.const_of.get(e) != Some(&1));
        for (q, d, reset) in pending {
            let reset = if reset { control(m.rst) } else { None };
            self.regs.push(FlatReg { q, d: slot[d.0 as usize], enable, reset });
        }
        Ok(m.outputs.iter().map(|(p, id)| (*p, slot[id.0 as usize])).collect())
    }

    fn node(&mut self, op: &Op, args: &[Slot], width: u32, b: &Binding) -> Slot {
        let kind = match op {
            Op::Zeros => return self.constant(0, width),
            Op::Ones => return self.constant(mask(width), width),
            Op::Lit(v) => return self.constant(*v, width),
            Op::Konst(e) => return self.constant(e.eval_wide(b) as u64 & mask(width), width),
            Op::Concat => {
                let mut it = args.iter();
                let mut acc = *it.next().expect("concatenation of something");
                for a in it {
                    let w = self.widths[*a as usize];
                    let total = w + self.widths[acc as usize];
                    acc = self.op(Kind::Join, &[acc, *a], total, w);
                }
                return acc;
            }
            Op::Zext => return self.op(Kind::Slice, args, width, 0),
            Op::Slice { lo } => return self.op(Kind::Slice, args, width, lo.eval(b) as u32),
            Op::Not => Kind::Not,
            Op::And => Kind::And,
            Op::Or => Kind::Or,
            Op::Xor => Kind::Xor,
            Op::RedOr => Kind::RedOr,
            Op::RedAnd => Kind::RedAnd,
            Op::Add => Kind::Add,
            Op::Sub => Kind::Sub,
            Op::Mul => Kind::Mul,
            Op::Eq => Kind::Eq,
            Op::Ult => Kind::Ult,
            Op::Slt => Kind::Slt,
            Op::Shl => Kind::Shl,
            Op::Shr => Kind::Shr,
            Op::Sar => Kind::Sar,
            Op::Mux => Kind::Mux,
            Op::Sext => Kind::Sext,
            Op::Rep => Kind::Rep,
            Op::Input(_) | Op::Reg { .. } | Op::Wire | Op::InstOut(..) => unreachable!("handled by the caller"),
        };
        self.op(kind, args, width, 0)
    }

    /// Renumbers: sources first, then operations, operands before their users.
    fn levelize(self, binding: Binding, mut inputs: Vec<FlatPort>, mut outputs: Vec<FlatPort>) -> Netlist {
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
        // Depth first from each operation; the graph has no loops (verified), so a stack of two visits suffices.
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
                } else {
                    stack.extend(waiting);
                }
            }
        }
        let at = |s: Slot| map[s as usize];
        inputs.iter_mut().for_each(|p| p.slot = at(p.slot));
        outputs.iter_mut().for_each(|p| p.slot = at(p.slot));
        let reg = |r: &FlatReg| FlatReg { q: at(r.q), d: at(r.d), enable: r.enable.map(at), reset: r.reset.map(at) };
        let mem = |m: &FlatMem| FlatMem {
            write_en: at(m.write_en),
            write_addr: at(m.write_addr),
            write_data: at(m.write_data),
            read_addr: at(m.read_addr),
            read_data: at(m.read_data),
            depth: m.depth,
        };
        let mut consts: Vec<(Slot, u64)> = self.const_of.iter().map(|(s, v)| (at(*s), *v)).collect();
        consts.sort_unstable();
        let mut net = Netlist {
            binding,
            widths,
            consts,
            inputs,
            outputs,
            ops,
            first_op,
            regs: self.regs.iter().map(reg).collect(),
            mems: self.mems.iter().map(mem).collect(),
            updates: vec![],
            names: self.names.iter().map(|(n, s)| (n.clone(), at(*s))).collect(),
        };
        net.updates = order_updates(&net);
        net
    }
}

/// Orders the clocked updates so that a register is written only after all that read its old value.
fn order_updates(net: &Netlist) -> Vec<Update> {
    let mut owner: HashMap<Slot, usize> = HashMap::new();
    net.regs.iter().enumerate().for_each(|(i, r)| {
        owner.insert(r.q, i);
    });
    let reads = |r: &FlatReg| [Some(r.d), r.enable, r.reset].into_iter().flatten().collect::<Vec<_>>();
    let mut readers = vec![0usize; net.regs.len()];
    for r in &net.regs {
        for s in reads(r) {
            if let Some(o) = owner.get(&s).filter(|o| net.regs[**o].q != r.q) {
                readers[*o] += 1;
            }
        }
    }
    let mut out: Vec<Update> = (0..net.mems.len()).map(Update::Read).collect();
    let mut ready: Vec<usize> = (0..net.regs.len()).filter(|i| readers[*i] == 0).collect();
    let mut done = vec![false; net.regs.len()];
    while let Some(i) = ready.pop() {
        done[i] = true;
        out.push(Update::Reg(i));
        for s in reads(&net.regs[i]) {
            if let Some(o) = owner.get(&s).filter(|o| net.regs[**o].q != net.regs[i].q) {
                readers[*o] -= 1;
                if readers[*o] == 0 {
                    ready.push(*o);
                }
            }
        }
    }
    let ring: Vec<Update> = (0..net.regs.len()).filter(|i| !done[*i]).map(Update::RegAside).collect();
    // Rings are read before anything is written.
    ring.into_iter().chain(out).collect()
}
