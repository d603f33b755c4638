//! The rules a module keeps, checked before anything is printed or run; all problems at once.
use super::expr::{Binding, Expr};
use super::keywords::is_keyword;
use super::loops::combinational_loop;
use super::module::*;
use super::names::Names;
use super::prim::Prim;
use reliefrtl_base::bits::{MAX_BUNDLE, MAX_WIDTH};
use std::collections::BTreeSet;

/// Checks `m` at its defaults and at `bindings`; returns every problem found.
pub fn verify(m: &Module, bindings: &[Binding]) -> Vec<String> {
    let mut bad = Vec::new();
    names(m, &mut bad);
    if m.body != Body::Graph {
        return bad;
    }
    structure(m, &mut bad);
    if bad.is_empty() {
        declared(m, &mut bad);
        no_loop(m, &mut bad);
    }
    stages(m, &mut bad);
    latency(m, &mut bad);
    if m.latency().is_some() {
        every_stage_counts(m, &mut bad);
    }
    unused(m, &mut bad);
    let mut all = vec![m.default_binding()];
    all.extend(bindings.iter().map(|b| m.binding_with(b)));
    for b in all.iter().filter(|b| m.failed_checks(b).is_empty()) {
        widths(m, b, &mut bad);
    }
    bad.dedup();
    bad
}

fn label(m: &Module, id: NodeId) -> String {
    let n = m.node(id);
    format!("{} {}", n.op.name(), n.name.clone().unwrap_or_else(|| format!("#{}", id.0)))
}

/// Whether Verilog takes a name as it is.
fn legal(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !is_keyword(name)
}

/// Everything that a module declares has one name space in Verilog: parameters, localparams, ports, nets and instances.
fn declared(m: &Module, bad: &mut Vec<String>) {
    if !legal(&m.name) {
        bad.push(format!("module name {} is not usable in Verilog", m.name));
    }
    let mut seen: BTreeSet<String> = m.ports.iter().map(|p| p.name.clone()).collect();
    // Of the contract with an instance.
    seen.extend(["LATENCY".to_owned(), "VARIANT".to_owned()]);
    let printed = Names::new(m);
    let nets: BTreeSet<String> = (0..m.nodes.len() as u32)
        .filter(|i| !matches!(m.nodes[*i as usize].op, Op::Input(_)) && printed.owns_net(NodeId(*i)))
        .filter_map(|i| printed.net(NodeId(i)))
        .collect();
    let params = m.params.iter().map(|p| ("parameter", &p.name));
    let locals = m.locals.iter().map(|l| ("localparam", &l.name));
    let insts = m.insts.iter().map(|i| ("instance", &i.name));
    let files = m.files.iter().map(|f| ("parameter", &f.name));
    for (what, name) in params.chain(files).chain(locals).chain(nets.iter().map(|n| ("net", n))).chain(insts) {
        if !legal(name) {
            bad.push(format!("{what} name {name} is not usable in Verilog"));
        }
        if !seen.insert(name.clone()) {
            bad.push(format!("{what} {name} has the name of something else in the module"));
        }
    }
}

fn names(m: &Module, bad: &mut Vec<String>) {
    let mut seen = BTreeSet::new();
    for p in &m.ports {
        if !legal(&p.name) {
            bad.push(format!("port name {} is not usable in Verilog", p.name));
        }
        if !seen.insert(p.name.clone()) {
            bad.push(format!("port {} is declared twice", p.name));
        }
    }
    let mut staged = BTreeSet::new();
    for n in m.nodes.iter().filter(|n| !matches!(n.op, Op::Input(_))) {
        if let Some(name) = &n.name {
            if !legal(name) {
                bad.push(format!("name {name} is not usable in Verilog"));
            }
            let twin = |o: &Node| o.name == n.name && matches!(o.op, Op::Konst(_)) && o.op == n.op;
            let same_constant = m.nodes.iter().filter(|o| o.name == n.name).all(twin);
            if !staged.insert((name.clone(), n.stage)) && !same_constant {
                bad.push(format!("two values are named {name} in stage {:?}", n.stage));
            }
        }
    }
}

