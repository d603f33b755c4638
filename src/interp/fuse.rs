//! Pairs of operations that run as one: most of an operation's time goes into fetching and storing its words.
use super::kernel::Code;
use super::netlist::*;

/// The operations as they are run: `None` for those that became part of the one operation that reads them.
pub(super) fn fuse(net: &Netlist) -> Vec<Option<(Code, FlatOp)>> {
    let mut shapes: Vec<Option<(Code, FlatOp)>> = net.ops.iter().map(|op| Some((Code::Plain, *op))).collect();
    let mut readers = vec![0u32; net.widths.len()];
    for op in &net.ops {
        let [a, b, c] = op.args;
        readers[a as usize] += 1;
        readers[b as usize] += u32::from(b != a);
        readers[c as usize] += u32::from(c != a && c != b);
    }
    net.outputs.iter().for_each(|p| readers[p.slot as usize] += 2);
    for r in &net.regs {
        [Some(r.d), r.enable, r.reset].into_iter().flatten().for_each(|s| readers[s as usize] += 2);
    }
    for m in &net.mems {
        [m.write_en, m.write_addr, m.write_data, m.read_addr].into_iter().for_each(|s| readers[s as usize] += 2);
    }
    for i in 0..net.ops.len() {
        let op = net.ops[i];
        if op.width > 32 || !matches!(op.kind, Kind::And | Kind::Or) {
            continue;
        }
        // An operand that nothing else reads, and that is still an operation of its own.
        let inner = |k: usize| {
            let s = op.args[k];
            let at = s.checked_sub(net.first_op).filter(|_| readers[s as usize] == 1)? as usize;
            let (code, inner) = shapes[at]?;
            (code == Code::Plain).then_some((at, inner))
        };
        let found = [0, 1].into_iter().find_map(|k| {
            let (at, inner) = inner(k)?;
            let (code, [x, y]) = match (op.kind, inner.kind) {
                (Kind::And, Kind::Not) => (Code::AndNot, [inner.args[0]; 2]),
                (Kind::Or, Kind::Not) => (Code::OrNot, [inner.args[0]; 2]),
                (Kind::Or, Kind::And) => (Code::AndOr, [inner.args[0], inner.args[1]]),
                (Kind::And, Kind::Or) => (Code::OrAnd, [inner.args[0], inner.args[1]]),
                _ => return None,
            };
            Some((at, code, [op.args[1 - k], x, y]))
        });
        if let Some((at, code, args)) = found {
            shapes[at] = None;
            shapes[i] = Some((code, FlatOp { args, ..op }));
        }
    }
    shapes
}
