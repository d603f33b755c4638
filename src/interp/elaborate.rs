//! From modules to a flat netlist: parameters become numbers, hierarchy dissolves, equal operations are shared,
//! constants are folded, operations are levelized.
use super::bundle::Parts;
use super::flat::Flat;
use super::netlist::*;
use reliefrtl_base::bits::{MAX_WIDTH, mask};
use reliefrtl_base::error::{Error, Result};
use reliefrtl_ir::{Binding, Body, Module, Names, NodeId, Op, Prim};
use std::collections::BTreeMap;

/// Elaborates `m` at `over` (its defaults where `over` is silent).
///
/// # Errors
/// If a parameter is unknown, a condition on the parameters does not hold here or in an instance, or values depend on themselves in one clock.
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
        if p.dir == reliefrtl_ir::Dir::In && Some(i) != m.clk {
            let width = p.width.eval(&binding) as u32;
            narrow(m, &p.name, width)?;
            let s = f.source(width);
            inputs.insert(i, Parts::from(s));
            f.name(&p.name, s);
            ports.push(FlatPort { name: p.name.clone(), slot: s, width });
        }
    }
    let outs = f.module(m, &binding, &inputs, "")?;
    let mut outputs = Vec::new();
    for (i, p) in m.data_outputs() {
        let width = p.width.eval(&binding) as u32;
        narrow(m, &p.name, width)?;
        outputs.push(FlatPort { name: p.name.clone(), slot: outs[&i].word(), width });
    }
    f.levelize(binding, ports, outputs)
}

/// A bundle has no word at a port of its own.
fn narrow(m: &Module, port: &str, width: u32) -> Result<()> {
    match width {
        0..=MAX_WIDTH => Ok(()),
        _ => Err(Error::input(format!("{}.{port} has {width} bits: a word of a row has {MAX_WIDTH} at most", m.name))),
    }
}

impl Flat {
    /// Flattens one module; `inputs` gives the slots of its input ports, the result those of its outputs.
    fn module(
        &mut self,
        m: &Module,
        b: &Binding,
        inputs: &BTreeMap<usize, Parts>,
        path: &str,
    ) -> Result<BTreeMap<usize, Parts>> {
        let failed = m.failed_checks(b);
        if !failed.is_empty() {
            return Err(Error::input(format!("illegal parameters: {}", failed.join("; "))));
        }
        match m.body {
            Body::Prim(p) => Ok(self.primitive(p, m, b, inputs)),
            Body::Graph => self.graph(m, b, inputs, path),
        }
    }

    fn primitive(
        &mut self,
        p: Prim,
        m: &Module,
        b: &Binding,
        inputs: &BTreeMap<usize, Parts>,
    ) -> BTreeMap<usize, Parts> {
        let parts = |name: &str| &inputs[&m.port(name).expect("primitive has its ports").0];
        let i = |name: &str| parts(name).word();
        let o = |name: &str| {
            let (k, port) = m.port(name).expect("primitive has its ports");
            (k, port.width.eval(b) as u32)
        };
        match p {
            Prim::Lzc => {
                let (k, w) = o("count");
                BTreeMap::from([(k, self.op(Kind::Lzc, &[i("bits")], w, 0).into())])
            }
            Prim::Interleave => {
                let (k, w) = o("result");
                BTreeMap::from([(k, self.op(Kind::Interleave, &[i("a"), i("b")], w, 0).into())])
            }
            Prim::DivRows => {
                let (rows, (kr, wr), (kq, wq)) = (b["ROWS"] as u32, o("rem_out"), o("quot"));
                let args = [i("rem_in"), i("div")];
                let r = self.op(Kind::DivRem, &args, wr, rows);
                let q = self.op(Kind::DivQuot, &args, wq, rows);
                BTreeMap::from([(kr, r.into()), (kq, q.into())])
            }
            Prim::SqrtRows => {
                let ((kr, _), (kq, w)) = (o("rem_out"), o("root_out"));
                let (mut rem, mut root) = (i("rem_in"), i("root_in"));
                for r in 0..b["ROWS"] as u32 {
                    (rem, root) = self.sqrt_row(rem, root, w, 1 << (w - 1 - b["FIRST"] as u32 - r));
                }
                BTreeMap::from([(kr, rem.into()), (kq, root.into())])
            }
            Prim::Memory | Prim::FifoMem | Prim::Banks => {
                let (k, _) = o("read_data");
                // A memory for each part of a bundle.
                let read = parts("write_data").map(|write_data| {
                    let read_data = self.source(self.width(write_data));
                    self.mems.push(FlatMem {
                        write_en: i("write_en"),
                        write_addr: i("write_addr"),
                        write_data,
                        read_addr: i("read_addr"),
                        read_data,
                        depth: b["DEPTH"] as usize,
                        own: p == Prim::FifoMem,
                    });
                    read_data
                });
                let out = if p == Prim::Banks { self.registered(&read, None) } else { read };
                BTreeMap::from([(k, out)])
            }
            Prim::DelayLine => {
                let (k, _) = o("out_data");
                let enable = m.ce.map(|ce| inputs[&ce].word()).filter(|e| self.value(*e) != Some(1));
                let word = (0..b["CLOCKS"]).fold(parts("in_data").clone(), |word, _| self.registered(&word, enable));
                BTreeMap::from([(k, word)])
            }
            Prim::RecipTable => {
                let (k, w) = o("word");
                let (q, d) = (self.source(w), self.op(Kind::RecipTable, &[i("index")], w, 0));
                let enable = m.ce.map(|ce| inputs[&ce].word()).filter(|e| self.value(*e) != Some(1));
                self.regs.push(FlatReg { q, d, enable, reset: None, unknown: None });
                BTreeMap::from([(k, q.into())])
            }
        }
    }

