//! A unit's netlist bit by bit: operations as an and-inverter graph, written a second time, without a look at the interpreter's.
use super::aig::{Aig, FALSE, Lit, TRUE};
use reliefrtl::interp::{FlatOp, Kind, Netlist};
use std::collections::BTreeMap;

pub type Bits = Vec<Lit>;

/// What is known of the operands of a unit: 1 where it can get them.
pub type Legal<'a> = &'a dyn Fn(&mut Aig, &BTreeMap<&str, Bits>) -> Lit;

/// The graph of `net` and its outputs, all ports in order, lowest bit first; where the operands are not legal they are 0. Registers are wires,
/// which in a pipeline without a way back is what comes out after its latency.
pub fn blast(net: &Netlist, legal: Legal) -> (Aig, Bits) {
    assert!(net.mems.is_empty(), "a memory has no bits here");
    let mut g = Aig::new(net.inputs.iter().map(|p| net.widths[p.slot as usize]).sum());
    let mut slots: Vec<Option<Bits>> = vec![None; net.widths.len()];
    let mut next = 0;
    let mut ports = BTreeMap::new();
    for p in &net.inputs {
        let width = net.widths[p.slot as usize];
        // The clock enable stays 1.
        let bits: Bits = (next..next + width).map(|k| if p.name == "ce" { TRUE } else { g.input(k) }).collect();
        ports.insert(p.name.as_str(), bits.clone());
        slots[p.slot as usize] = Some(bits);
        next += width;
    }
    let legal = legal(&mut g, &ports);
    for (slot, value) in &net.consts {
        let width = net.widths[*slot as usize];
        slots[*slot as usize] = Some((0..width).map(|k| Lit::from(value >> k & 1 == 1)).collect());
    }
    // An operation may read a register that a later one feeds, so this takes a pass a stage.
    let outputs = |slots: &[Option<Bits>]| -> Option<Bits> {
        net.outputs.iter().map(|p| slots[p.slot as usize].clone()).collect::<Option<Vec<_>>>().map(|b| b.concat())
    };
    for _ in 0..=net.regs.len() + 1 {
        for (k, op) in net.ops.iter().enumerate() {
            let slot = net.first_op as usize + k;
            let args: Option<Vec<Bits>> = op.args.iter().map(|a| slots[*a as usize].clone()).collect();
            if let (None, Some(args)) = (&slots[slot], args) {
                slots[slot] = Some(operation(&mut g, op, &args));
            }
        }
        for r in &net.regs {
            slots[r.q as usize] = slots[r.d as usize].clone();
        }
        if let Some(bits) = outputs(&slots) {
            let bits = bits.into_iter().map(|b| g.and(b, legal)).collect();
            return (g, bits);
        }
    }
    panic!("the netlist has a way back")
}

fn operation(g: &mut Aig, op: &FlatOp, args: &[Bits]) -> Bits {
    let w = op.width as usize;
    let (a, b, c) = (&args[0], &args[1], &args[2]);
    let each =
        |g: &mut Aig, f: fn(&mut Aig, Lit, Lit) -> Lit| -> Bits { (0..w).map(|k| f(g, at(a, k), at(b, k))).collect() };
    match op.kind {
        Kind::Copy => (0..w).map(|k| at(a, k)).collect(),
        Kind::Not => (0..w).map(|k| at(a, k) ^ 1).collect(),
        Kind::And => each(g, Aig::and),
        Kind::Or => each(g, Aig::or),
        Kind::Xor => each(g, Aig::xor),
        Kind::RedOr => vec![any(g, a)],
        Kind::RedAnd => {
            let zeros: Bits = (0..op.arg_width as usize).map(|k| at(a, k) ^ 1).collect();
            vec![any(g, &zeros) ^ 1]
        }
        Kind::Add => sum(g, a, b, FALSE, w).0,
        Kind::Sub => difference(g, a, b, w).0,
        Kind::Mul => product(g, a, b, w),
        Kind::Eq => {
            let apart: Bits = (0..a.len().max(b.len())).map(|k| g.xor(at(a, k), at(b, k))).collect();
            vec![any(g, &apart) ^ 1]
        }
        Kind::Ult => vec![difference(g, a, b, a.len().max(b.len())).1],
        Kind::Slt => {
            let flip = |x: &Bits| -> Bits {
                let top = op.arg_width as usize - 1;
                (0..=top).map(|k| at(x, k) ^ Lit::from(k == top)).collect()
            };
            vec![difference(g, &flip(a), &flip(b), op.arg_width as usize).1]
        }
        Kind::Shl => shifted(g, a, b, w, FALSE, |k, by| k.checked_sub(by)),
        Kind::Shr => shifted(g, a, b, w, FALSE, |k, by| Some(k + by)),
        Kind::Sar => shifted(g, a, b, w, at(a, w - 1), |k, by| Some(k + by)),
        Kind::Mux => (0..w).map(|k| g.mux(a[0], at(b, k), at(c, k))).collect(),
        Kind::Join => {
            let low = op.aux as usize;
            (0..w).map(|k| if k < low { at(b, k) } else { at(a, k - low) }).collect()
        }
        Kind::Slice => (0..w).map(|k| at(a, k + op.aux as usize)).collect(),
        Kind::Sext => (0..w).map(|k| at(a, k.min(op.arg_width as usize - 1))).collect(),
        Kind::Rep => vec![a[0]; w],
        Kind::Lzc => leading_zeros(g, a, op.arg_width as usize, w),
        Kind::Interleave => (0..w).map(|k| if k % 2 == 0 { at(a, k / 2) } else { at(b, k / 2) }).collect(),
        Kind::DivRem => rows(g, a, b, op).0,
        Kind::DivQuot => rows(g, a, b, op).1,
        Kind::RecipTable => panic!("the table of reciprocals has no bits here"),
    }
}