fn structure(m: &Module, bad: &mut Vec<String>) {
    for (i, p) in m.ports.iter().enumerate().filter(|(_, p)| p.dir == Dir::Out) {
        match m.outputs.iter().filter(|o| o.0 == i).count() {
            1 => {}
            k => bad.push(format!("output {} is driven {k} times", p.name)),
        }
    }
    for (i, n) in m.nodes.iter().enumerate() {
        if matches!(n.op, Op::Reg { .. } | Op::Wire) {
            if n.args.len() != 1 {
                bad.push(format!("{} is not driven", label(m, NodeId(i as u32))));
            }
        } else if n.args.iter().any(|a| a.0 as usize >= i) {
            bad.push(format!("{} reads a later value: a loop", label(m, NodeId(i as u32))));
        }
        if matches!(n.op, Op::Reg { .. }) && m.clk.is_none() {
            bad.push(format!("{} needs a clock, and the module has none", label(m, NodeId(i as u32))));
        }
    }
    for i in m.insts.iter().filter(|i| i.module.clk.is_some() && m.clk.is_none()) {
        bad.push(format!("{} needs a clock, and the module has none", i.name));
    }
}

fn stages(m: &Module, bad: &mut Vec<String>) {
    for (i, n) in m.nodes.iter().enumerate() {
        let me = label(m, NodeId(i as u32));
        for a in &n.args {
            let (Some(sa), Some(sn)) = (m.node(*a).stage, n.stage) else { continue };
            let want = match n.op {
                Op::Reg { wrap: true, .. } => continue,
                Op::Reg { .. } => sn.checked_sub(1),
                _ => Some(sn),
            };
            if want != Some(sa) {
                bad.push(format!("{me} of stage {sn} reads {} of stage {sa} without a delay", label(m, *a)));
            }
        }
    }
    for inst in &m.insts {
        for (port, v) in &inst.inputs {
            let (Some(sv), Some(si)) = (m.node(*v).stage, inst.stage) else { continue };
            if inst.module.ports[*port].stage.is_some() && sv != si {
                bad.push(format!("{} of stage {si} reads {} of stage {sv} without a delay", inst.name, label(m, *v)));
            }
        }
    }
}

/// Registers and wires are the only nodes that read later ones, so a loop goes through one of these wires.
fn no_loop(m: &Module, bad: &mut Vec<String>) {
    if let Some(around) = combinational_loop(m) {
        let names: Vec<String> = around.iter().map(|id| label(m, *id)).collect();
        bad.push(format!("a combinational loop: {} -> {}", names.join(" -> "), names[0]));
    }
}

/// In a module of a fixed latency nothing loses its stage and no register is read as if it were none: else outputs would come later, or earlier,
/// than the stage says. A register that only replaces its own input while the clock enable is 0 changes no clock.
fn every_stage_counts(m: &Module, bad: &mut Vec<String>) {
    for (i, n) in m.nodes.iter().enumerate() {
        let (id, me) = (NodeId(i as u32), label(m, NodeId(i as u32)));
        if n.stage.is_none() {
            let staged = n.args.iter().find(|a| m.node(**a).stage.is_some() && !m.node(**a).op.is_const());
            bad.extend(staged.map(|a| {
                format!(
                    "{me} belongs to no stage and reads {}: in a module of a fixed latency each stage counts",
                    label(m, *a)
                )
            }));
        }
        if matches!(n.op, Op::Reg { wrap: true, .. }) {
            let enable = |a: NodeId| matches!(m.node(a).op, Op::Input(p) if Some(p) == m.ce);
            let holds = |r: &Node| {
                r.op == Op::Mux && enable(r.args[0]) && Some(&r.args[1]) == n.args.first() && r.args[2] == id
            };
            if m.nodes.iter().filter(|r| r.args.contains(&id)).any(|r| !holds(r)) || m.outputs.iter().any(|o| o.1 == id)
            {
                bad.push(format!(
                    "{me} of a loop in a module of a fixed latency: finish_streams ends a module with a loop"
                ));
            }
        }
    }
}

/// The module's end has brought all outputs to one stage, its latency, and nothing has moved them since. (A primitive has no stages; constants
/// belong to none.)
fn latency(m: &Module, bad: &mut Vec<String>) {
    let Some(latency) = m.latency() else { return };
    for (port, v) in &m.outputs {
        let name = &m.ports[*port].name;
        match m.node(*v).stage {
            Some(stage) if stage != latency => {
                bad.push(format!("output {name} stands in stage {stage}, and the module's latency is {latency}"));
            }
            None if !m.node(*v).op.is_const() && m.data_inputs().any(|(_, p)| p.stage.is_some()) => {
                bad.push(format!("output {name} belongs to no stage, and the module's latency is {latency}"));
            }
            _ => {}
        }
    }
}