    /// `word` one clock later.
    fn registered(&mut self, word: &Parts, enable: Option<Slot>) -> Parts {
        word.map(|d| {
            let q = self.source(self.width(d));
            self.regs.push(FlatReg { q, d, enable, reset: None, unknown: None });
            q
        })
    }

    /// One row of square root: `mark` is the digit's place in the root's `w` bits.
    fn sqrt_row(&mut self, rem: Slot, root: Slot, w: u32, mark: u64) -> (Slot, Slot) {
        let zero = self.constant(0, 1);
        let twice = self.op(Kind::Join, &[rem, zero], w + 2, 1);
        let doubled = self.op(Kind::Join, &[root, zero], w + 1, 1);
        let doubled = self.op(Kind::Slice, &[doubled], w + 2, 0);
        let place = self.constant(mark, w + 2);
        let trial = self.op(Kind::Or, &[doubled, place], w + 2, 0);
        let below = self.op(Kind::Ult, &[twice, trial], 1, 0);
        let diff = self.op(Kind::Sub, &[twice, trial], w + 2, 0);
        let next = self.op(Kind::Mux, &[below, twice, diff], w + 2, 0);
        let digit = self.constant(mark, w);
        let more = self.op(Kind::Or, &[root, digit], w, 0);
        (self.op(Kind::Slice, &[next], w + 1, 0), self.op(Kind::Mux, &[below, root, more], w, 0))
    }

    fn graph(
        &mut self,
        m: &Module,
        b: &Binding,
        inputs: &BTreeMap<usize, Parts>,
        path: &str,
    ) -> Result<BTreeMap<usize, Parts>> {
        let names = Names::new(m);
        let mut slot: Vec<Parts> = vec![Parts::default(); m.nodes.len()];
        let mut inst_outs: Vec<Option<BTreeMap<usize, Parts>>> = vec![None; m.insts.len()];
        let (mut pending, mut wires) = (Vec::new(), Vec::new());
        for (i, n) in m.nodes.iter().enumerate() {
            let width = n.width.eval(b) as u32;
            let s = match &n.op {
                Op::Input(p) => inputs[p].clone(),
                Op::Reg { reset, unknown, .. } => {
                    let q = self.sources(&self.shape(m, b, &slot, i));
                    pending.push((q.clone(), n.args[0], *reset, *unknown));
                    q
                }
                Op::Wire => {
                    let w = self.sources(&self.shape(m, b, &slot, i));
                    wires.push((w.clone(), n.args[0]));
                    w
                }
                Op::InstOut(k, port) => {
                    let inst = &m.insts[k.0 as usize];
                    if inst_outs[k.0 as usize].is_none() {
                        let ins = inst.inputs.iter().map(|(p, id)| (*p, slot[id.0 as usize].clone())).collect();
                        let inner: Binding = inst.params.iter().map(|(n, e)| (n.clone(), e.eval(b))).collect();
                        let outs = self.module(&inst.module, &inner, &ins, &format!("{path}{}.", inst.name))?;
                        inst_outs[k.0 as usize] = Some(outs);
                    }
                    inst_outs[k.0 as usize].as_ref().expect("just filled")[port].clone()
                }
                Op::Concat | Op::Slice { .. } | Op::Mux
                    if width > MAX_WIDTH || slot[n.args[0].0 as usize].is_bundle() =>
                {
                    let args: Vec<&Parts> = n.args.iter().map(|a| &slot[a.0 as usize]).collect();
                    self.carried(&n.op, &args, width, b)
                }
                op => {
                    let args: Vec<Slot> = n.args.iter().map(|a| slot[a.0 as usize].word()).collect();
                    self.node(op, &args, width, b).into()
                }
            };
            if let Some(net) = names.net(NodeId(i as u32)).filter(|_| names.owns_net(NodeId(i as u32))) {
                self.name_parts(&format!("{path}{net}"), &s);
            }
            slot[i] = s;
        }
        for (w, d) in wires {
            let from = self.reshaped(&slot[d.0 as usize], &self.widths_of(&w));
            w.iter().zip(from.iter()).for_each(|(to, from)| self.copy(to, from));
        }
        let control = |p: Option<usize>| p.map(|p| inputs[&p].word());
        let enable = control(m.ce).filter(|e| self.value(*e) != Some(1));
        for (q, d, reset, unknown) in pending {
            let reset = if reset { control(m.rst) } else { None };
            let from = self.reshaped(&slot[d.0 as usize], &self.widths_of(&q));
            self.regs.extend(q.iter().zip(from.iter()).map(|(q, d)| FlatReg { q, d, enable, reset, unknown }));
        }
        Ok(m.outputs.iter().map(|(p, id)| (*p, slot[id.0 as usize].clone())).collect())
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
                    let w = self.width(*a);
                    let total = w + self.width(acc);
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
}
