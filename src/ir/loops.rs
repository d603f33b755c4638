//! Combinational paths: through a module from its inputs to its outputs, and round in a circle, which no module may have.
use super::module::*;
use super::prim::Prim;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Of each output port, the input ports that it depends on in the same clock.
type Through = BTreeMap<usize, BTreeSet<usize>>;

/// The instances' paths, each module's once.
#[derive(Default)]
struct Known(BTreeMap<*const Module, Through>);

/// The nodes of a combinational loop in `m`, which may pass through instances, in the order in which values flow; `None` if there is none.
pub(super) fn combinational_loop(m: &Module) -> Option<Vec<NodeId>> {
    let mut known = Known::default();
    let reads = reads(m, &mut known);
    circle(&reads)
}

/// The nodes that each node reads in the same clock.
fn reads(m: &Module, known: &mut Known) -> Vec<Vec<NodeId>> {
    let through: Vec<Through> = m.insts.iter().map(|i| known.of(&i.module)).collect();
    let of = |n: &Node| match n.op {
        Op::Reg { .. } => Vec::new(),
        Op::InstOut(k, port) => {
            let inputs = m.insts[k.0 as usize].inputs.iter();
            let ports = through[k.0 as usize].get(&port);
            inputs.filter(|(p, _)| ports.is_some_and(|ports| ports.contains(p))).map(|(_, v)| *v).collect()
        }
        _ => n.args.clone(),
    };
    m.nodes.iter().map(of).collect()
}

impl Known {
    fn of(&mut self, m: &Arc<Module>) -> Through {
        let key = Arc::as_ptr(m);
        if let Some(known) = self.0.get(&key) {
            return known.clone();
        }
        let through = match m.body {
            Body::Prim(Prim::Lzc | Prim::Interleave | Prim::DivRows | Prim::SqrtRows) => {
                let inputs: BTreeSet<usize> = m.data_inputs().map(|(i, _)| i).collect();
                m.data_outputs().map(|(o, _)| (o, inputs.clone())).collect()
            }
            // All others have a register between.
            Body::Prim(Prim::Memory | Prim::FifoMem | Prim::Banks | Prim::DelayLine | Prim::RecipTable) => {
                Through::new()
            }
            Body::Graph => {
                let reads = reads(m, self);
                m.outputs.iter().map(|(port, v)| (*port, inputs_before(m, &reads, *v))).collect()
            }
        };
        self.0.insert(key, through.clone());
        through
    }
}

/// Input ports that a node depends on in the same clock.
fn inputs_before(m: &Module, reads: &[Vec<NodeId>], from: NodeId) -> BTreeSet<usize> {
    let mut seen = vec![false; reads.len()];
    let (mut waiting, mut inputs) = (vec![from], BTreeSet::new());
    while let Some(v) = waiting.pop() {
        if std::mem::replace(&mut seen[v.0 as usize], true) {
            continue;
        }
        if let Op::Input(port) = m.node(v).op {
            inputs.insert(port);
        }
        waiting.extend(&reads[v.0 as usize]);
    }
    inputs
}

/// A circle in a graph, in the order in which the values flow; `None` if it has none.
fn circle(reads: &[Vec<NodeId>]) -> Option<Vec<NodeId>> {
    #[derive(Clone, Copy, PartialEq)]
    enum Seen {
        Not,
        OnPath,
        Done,
    }
    let mut seen = vec![Seen::Not; reads.len()];
    for root in 0..reads.len() as u32 {
        // The path from the root, each node with the number of operands that were followed.
        let mut path: Vec<(NodeId, usize)> = Vec::new();
        if seen[root as usize] == Seen::Not {
            seen[root as usize] = Seen::OnPath;
            path.push((NodeId(root), 0));
        }
        while let Some((node, followed)) = path.last_mut() {
            let Some(next) = reads[node.0 as usize].get(*followed).copied() else {
                seen[node.0 as usize] = Seen::Done;
                path.pop();
                continue;
            };
            *followed += 1;
            match seen[next.0 as usize] {
                Seen::Done => {}
                Seen::Not => {
                    seen[next.0 as usize] = Seen::OnPath;
                    path.push((next, 0));
                }
                Seen::OnPath => {
                    let start = path.iter().position(|(n, _)| *n == next).expect("it is on the path");
                    return Some(path[start..].iter().rev().map(|(n, _)| *n).collect());
                }
            }
        }
    }
    None
}