fn unused(m: &Module, bad: &mut Vec<String>) {
    let mut used = vec![false; m.nodes.len()];
    let reads = m.nodes.iter().flat_map(|n| n.args.iter().copied());
    let reads = reads.chain(m.outputs.iter().map(|o| o.1)).chain(m.unused.iter().copied());
    let reads = reads.chain(m.insts.iter().flat_map(|i| i.inputs.iter().map(|x| x.1)));
    reads.for_each(|id| used[id.0 as usize] = true);
    for (i, n) in m.nodes.iter().enumerate().filter(|(i, _)| !used[*i]) {
        let control = matches!(n.op, Op::Input(p) if [m.ce, m.rst].contains(&Some(p)));
        if !control {
            bad.push(format!("{} is never used", label(m, NodeId(i as u32))));
        }
    }
}

fn widths(m: &Module, b: &Binding, bad: &mut Vec<String>) {
    let w = |id: NodeId| m.node(id).width.eval(b);
    let at = || b.iter().map(|(k, v)| format!("{k}={v}")).collect::<Vec<_>>().join(" ");
    for (i, n) in m.nodes.iter().enumerate() {
        let id = NodeId(i as u32);
        let width = n.width.eval(b);
        let a: Vec<i64> = n.args.iter().map(|x| w(*x)).collect();
        let mut fail = |why: String| bad.push(format!("{}: {why} (at {})", label(m, id), at()));
        let most = if n.op.carries() { MAX_BUNDLE } else { MAX_WIDTH };
        if width < 1 || width > i64::from(most) {
            fail(format!("{width} bits; 1 to {most} are possible"));
            continue;
        }
        if let Some(wide) = a.iter().find(|w| !n.op.carries() && **w > i64::from(MAX_WIDTH)) {
            fail(format!("an operand of {wide} bits; a bundle is carried, not computed with"));
            continue;
        }
        let ok = match &n.op {
            Op::Lit(v) => width == 64 || *v < 1 << width,
            Op::Reg { unknown: Some(_), .. } => width == 1 && a == [1],
            Op::Not | Op::Reg { .. } | Op::Wire => a == [width],
            Op::And | Op::Or | Op::Xor | Op::Add | Op::Sub => a == [width, width],
            Op::RedOr | Op::RedAnd => width == 1,
            Op::Mul => width == a[0] + a[1],
            Op::Eq | Op::Ult | Op::Slt => a[0] == a[1] && width == 1,
            Op::Shl | Op::Shr | Op::Sar => a[0] == width,
            Op::Mux => a == [1, width, width],
            Op::Concat => a.iter().sum::<i64>() == width,
            Op::Slice { lo } => lo.eval(b) >= 0 && lo.eval(b) + width <= a[0],
            Op::Zext | Op::Sext => a[0] <= width,
            Op::Rep => a == [1],
            // Printed as a 32-bit integer unless the width says that it can't be one.
            Op::Konst(_) => width <= 32 || n.width.as_const().is_some(),
            Op::InstOut(..) | Op::Input(_) | Op::Zeros | Op::Ones => true,
        };
        if !ok {
            fail(format!("operands of {a:?} bits do not give {width} bits"));
        }
    }
    for inst in &m.insts {
        let map = inst.params.iter().cloned().collect();
        let carries = matches!(inst.module.body, Body::Graph | Body::Prim(Prim::FifoMem | Prim::DelayLine));
        for (p, v) in &inst.inputs {
            if !carries && w(*v) > i64::from(MAX_WIDTH) {
                bad.push(format!("{} is no unit for a bundle of {} bits (at {})", inst.name, w(*v), at()));
            }
            let want = inst.module.ports[*p].width.substitute(&map).eval(b);
            if want != w(*v) {
                let port = &inst.module.ports[*p].name;
                bad.push(format!("{}.{port} has {want} bits, its driver {} (at {})", inst.name, w(*v), at()));
            }
        }
        let inner: Binding = inst.params.iter().map(|(n, e): &(String, Expr)| (n.clone(), e.eval(b))).collect();
        bad.extend(inst.module.failed_checks(&inner).into_iter().map(|c| format!("{}: {c} (at {})", inst.name, at())));
    }
}
