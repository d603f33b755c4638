//! Every operation and every primitive at every width: plain arithmetic, interpreters and the emitted Verilog agree.
//! Operations as operands of others show lost parentheses, and contexts that widen or change a sign.
//! A missing Icarus fails these tests unless RELIEFRTL_NO_SIMULATORS=1.
mod icarus;
mod make;
mod reference;

use icarus::Batch;
use make::{ALL, O, Tree, module, parametric};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::bits::mask;
use reliefrtl::interp::{Lanes, Tracked, elaborate};
use reliefrtl::ir::{Binding, Module};
use reliefrtl::units::{
    div_rows::div_rows_module, interleave::interleave_module, lzc::lzc_module, sqrt_rows::sqrt_rows_module,
};
use std::sync::Arc;

/// Rows of operands for each module.
const ROWS: usize = 12;

fn word(rng: &mut ChaCha8Rng, width: u32) -> u64 {
    let v = match rng.random_range(0..7) {
        0 => 0,
        1 => u64::MAX,
        2 => 1 << rng.random_range(0..width),
        3 => u64::MAX << rng.random_range(0..width),
        4 => rng.random_range(0..=u64::from(width) + 1),
        _ => rng.random(),
    };
    v & mask(width)
}

/// Runs rows through reference and interpreters, and adds them to the batch for Icarus.
fn check(batch: &mut Batch, m: &Arc<Module>, b: &Binding, rng: &mut ChaCha8Rng, legal: impl Fn(&[u64]) -> bool) {
    let net = elaborate(m, b).unwrap();
    let b = m.binding_with(b);
    let mut rows = Vec::new();
    while rows.len() < ROWS {
        let row: Vec<u64> = net.inputs.iter().map(|p| word(rng, p.width)).collect();
        if legal(&row) {
            rows.push(row);
        }
    }
    let mut lanes = Lanes::new(&net, ROWS);
    let mut ports = Lanes::of_ports(&net, ROWS);
    for (lane, row) in rows.iter().enumerate() {
        for (p, v) in net.inputs.iter().zip(row) {
            lanes.set(p.slot, lane, *v);
            ports.set(p.slot, lane, *v);
        }
    }
    lanes.eval();
    ports.eval();
    let mut tracked = Tracked::new(&net);
    let mut expected = Vec::new();
    for (lane, row) in rows.iter().enumerate() {
        let want = reference::outputs(m, &b, row);
        net.inputs.iter().zip(row).for_each(|(p, v)| tracked.set(p.slot, *v));
        tracked.eval();
        for (p, want) in net.outputs.iter().zip(&want) {
            let got = [lanes.get(p.slot, lane), ports.get(p.slot, lane)];
            assert_eq!(got, [*want; 2], "{}.{} at {b:?} of {row:x?}", m.name, p.name);
            assert_eq!(tracked.get(p.slot), (*want, 0), "{}.{} at {b:?} of {row:x?}", m.name, p.name);
        }
        expected.push(want);
    }
    let widths = |ports: &[reliefrtl::interp::FlatPort]| ports.iter().map(|p| (p.name.clone(), p.width)).collect();
    batch.add(m, &b, widths(&net.inputs), widths(&net.outputs), &rows, &expected);
}

#[test]
fn operations_at_every_width() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut batch = Batch::new();
    for op in ALL {
        for w in (1..=64).filter(|w| op.gives(*w)) {
            // Operands of relations and reductions have widths of their own: more of them.
            for k in 0..if op.gives(2) { 1 } else { 40 } {
                let name = format!("t_{op:?}_{w}_{k}").to_lowercase();
                if let Some(m) = module(&name, &Tree::Op(op, vec![]), w, &mut rng) {
                    check(&mut batch, &m, &Binding::new(), &mut rng, |_| true);
                }
            }
        }
    }
    batch.run(13_000);
}

