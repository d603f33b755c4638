//! The same design with less to compute: what nothing reads is left out, copies and equal registers are merged.
use super::flat::Flat;
use super::netlist::*;
use rustc_hash::FxHashMap;

impl Netlist {
    /// The netlist with the same ports and the same values on them, clock by clock from registers at zero, but without
    /// what no output depends on, and without names: equal values share a slot.
    pub fn optimized(&self) -> Netlist {
        let mut net = round(self);
        // Each round merges the registers after those that the round before merged.
        loop {
            let next = round(&net);
            let done = (next.ops.len(), next.regs.len()) == (net.ops.len(), net.regs.len());
            net = next;
            if done {
                return net;
            }
        }
    }

    /// Slots that an output or a memory depends on. Memories stay even if nothing reads them: they are loaded by number.
    fn live(&self) -> Vec<bool> {
        let mut live = vec![false; self.widths.len()];
        let regs: FxHashMap<Slot, &FlatReg> = self.regs.iter().map(|r| (r.q, r)).collect();
        let mut todo: Vec<Slot> = self.outputs.iter().map(|p| p.slot).collect();
        todo.extend(self.mems.iter().flat_map(|m| [m.write_en, m.write_addr, m.write_data, m.read_addr, m.read_data]));
        while let Some(s) = todo.pop() {
            if std::mem::replace(&mut live[s as usize], true) {
                continue;
            }
            if s >= self.first_op {
                todo.extend(self.ops[(s - self.first_op) as usize].args);
            } else if let Some(r) = regs.get(&s) {
                todo.extend([Some(r.d), r.enable, r.reset].into_iter().flatten());
            }
        }
        live
    }
}

/// One pass: leaves out, merges, folds.
fn round(net: &Netlist) -> Netlist {
    let live = net.live();
    let is_live = |s: Slot| live[s as usize];
    let mut f = Flat::default();
    let mut map = vec![Slot::MAX; net.widths.len()];
    for (s, v) in net.consts.iter().filter(|c| is_live(c.0)) {
        map[*s as usize] = f.constant(*v, net.widths[*s as usize]);
    }
    for p in &net.inputs {
        map[p.slot as usize] = f.source(p.width);
    }
    for m in &net.mems {
        map[m.read_data as usize] = f.source(net.widths[m.read_data as usize]);
    }
    let mut first: FxHashMap<(Slot, Option<Slot>, Option<Slot>), Slot> = FxHashMap::default();
    let mut kept = Vec::new();
    for r in net.regs.iter().filter(|r| is_live(r.q)) {
        let same = *first.entry((r.d, r.enable, r.reset)).or_insert(r.q);
        if same == r.q {
            map[r.q as usize] = f.source(net.widths[r.q as usize]);
            kept.push(*r);
        } else {
            map[r.q as usize] = map[same as usize];
        }
    }
    for (i, op) in net.ops.iter().enumerate() {
        let s = net.first_op as usize + i;
        if live[s] {
            let args = op.args.map(|a| map[a as usize]);
            map[s] = if op.kind == Kind::Copy { args[0] } else { f.op(op.kind, &args, op.width, op.aux) };
        }
    }
    let at = |s: Slot| map[s as usize];
    f.regs = kept
        .iter()
        .map(|r| FlatReg { q: at(r.q), d: at(r.d), enable: r.enable.map(at), reset: r.reset.map(at), ..*r })
        .collect();
    f.mems = net
        .mems
        .iter()
        .map(|m| FlatMem {
            write_en: at(m.write_en),
            write_addr: at(m.write_addr),
            write_data: at(m.write_data),
            read_addr: at(m.read_addr),
            read_data: at(m.read_data),
            depth: m.depth,
            own: m.own,
        })
        .collect();
    let port = |p: &FlatPort| FlatPort { slot: at(p.slot), ..p.clone() };
    let (inputs, outputs) = (net.inputs.iter().map(port).collect(), net.outputs.iter().map(port).collect());
    f.levelize(net.binding.clone(), inputs, outputs).expect("a netlist has no loop")
}
