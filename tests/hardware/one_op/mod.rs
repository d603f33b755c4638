//! Netlists of one operation, and operands for them.
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use reliefrtl::bits::mask;
use reliefrtl::interp::{FlatOp, FlatPort, Kind, Netlist, Slot};

/// A netlist of one operation with inputs `a`, `b`, `c` of the given widths, and the operation.
pub fn one_op(kind: Kind, args: [u32; 3], width: u32, aux: u32) -> Netlist {
    let port = |i: usize| FlatPort { name: ["a", "b", "c"][i].into(), slot: i as Slot, width: args[i] };
    let op = FlatOp { kind, args: [0, 1, 2], width, arg_width: args[0], aux };
    Netlist {
        widths: args.into_iter().chain([width]).collect(),
        inputs: (0..3).map(port).collect(),
        outputs: vec![FlatPort { name: "y".into(), slot: 3, width }],
        ops: vec![op],
        first_op: 3,
        ..Netlist::default()
    }
}

/// Every legal shape of an operation at width `w`: operand widths, result width, shift or row count.
pub fn shapes(kind: Kind, w: u32, rng: &mut ChaCha8Rng) -> Vec<([u32; 3], u32, u32)> {
    let any = |rng: &mut ChaCha8Rng, low: u32, high: u32| rng.random_range(low..=high.max(low));
    match kind {
        Kind::Copy | Kind::Not => vec![([w; 3], w, 0)],
        Kind::And | Kind::Or | Kind::Xor | Kind::Add | Kind::Sub => vec![([w; 3], w, 0)],
        Kind::RedOr | Kind::RedAnd | Kind::Eq | Kind::Ult | Kind::Slt => vec![([w; 3], 1, 0)],
        Kind::Mul => {
            let a = any(rng, 1, w - 1);
            if w < 2 { vec![] } else { vec![([a, w - a, 1], w, 0)] }
        }
        Kind::Shl | Kind::Shr | Kind::Sar => vec![([w, any(rng, 1, 64), 1], w, 0), ([w, 7, 1], w, 0)],
        Kind::Mux => vec![([1, w, w], w, 0)],
        Kind::Join => {
            let b = any(rng, 1, w - 1);
            if w < 2 { vec![] } else { vec![([w - b, b, 1], w, b)] }
        }
        Kind::Slice => {
            let aux = any(rng, 0, w - 1);
            let more = any(rng, w, 64);
            vec![([w; 3], any(rng, 1, w - aux), aux), ([w; 3], w - aux, aux), ([w; 3], more, 0)]
        }
        Kind::Sext => vec![([w; 3], any(rng, w, 64), 0)],
        Kind::Rep => vec![([1; 3], w, 0)],
        Kind::Lzc => vec![([w; 3], 64 - w.leading_zeros(), 0)],
        Kind::Interleave => {
            if w.is_multiple_of(2) {
                vec![([w / 2; 3], w, 0)]
            } else {
                vec![]
            }
        }
        Kind::DivRem => {
            if (3..64).contains(&w) {
                vec![([w, w - 1, 1], w, any(rng, 1, 64))]
            } else {
                vec![]
            }
        }
        Kind::DivQuot => {
            let rows = any(rng, 1, 64);
            if (3..64).contains(&w) { vec![([w, w - 1, 1], rows, rows)] } else { vec![] }
        }
        Kind::RecipTable => vec![([8; 3], w, 0)],
    }
}

/// All operations.
pub const KINDS: [Kind; 26] = [
    Kind::Copy,
    Kind::Not,
    Kind::And,
    Kind::Or,
    Kind::Xor,
    Kind::RedOr,
    Kind::RedAnd,
    Kind::Add,
    Kind::Sub,
    Kind::Mul,
    Kind::Eq,
    Kind::Ult,
    Kind::Slt,
    Kind::Shl,
    Kind::Shr,
    Kind::Sar,
    Kind::Mux,
    Kind::Join,
    Kind::Slice,
    Kind::Sext,
    Kind::Rep,
    Kind::Lzc,
    Kind::Interleave,
    Kind::DivRem,
    Kind::DivQuot,
    Kind::RecipTable,
];

/// A word with many equal, extreme and small values.
pub fn word(rng: &mut ChaCha8Rng, width: u32) -> u64 {
    let v = match rng.random_range(0..6) {
        0 => 0,
        1 => u64::MAX,
        2 => 1 << rng.random_range(0..width),
        3 => rng.random_range(0..=u64::from(width) + 1),
        _ => rng.random(),
    };
    v & mask(width)
}
