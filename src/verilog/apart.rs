//! Bundles that come out of an instance: where slices take one apart, the instance drives their nets, as one concatenation.
use reliefrtl_ir::{Expr, Module, NodeId, Op};
use std::collections::{BTreeMap, BTreeSet};

/// Outputs of instances that are taken apart.
pub struct Apart {
    /// The parts of each, first on top.
    outputs: BTreeMap<NodeId, Vec<NodeId>>,
    parts: BTreeSet<NodeId>,
}

impl Apart {
    /// Finds the outputs without a name of which nothing reads but slices with names, each bit once.
    pub fn of(m: &Module) -> Self {
        let unnamed = |id: NodeId| matches!(m.node(id).op, Op::InstOut(..)) && m.node(id).name.is_none();
        let mut outputs: BTreeMap<NodeId, Vec<NodeId>> = BTreeMap::new();
        let mut read_whole: BTreeSet<NodeId> = m.outputs.iter().map(|o| o.1).chain(m.unused.iter().copied()).collect();
        read_whole.extend(m.insts.iter().flat_map(|i| i.inputs.iter().map(|x| x.1)));
        for (k, n) in m.nodes.iter().enumerate() {
            for from in n.args.iter().filter(|a| unnamed(**a)) {
                match (&n.op, &n.name) {
                    (Op::Slice { .. }, Some(_)) => outputs.entry(*from).or_default().push(NodeId(k as u32)),
                    _ => drop(read_whole.insert(*from)),
                }
            }
        }
        outputs.retain(|whole, parts| !read_whole.contains(whole) && covers(m, *whole, parts));
        Self { parts: outputs.values().flatten().copied().collect(), outputs }
    }

    /// The parts of an output, first on top, if it is taken apart.
    pub fn parts(&self, output: NodeId) -> Option<&[NodeId]> {
        self.outputs.get(&output).map(Vec::as_slice)
    }

    /// Whether an instance drives the net of this slice.
    pub fn is_part(&self, id: NodeId) -> bool {
        self.parts.contains(&id)
    }
}

/// Whether the slices follow each other from the top bit of `whole` to its last.
fn covers(m: &Module, whole: NodeId, parts: &[NodeId]) -> bool {
    let mut above = m.node(whole).width.expanded();
    let follows = parts.iter().all(|id| {
        let Op::Slice { lo } = &m.node(*id).op else { return false };
        let top = (lo + m.node(*id).width.clone()).expanded();
        let joins = top == above;
        above = lo.expanded();
        joins
    });
    follows && above == Expr::from(0)
}