#[test]
fn parameters_at_every_width() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let mut batch = Batch::new();
    for op in ALL {
        let m = parametric(op);
        for w in 1..=64 {
            let b = Binding::from([("W".into(), w)]);
            if m.failed_checks(&b).is_empty() {
                check(&mut batch, &m, &b, &mut rng, |_| true);
            }
        }
    }
    for w in 1..=64i64 {
        let b = Binding::from([("W".into(), w)]);
        check(&mut batch, &lzc_module(8), &b, &mut rng, |_| true);
        if w <= 32 {
            check(&mut batch, &interleave_module(8), &b, &mut rng, |_| true);
        }
        if (2..=62).contains(&w) {
            let rows = if w % 3 == 0 { 64 } else { rng.random_range(1..=64) };
            let b = Binding::from([("W".into(), w), ("ROWS".into(), rows)]);
            // The remainder is below twice the divisor: take what a divisor with its top bit set allows.
            let legal = |row: &[u64]| row[0] < 2 * row[1];
            check(&mut batch, &div_rows_module(17, 19), &b, &mut rng, legal);
        }
        if (3..=61).contains(&w) {
            // Digits from FIRST on are still 0: few of them, for random words.
            let first = w - rng.random_range(1..=3.min(w - 1));
            let rows = rng.random_range(1..=w - first);
            let b = Binding::from([("W".into(), w), ("ROWS".into(), rows), ("FIRST".into(), first)]);
            let open = w - first;
            let legal = |row: &[u64]| {
                row[1] >> (w - 1) == 1 && row[1].is_multiple_of(1 << open) && row[0] < 2 * row[1] + (1 << open)
            };
            check(&mut batch, &sqrt_rows_module(18, 17), &b, &mut rng, legal);
        }
    }
    batch.run(15_000);
}

#[test]
fn operations_as_operands() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let mut batch = Batch::new();
    let mut pairs = 0;
    for outer in ALL {
        for inner in ALL {
            for place in 0..outer.operands(2, &mut rng).len() {
                let one_bit = outer == O::Rep || (outer == O::Mux && place == 0);
                if one_bit && !inner.gives(1) {
                    continue;
                }
                let tree = || {
                    let mut inside: Vec<Tree> = (0..place).map(|_| Tree::Leaf).collect();
                    inside.push(Tree::Op(inner, vec![]));
                    Tree::Op(outer, inside)
                };
                // Widths are drawn until both operations can have theirs; an operation of few widths needs many.
                let name = format!("t_{outer:?}_{place}_{inner:?}").to_lowercase();
                let found = (0..400).find_map(|_| {
                    let w = if rng.random() { rng.random_range(1..=3) } else { rng.random_range(1..=64) };
                    module(&name, &tree(), w, &mut rng)
                });
                let m = found.unwrap_or_else(|| panic!("{name}: no widths fit"));
                check(&mut batch, &m, &Binding::new(), &mut rng, |_| true);
                pairs += 1;
            }
        }
    }
    println!("{pairs} pairs");
    for k in 0..400 {
        let w = if rng.random() { rng.random_range(1..=8) } else { rng.random_range(1..=64) };
        if let Some(m) = module(&format!("t_deep_{k}"), &deep(&mut rng, 4), w, &mut rng) {
            check(&mut batch, &m, &Binding::new(), &mut rng, |_| true);
        }
    }
    batch.run(10_000);
}

/// A tree of operations that can have any width.
fn deep(rng: &mut ChaCha8Rng, depth: u32) -> Tree {
    const ANY: [O; 10] = [O::Not, O::And, O::Or, O::Xor, O::Add, O::Sub, O::Shl, O::Shr, O::Sar, O::Mux];
    if depth == 0 {
        return Tree::Leaf;
    }
    let op = ANY[rng.random_range(0..ANY.len())];
    Tree::Op(op, (0..3).map(|_| deep(rng, depth - 1)).collect())
}