fn at(bits: &Bits, k: usize) -> Lit {
    bits.get(k).copied().unwrap_or(FALSE)
}

fn any(g: &mut Aig, bits: &Bits) -> Lit {
    bits.iter().fold(FALSE, |x, b| g.or(x, *b))
}

fn sum(g: &mut Aig, a: &Bits, b: &Bits, mut carry: Lit, w: usize) -> (Bits, Lit) {
    let mut bits = Bits::new();
    for k in 0..w {
        let (bit, up) = g.add(at(a, k), at(b, k), carry);
        bits.push(bit);
        carry = up;
    }
    (bits, carry)
}

/// Difference, and whether it borrows.
pub fn difference(g: &mut Aig, a: &Bits, b: &Bits, w: usize) -> (Bits, Lit) {
    let inverted: Bits = (0..w).map(|k| at(b, k) ^ 1).collect();
    let (bits, carry) = sum(g, a, &inverted, TRUE, w);
    (bits, carry ^ 1)
}

fn product(g: &mut Aig, a: &Bits, b: &Bits, w: usize) -> Bits {
    let mut total = vec![FALSE; w];
    for (k, bit) in b.iter().enumerate().take(w) {
        let row: Bits = (0..w).map(|i| if i < k { FALSE } else { g.and(at(a, i - k), *bit) }).collect();
        total = sum(g, &total, &row, FALSE, w).0;
    }
    total
}

/// A step for each bit of the amount; `from` says which bit comes to place `k`.
fn shifted(g: &mut Aig, a: &Bits, amount: &Bits, w: usize, fill: Lit, from: fn(usize, usize) -> Option<usize>) -> Bits {
    let mut bits: Bits = (0..w).map(|k| at(a, k)).collect();
    for (step, bit) in amount.iter().enumerate() {
        let by = if step < 7 { (1usize << step).min(w) } else { w };
        let old = bits.clone();
        let moved = |k: usize| from(k, by).and_then(|k| old.get(k).copied()).unwrap_or(fill);
        bits = (0..w).map(|k| g.mux(*bit, moved(k), old[k])).collect();
    }
    bits
}

fn leading_zeros(g: &mut Aig, a: &Bits, from: usize, w: usize) -> Bits {
    let number = |n: usize| -> Bits { (0..w).map(|k| Lit::from(n >> k & 1 == 1)).collect() };
    let mut count = number(from);
    for k in 0..from {
        let here = number(from - 1 - k);
        count = (0..w).map(|i| g.mux(at(a, k), here[i], count[i])).collect();
    }
    count
}

/// Remainder and quotient bits of rows of restoring division.
fn rows(g: &mut Aig, a: &Bits, b: &Bits, op: &FlatOp) -> (Bits, Bits) {
    let w = op.arg_width as usize;
    let mut rest: Bits = (0..w).map(|k| at(a, k)).collect();
    let mut quotient = Bits::new();
    for _ in 0..op.aux {
        let (less, borrow) = difference(g, &rest, b, w);
        let kept: Bits = (0..w).map(|k| g.mux(borrow, rest[k], less[k])).collect();
        rest = std::iter::once(FALSE).chain(kept.into_iter().take(w - 1)).collect();
        quotient.insert(0, borrow ^ 1);
    }
    (rest, quotient)
}
