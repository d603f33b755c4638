//! Long waits out of registers: values that only wait, clock after clock, do so in a delay line.
use super::module::*;
use std::sync::Arc;

/// Values of fewer bits wait in registers at any length: a line's counter would take more than they do.
const LEAST_BITS: i64 = 4;

/// How a module's waits become delay lines.
pub struct Lines {
    /// Shortest wait, in clocks, that becomes a line.
    pub least: u32,
    /// Longest line, in clocks; what waits longer passes several.
    pub most: u32,
    /// The line: parameters W and CLOCKS, clock, enable, `in_data` to `out_data`.
    pub line: Arc<Module>,
}

/// `m` with its waits in delay lines, and so all below it: registers in a row that reset does not clear, of which nothing reads but the last.
/// Results and clocks stay as they are.
pub fn with_lines(m: &Arc<Module>, lines: &Lines) -> Arc<Module> {
    if m.body != Body::Graph || m.name == lines.line.name {
        return m.clone();
    }
    let mut new = Module::clone(m);
    new.insts.iter_mut().for_each(|i| i.module = with_lines(&i.module, lines));
    let waits = waits(&new, lines);
    if !waits.is_empty() {
        replace(&mut new, &waits, lines);
        let problems = super::verify::verify(&new, &[]);
        assert!(problems.is_empty(), "module {} with delay lines is wrong:\n  {}", new.name, problems.join("\n  "));
    }
    Arc::new(new)
}

/// A row of registers: what enters it, and the registers.
struct Wait {
    from: NodeId,
    regs: Vec<NodeId>,
}

fn waits(m: &Module, lines: &Lines) -> Vec<Wait> {
    let mut readers = vec![0u32; m.nodes.len()];
    let reads = m.nodes.iter().flat_map(|n| n.args.iter());
    let reads = reads.chain(m.outputs.iter().map(|o| &o.1)).chain(&m.unused);
    reads.chain(m.insts.iter().flat_map(|i| i.inputs.iter().map(|x| &x.1))).for_each(|id| readers[id.0 as usize] += 1);
    let defaults = m.default_binding();
    let plain = |id: NodeId| {
        let n = m.node(id);
        n.op == Op::Reg { reset: false, wrap: false, unknown: None } && n.width.eval(&defaults) >= LEAST_BITS
    };
    // The register after each register, where that one alone reads it.
    let mut after = vec![None; m.nodes.len()];
    let ids = || (0..m.nodes.len() as u32).map(NodeId);
    for id in ids().filter(|id| plain(*id)) {
        let from = m.node(id).args[0];
        if plain(from) && readers[from.0 as usize] == 1 {
            after[from.0 as usize] = Some(id);
        }
    }
    let mut list = Vec::new();
    for first in ids().filter(|id| plain(*id)) {
        let from = m.node(first).args[0];
        if after[from.0 as usize] == Some(first) {
            continue;
        }
        let row: Vec<NodeId> = std::iter::successors(Some(first), |id| after[id.0 as usize]).collect();
        // In equal parts, if one line is too short for it.
        let parts = row.len().div_ceil(lines.most as usize);
        let mut from = from;
        for regs in row.chunks(row.len().div_ceil(parts)).filter(|_| row.len() >= lines.least as usize) {
            if regs.len() >= lines.least as usize {
                list.push(Wait { from, regs: regs.to_vec() });
            }
            from = *regs.last().expect("chunks are not empty");
        }
    }
    list
}

fn replace(m: &mut Module, waits: &[Wait], lines: &Lines) {
    let (input, output) = (port(&lines.line, "in_data"), port(&lines.line, "out_data"));
    let enable = lines.line.ce.expect("a line has an enable");
    let own = m.ce.map(|p| m.nodes.iter().position(|n| n.op == Op::Input(p)).expect("the enable has a node"));
    let mut gone = vec![false; m.nodes.len()];
    // Without an enable of its own, the module's lines always move: a constant, before all that reads it.
    let always = own.is_none().then(|| Node {
        op: Op::Lit(1),
        args: vec![],
        width: 1.into(),
        name: None,
        stage: None,
        section: 0,
        valid: false,
        doc: None,
        handshaked: false,
    });
    let shift = always.is_some() as u32;
    for w in waits {
        let last = *w.regs.last().expect("a wait has registers");
        w.regs.iter().filter(|r| **r != last).for_each(|r| gone[r.0 as usize] = true);
        let id = InstId(m.insts.len() as u32);
        let (from, node) = (m.node(w.from).clone(), m.node(last).clone());
        let net = node.name.as_ref().expect("registers have names");
        let stage = from.stage.map_or(String::new(), |s| format!("s{s}_"));
        m.insts.push(Instance {
            module: lines.line.clone(),
            name: format!("u_line_{stage}{net}"),
            files: vec![],
            params: vec![("W".into(), node.width.clone()), ("CLOCKS".into(), (w.regs.len() as i64).into())],
            // The enable by its index before the renumbering below, which a new constant comes before.
            inputs: vec![(enable, NodeId(own.unwrap_or_default() as u32)), (input, w.from)],
            stage: from.stage,
            section: node.section,
        });
        m.insts.last_mut().expect("just pushed").inputs.sort();
        let n = &mut m.nodes[last.0 as usize];
        (n.op, n.args) = (Op::InstOut(id, output), vec![]);
    }
    let mut next = shift;
    let place: Vec<NodeId> = gone
        .iter()
        .map(|g| {
            next += u32::from(!g);
            NodeId(next - u32::from(!g))
        })
        .collect();
    let to = |id: &mut NodeId| *id = place[id.0 as usize];
    let kept = std::mem::take(&mut m.nodes).into_iter().zip(&gone).filter(|(_, g)| !**g).map(|(n, _)| n);
    m.nodes = always.into_iter().chain(kept).collect();
    m.nodes.iter_mut().flat_map(|n| n.args.iter_mut()).for_each(to);
    m.outputs.iter_mut().for_each(|o| to(&mut o.1));
    m.unused.iter_mut().for_each(to);
    for i in &mut m.insts {
        for (p, id) in &mut i.inputs {
            let free = i.module.name == lines.line.name && *p == enable && shift == 1;
            if free { *id = NodeId(0) } else { to(id) }
        }
    }
}

fn port(m: &Module, name: &str) -> usize {
    m.port(name).expect("a line has its ports").0
}
