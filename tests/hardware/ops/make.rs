//! Small modules: one operation, or operations as operands of others, with nothing named that needs no name.
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use reliefrtl::ir::{BITS, Builder, Expr, Module, Sig};
use std::cell::Cell;
use std::sync::Arc;

/// The operations of the IR that compute something.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum O {
    Not,
    And,
    Or,
    Xor,
    RedOr,
    RedAnd,
    Add,
    Sub,
    Mul,
    Eq,
    Ult,
    Slt,
    Shl,
    Shr,
    Sar,
    Mux,
    Concat,
    Slice,
    Zext,
    Sext,
    Rep,
}

/// All of them.
pub const ALL: [O; 21] = [
    O::Not,
    O::And,
    O::Or,
    O::Xor,
    O::RedOr,
    O::RedAnd,
    O::Add,
    O::Sub,
    O::Mul,
    O::Eq,
    O::Ult,
    O::Slt,
    O::Shl,
    O::Shr,
    O::Sar,
    O::Mux,
    O::Concat,
    O::Slice,
    O::Zext,
    O::Sext,
    O::Rep,
];

impl O {
    /// True if the operation can give `w` bits.
    pub fn gives(self, w: u32) -> bool {
        match self {
            O::RedOr | O::RedAnd | O::Eq | O::Ult | O::Slt => w == 1,
            O::Mul | O::Concat | O::Zext | O::Sext => w >= 2,
            _ => true,
        }
    }
    /// Widths of the operands of a result of `w` bits.
    pub fn operands(self, w: u32, rng: &mut ChaCha8Rng) -> Vec<u32> {
        let any = if rng.random() { rng.random_range(1..=2) } else { rng.random_range(1..=64) };
        let part = if w > 1 { rng.random_range(1..w) } else { 1 };
        match self {
            O::Not => vec![w],
            O::And | O::Or | O::Xor | O::Add | O::Sub => vec![w, w],
            O::RedOr | O::RedAnd => vec![any],
            O::Eq | O::Ult | O::Slt => vec![any, any],
            O::Mul | O::Concat => vec![part, w - part],
            O::Shl | O::Shr | O::Sar => vec![w, rng.random_range(1..=8)],
            O::Mux => vec![1, w, w],
            O::Slice => vec![if rng.random() { w } else { rng.random_range(w..=64) }],
            O::Zext | O::Sext => vec![part],
            O::Rep => vec![1],
        }
    }
    /// The operation on `x`; `lo` is the lowest bit of a slice.
    pub fn apply<'b>(self, b: &'b Builder, x: &[Sig<'b>], w: impl Into<Expr>, lo: impl Into<Expr>) -> Sig<'b> {
        match self {
            O::Not => !x[0],
            O::And => x[0] & x[1],
            O::Or => x[0] | x[1],
            O::Xor => x[0] ^ x[1],
            O::RedOr => x[0].any(),
            O::RedAnd => x[0].all(),
            O::Add => x[0] + x[1],
            O::Sub => x[0] - x[1],
            O::Mul => x[0].product(x[1]),
            O::Eq => x[0].eq(x[1]),
            O::Ult => x[0].lt(x[1]),
            O::Slt => x[0].slt(x[1]),
            O::Shl => x[0].shift_left(x[1]),
            O::Shr => x[0].shift_right(x[1]),
            O::Sar => x[0].sar(x[1]),
            O::Mux => x[0].mux(x[1], x[2]),
            O::Concat => b.cat(x),
            O::Slice => x[0].slice(lo, w),
            O::Zext => x[0].zext(w),
            O::Sext => x[0].sext(w),
            O::Rep => x[0].rep(w),
        }
    }
    /// Only nets are indexed: the operand of these has a name.
    fn indexes(self) -> bool {
        matches!(self, O::Slice | O::Sext)
    }
}

/// What an operand is.
pub enum Tree {
    /// An input, or now and then a constant.
    Leaf,
    /// An operation; operands that are not given are leaves.
    Op(O, Vec<Tree>),
}

/// A module whose output `y` of `w` bits is `tree`.
pub fn module(name: &str, tree: &Tree, w: u32, rng: &mut ChaCha8Rng) -> Option<Arc<Module>> {
    let b = Builder::new(name, file!(), "a test of operations");
    let count = Cell::new(0);
    let y = build(&b, tree, w, false, &count, rng)?;
    let out = b.output("y", w, BITS, "result");
    b.drive(out, y);
    (count.get() > 0).then(|| b.finish(&[]))
}

fn build<'b>(
    b: &'b Builder,
    tree: &Tree,
    w: u32,
    named: bool,
    count: &Cell<u32>,
    rng: &mut ChaCha8Rng,
) -> Option<Sig<'b>> {
    let next = || {
        count.set(count.get() + 1);
        count.get() - 1
    };
    let Tree::Op(op, inner) = tree else {
        return Some(match rng.random_range(0..12) {
            0 if !named => b.zeros(w),
            1 if !named => b.ones(w),
            2 if !named => b.lit(rng.random::<u64>() & reliefrtl::bits::mask(w), w),
            3 if !named => b.konst(rng.random_range(0..1000i64), w).named(&format!("konst_{}", next())),
            _ => b.input(&format!("i{}", next()), w, BITS, "operand"),
        });
    };
    if !op.gives(w) {
        return None;
    }
    let widths = op.operands(w, rng);
    let mut x = Vec::new();
    for (k, width) in widths.iter().enumerate() {
        let leaf = Tree::Leaf;
        let v = build(b, inner.get(k).unwrap_or(&leaf), *width, op.indexes(), count, rng)?;
        let nested = matches!(inner.get(k), Some(Tree::Op(..)));
        x.push(if op.indexes() && nested { v.named(&format!("n{}", next())) } else { v });
    }
    let lo = if *op == O::Slice { rng.random_range(0..=widths[0] - w) } else { 0 };
    Some(op.apply(b, &x, w, lo))
}

/// The operation with its widths as expressions over the parameter W.
pub fn parametric(op: O) -> Arc<Module> {
    let b = Builder::new(&format!("p_{op:?}").to_lowercase(), file!(), "an operation at any width");
    let w = b.param("W", 8, "bits");
    let one = || Expr::from(1);
    let (operands, result): (Vec<Expr>, Expr) = match op {
        O::Not => (vec![w.clone()], w.clone()),
        O::And | O::Or | O::Xor | O::Add | O::Sub => (vec![w.clone(), w.clone()], w.clone()),
        O::RedOr | O::RedAnd => (vec![w.clone()], one()),
        O::Eq | O::Ult | O::Slt => (vec![w.clone(), w.clone()], one()),
        O::Mul => (vec![w.clone(), w.clone()], w.clone() * 2),
        O::Shl | O::Shr | O::Sar => (vec![w.clone(), (&w + 1).clog2()], w.clone()),
        O::Mux => (vec![one(), w.clone(), w.clone()], w.clone()),
        O::Concat => (vec![w.clone(), Expr::from(3)], &w + 3),
        O::Slice => (vec![&w + 3], w.clone()),
        O::Zext | O::Sext => (vec![w.clone()], &w + 3),
        O::Rep => (vec![one()], w.clone()),
    };
    b.require(1, &w);
    b.require(&result, 64);
    operands.iter().for_each(|o| b.require(o.clone(), 64));
    let x: Vec<Sig<'_>> =
        operands.iter().enumerate().map(|(k, o)| b.input(&format!("i{k}"), o, BITS, "operand")).collect();
    let y = op.apply(&b, &x, result.clone(), 2);
    let out = b.output("y", result, BITS, "result");
    b.drive(out, y);
    b.finish(&[])
}
