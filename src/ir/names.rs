//! Names of a module's nets: base name and stage, the same in Verilog, waveforms and reports.
use super::module::{Module, Node, NodeId, Op};
use std::collections::BTreeMap;

/// Printed names of a module's nodes.
pub struct Names<'m> {
    /// The module.
    pub m: &'m Module,
    /// True when names carry their stage.
    pub staged: bool,
    /// Stage under which each node is printed.
    pub stage: Vec<u32>,
    /// Of each instance output without a name that drives a wire: the wire, whose net it drives itself.
    drives: BTreeMap<NodeId, NodeId>,
    /// Of each wire that a port or a register of a loop drives: that one, whose net is declared before all that reads it.
    driven: BTreeMap<NodeId, NodeId>,
}

impl<'m> Names<'m> {
    /// Names the nets of `m`.
    pub fn new(m: &'m Module) -> Self {
        let mut stage: Vec<u32> = Vec::with_capacity(m.nodes.len());
        for n in &m.nodes {
            let of_args =
                n.args.iter().filter(|_| n.op != Op::Wire).filter_map(|a| stage.get(a.0 as usize)).copied().max();
            stage.push(n.stage.unwrap_or(if matches!(n.op, Op::Reg { .. } | Op::Wire) {
                0
            } else {
                of_args.unwrap_or(0)
            }));
        }
        let staged = m.nodes.iter().any(|n| n.stage.is_some_and(|s| s > 0));
        let wires = m.nodes.iter().enumerate().filter(|(_, n)| n.op == Op::Wire);
        let direct = wires.filter_map(|(w, n)| n.args.first().map(|d| (*d, NodeId(w as u32))));
        let unnamed = |d: NodeId| matches!(m.node(d).op, Op::InstOut(..)) && m.node(d).name.is_none();
        let early = |d: NodeId| matches!(m.node(d).op, Op::Reg { wrap: true, .. } | Op::Input(_));
        let driven = direct.clone().filter(|(d, _)| early(*d)).map(|(d, wire)| (wire, d)).collect();
        let drives = direct.filter(|(d, _)| unnamed(*d)).collect();
        Self { m, staged, stage, drives, driven }
    }

    /// Whether an instance output drives the net of a wire, which is declared before it.
    pub fn drives_wire(&self, id: NodeId) -> bool {
        self.drives.contains_key(&id)
    }

    /// Whether a wire is another net, which is declared before it, so that it has none of its own.
    pub fn is_driven_early(&self, wire: NodeId) -> bool {
        self.driven.contains_key(&wire)
    }

    /// Whether the net of a node, if it has one, is called after it and not after another node.
    pub fn owns_net(&self, id: NodeId) -> bool {
        !self.drives_wire(id) && !self.is_driven_early(id)
    }

    /// Whether a node, or the bundle that it is a part of, comes out of a handshake.
    fn is_handshaked(&self, n: &Node) -> bool {
        let part_of = |n: &Node| matches!(n.op, Op::Slice { .. }) && self.m.node(n.args[0]).name.is_none();
        n.handshaked || part_of(n) && self.m.node(n.args[0]).handshaked
    }

    /// The net that carries a node, if it has one.
    pub fn net(&self, id: NodeId) -> Option<String> {
        let n = self.m.node(self.drives.get(&id).or(self.driven.get(&id)).copied().unwrap_or(id));
        match (&n.op, &n.name) {
            (Op::Input(p), _) => Some(self.m.ports[*p].name.clone()),
            (op, _) if op.is_const() => None,
            (_, Some(name)) => Some(match n.stage {
                Some(s) if self.staged && !self.is_handshaked(n) => format!("s{s}_{name}"),
                _ if self.m.port(name).is_some() => format!("{name}_net"),
                _ => name.clone(),
            }),
            _ => None,
        }
    }
}
