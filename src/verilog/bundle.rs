//! Delay bundles: values that only wait share one packed shift register, where each would have one of its own in every stage.
use super::layout::range;
use reliefrtl_ir::{Binding, Expr, Module, Names, Node, NodeId, Op};
use std::collections::{BTreeMap, BTreeSet};

/// Registers of a bundle, at least, the last ones included: fewer are quicker read one by one.
const LEAST_REGISTERS: usize = 4;

/// Values that wait from one stage to a later one.
pub struct Bundle {
    /// Stage of the values that enter.
    pub from: u32,
    /// Stage of the registers at the end, which have nets of their own.
    pub to: u32,
    /// Reset clears all of it.
    pub reset: bool,
    /// Each value is one bit.
    pub bits: bool,
    /// What enters, and the registers of its wait.
    pub values: Vec<(NodeId, Vec<NodeId>)>,
}

/// All bundles of a module, in the order of their last and first stages.
pub struct Bundles {
    /// The bundles.
    pub list: Vec<Bundle>,
    /// Registers that a bundle holds, last ones included.
    held: BTreeSet<NodeId>,
}

impl Bundles {
    /// Finds the waits of two clocks and more of `m`: registers in a row of which nothing reads but the last. Those that reset clears are
    /// bundles of their own.
    pub fn of(names: &Names) -> Self {
        let m = names.m;
        let mut readers = vec![0u32; m.nodes.len()];
        let reads = m.nodes.iter().flat_map(|n| n.args.iter()).chain(m.outputs.iter().map(|o| &o.1)).chain(&m.unused);
        reads
            .chain(m.insts.iter().flat_map(|i| i.inputs.iter().map(|x| &x.1)))
            .for_each(|id| readers[id.0 as usize] += 1);
        let resets = |id: NodeId| match m.node(id).op {
            Op::Reg { reset, wrap: false, unknown: None } if names.staged => Some(reset),
            _ => None,
        };
        let ids = || (0..m.nodes.len() as u32).map(NodeId).filter(|id| resets(*id).is_some());
        let mut next = BTreeMap::new();
        for id in ids() {
            let from = m.node(id).args[0];
            if resets(from) == resets(id) && readers[from.0 as usize] == 1 {
                next.insert(from, id);
            }
        }
        let mut groups: BTreeMap<(u32, u32, bool), Bundle> = BTreeMap::new();
        let inner: BTreeSet<NodeId> = next.values().copied().collect();
        for first in ids().filter(|id| !inner.contains(id)) {
            let row: Vec<NodeId> = std::iter::successors(Some(first), |id| next.get(id).copied()).collect();
            let to = names.stage[row[row.len() - 1].0 as usize];
            let (from, reset) = (to - row.len() as u32, resets(first) == Some(true));
            if row.len() > 1 {
                let bundle =
                    groups.entry((to, from, reset)).or_insert(Bundle { from, to, reset, bits: true, values: vec![] });
                bundle.bits &= m.node(first).width.as_const() == Some(1);
                bundle.values.push((m.node(first).args[0], row));
            }
        }
        let list: Vec<Bundle> = groups.into_values().filter(|b| b.registers().count() >= LEAST_REGISTERS).collect();
        Self { held: list.iter().flat_map(Bundle::registers).collect(), list }
    }

    /// Whether a bundle holds this register, so that it has no clocked line of its own.
    pub fn holds(&self, id: NodeId) -> bool {
        self.held.contains(&id)
    }
}

impl Bundle {
    fn registers(&self) -> impl Iterator<Item = NodeId> {
        self.values.iter().flat_map(|(_, row)| row.iter().copied())
    }

    /// The last register of each value.
    pub fn last(&self) -> impl Iterator<Item = NodeId> {
        self.values.iter().map(|(_, row)| row[row.len() - 1])
    }

    /// Name of the registers between the first stage and the last.
    pub fn net(&self) -> String {
        // Words that are reset, such as those of a counter, are no valid bits.
        let kind = match (self.reset, self.bits) {
            (false, _) => "",
            (true, true) => "_valid",
            (true, false) => "_reset",
        };
        format!("s{}_to_s{}{kind}", self.from, self.to)
    }

    /// Bits of a stage; `named` gives a width by the name that it has in the text.
    pub fn width(&self, m: &Module, named: impl Fn(&Expr) -> Expr) -> Expr {
        self.last().fold(Expr::from(0), |sum, last| sum + named(&m.node(last).width))
    }

    /// Range of the registers between the first stage and the last.
    pub fn range(&self, m: &Module, named: impl Fn(&Expr) -> Expr) -> String {
        range(&(self.width(m, named) * i64::from(self.to - self.from - 1)))
    }
}

/// Bit `bit` of the shift register `net` of a module at its default parameters, by the name that it would have in a register of its own, such as
/// `s3_ups[7]`; `None` if the module has no such register.
pub fn delayed_bit(m: &Module, net: &str, bit: u32) -> Option<String> {
    let names = Names::new(m);
    let bundles = Bundles::of(&names);
    let b = bundles.list.iter().find(|b| b.net() == net)?;
    let defaults = m.default_binding();
    let width = |id: NodeId| m.node(id).width.eval(&defaults) as u32;
    let word: u32 = b.last().map(width).sum();
    // Words enter at the low end; in a word the first value is on top.
    let (stage, mut rest) = (b.from + 1 + bit / word, bit % word);
    let last: Vec<NodeId> = b.last().collect();
    let last = *last.iter().rev().find(|v| {
        let here = rest < width(**v);
        rest -= if here { 0 } else { width(**v) };
        here
    })?;
    let name = format!("s{stage}_{}", m.node(last).name.as_ref()?);
    (stage < b.to).then(|| if width(last) == 1 { name } else { format!("{name}[{rest}]") })
}

/// Bits `lo..lo + bits` of the value that is called `value` where it stands in `stage`, as part of the net that carries it: the other way of
/// [`delayed_bit`]. `None` if no register of the module holds that value in that stage.
pub fn delayed_net(m: &Module, at: &Binding, value: &str, stage: u32, (lo, bits): (u32, u32)) -> Option<String> {
    let names = Names::new(m);
    let width = |id: NodeId| m.node(id).width.eval(at) as u32;
    let is_it = |n: &Node| n.name.as_deref() == Some(value) && n.stage == Some(stage);
    let id = NodeId(m.nodes.iter().position(|n| is_it(n) && matches!(n.op, Op::Reg { .. }))? as u32);
    let part = |net: String, lo: u32| {
        if bits == 1 { format!("{net}[{lo}]") } else { format!("{net}[{}:{lo}]", lo + bits - 1) }
    };
    let bundles = Bundles::of(&names);
    let inside = |b: &&Bundle| stage < b.to && b.registers().any(|r| r == id);
    match bundles.list.iter().find(inside) {
        Some(b) => {
            let (word, below) = b.values.iter().rev().fold((0, None), |(sum, found), (_, row)| {
                (sum + width(row[0]), found.or(row.contains(&id).then_some(sum)))
            });
            Some(part(b.net(), (stage - b.from - 1) * word + below? + lo))
        }
        None if bits == width(id) => names.net(id),
        None => Some(part(names.net(id)?, lo)),
    }
}
