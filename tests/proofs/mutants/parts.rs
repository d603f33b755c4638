//! Copies of a unit inside of a larger one: a mutant of such a copy is one of the unit, which has vectors and proofs of its own.
use reliefrtl::interp::{FlatOp, Kind, Netlist};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// A slot of a netlist.
type Slot = u32;

/// What each slot stands for where registers and copies of a value are wires.
fn sources(net: &Netlist) -> Vec<Slot> {
    let mut from: Vec<Slot> = (0..net.widths.len() as Slot).collect();
    net.regs.iter().for_each(|r| from[r.q as usize] = r.d);
    for (k, op) in net.ops.iter().enumerate().filter(|(_, op)| op.kind == Kind::Copy && op.width == op.arg_width) {
        from[net.first_op as usize + k] = op.args[0];
    }
    let last = |mut s: Slot| {
        for _ in 0..from.len() {
            match from[s as usize] {
                next if next == s => break,
                next => s = next,
            }
        }
        s
    };
    (0..from.len() as Slot).map(last).collect()
}

/// A netlist, read for comparing it with another one.
struct Graph<'a> {
    net: &'a Netlist,
    sources: Vec<Slot>,
    consts: HashMap<Slot, u64>,
    /// Operations that an output depends on.
    live: BTreeSet<usize>,
}

impl<'a> Graph<'a> {
    fn of(net: &'a Netlist) -> Self {
        let consts = net.consts.iter().copied().collect();
        let mut g = Self { net, sources: sources(net), consts, live: BTreeSet::new() };
        let mut left: Vec<Slot> = net.outputs.iter().map(|o| o.slot).collect();
        while let Some(slot) = left.pop() {
            let reached = g.op(g.source(slot));
            if let Some((_, op)) = reached.filter(|(k, _)| g.live.insert(*k)) {
                left.extend(op.args);
            }
        }
        g
    }

    fn source(&self, s: Slot) -> Slot {
        self.sources[s as usize]
    }

    /// The operation that writes a slot, with its number.
    fn op(&self, s: Slot) -> Option<(usize, &'a FlatOp)> {
        let k = s.checked_sub(self.net.first_op)? as usize;
        self.net.ops.get(k).map(|op| (k, op))
    }
}

/// A part's slots, and those of the whole that are the same.
struct Match<'a> {
    whole: &'a Graph<'a>,
    part: &'a Graph<'a>,
    slots: HashMap<Slot, Slot>,
}

impl Match<'_> {
    /// True if what drives two slots is the same up to the part's inputs.
    fn unify(&mut self, p: Slot, w: Slot) -> bool {
        let (p, w) = (self.part.source(p), self.whole.source(w));
        if let Some(value) = self.part.consts.get(&p) {
            return self.whole.consts.get(&w) == Some(value);
        }
        if let Some(before) = self.slots.insert(p, w) {
            return before == w;
        }
        if self.part.net.widths[p as usize] != self.whole.net.widths[w as usize] {
            return false;
        }
        let Some((_, a)) = self.part.op(p) else { return true };
        let Some((_, b)) = self.whole.op(w) else { return false };
        let alike = |o: &FlatOp| (o.kind, o.width, o.arg_width, o.aux);
        alike(a) == alike(b) && a.args.iter().zip(b.args).all(|(p, w)| self.unify(*p, w))
    }

    /// True if nothing but the part's outputs is read outside of it.
    fn is_closed(&self) -> bool {
        let (whole, part) = (self.whole, self.part);
        let inside: BTreeSet<Slot> = self.slots.iter().filter(|(p, _)| part.op(**p).is_some()).map(|s| *s.1).collect();
        let outs: BTreeSet<Slot> =
            part.net.outputs.iter().filter_map(|o| self.slots.get(&part.source(o.slot)).copied()).collect();
        let hidden = |s: &Slot| inside.contains(&whole.source(*s)) && !outs.contains(&whole.source(*s));
        let first = whole.net.first_op;
        let others = whole.live.iter().filter(|k| !inside.contains(&(first + **k as Slot)));
        !others.flat_map(|k| whole.net.ops[*k].args.iter()).any(hidden)
            && !whole.net.outputs.iter().any(|o| hidden(&o.slot))
    }
}

/// Every copy of `part` in `whole`: operations of the whole, each with that of the part.
pub fn copies(whole: &Netlist, part: &Netlist) -> Vec<BTreeMap<usize, usize>> {
    let (whole, part) = (Graph::of(whole), Graph::of(part));
    let dots = |name: &str| name.match_indices('.').map(|(at, _)| name[..=at].to_owned()).collect::<Vec<_>>();
    let instances: BTreeSet<String> = whole.net.names.keys().flat_map(|name| dots(name)).collect();
    let one = |instance: &String| {
        let mut m = Match { whole: &whole, part: &part, slots: HashMap::new() };
        let same = |(name, p): (&String, &Slot)| Some((*p, *whole.net.names.get(&format!("{instance}{name}"))?));
        let anchors: Vec<(Slot, Slot)> = part.net.names.iter().filter_map(same).collect();
        if !anchors.into_iter().all(|(p, w)| m.unify(p, w)) || !m.is_closed() {
            return None;
        }
        let op = |(p, w): (&Slot, &Slot)| Some((whole.op(*w)?.0, part.op(*p)?.0));
        let ops: BTreeMap<usize, usize> = m.slots.iter().filter_map(op).collect();
        let there: BTreeSet<usize> = ops.values().copied().collect();
        part.live.is_subset(&there).then_some(ops)
    };
    instances.iter().filter_map(one).collect()
}
