//! What a module without state computes, straight from its nodes and plain arithmetic: no interpreter, no `eval`.
use reliefrtl::bits::{clog2, div_rows, interleave, lzc, mask};
use reliefrtl::ir::{Binding, Body, Module, Op, Prim};
use std::collections::BTreeMap;

/// The outputs of `m`, in port order, for inputs in port order.
pub fn outputs(m: &Module, b: &Binding, inputs: &[u64]) -> Vec<u64> {
    let names: Vec<usize> = m.data_inputs().map(|(i, _)| i).collect();
    let inputs: BTreeMap<usize, u64> = names.into_iter().zip(inputs.iter().copied()).collect();
    match m.body {
        Body::Prim(p) => primitive(p, m, b, &inputs),
        Body::Graph => graph(m, b, &inputs),
    }
}

fn primitive(p: Prim, m: &Module, b: &Binding, inputs: &BTreeMap<usize, u64>) -> Vec<u64> {
    let i = |name: &str| inputs[&m.port(name).unwrap().0];
    let w = b.get("W").map_or(0, |w| *w as u32);
    match p {
        Prim::Lzc => vec![lzc(i("bits"), w)],
        Prim::Interleave => vec![interleave(i("a"), i("b"))],
        Prim::DivRows => {
            let (rem, quot) = div_rows(i("rem_in"), i("div"), w, b["ROWS"] as u32);
            vec![rem, quot]
        }
        Prim::SqrtRows => {
            let (mut rem, mut root) = (u128::from(i("rem_in")), u128::from(i("root_in")));
            for k in 0..b["ROWS"] {
                let mark = 1u128 << (i64::from(w) - 1 - b["FIRST"] - k);
                let trial = 2 * root + mark;
                rem *= 2;
                if rem >= trial {
                    rem -= trial;
                    root += mark;
                }
            }
            vec![rem as u64, root as u64]
        }
        Prim::Memory | Prim::FifoMem | Prim::Banks | Prim::RecipTable | Prim::DelayLine => {
            unreachable!("a memory has state")
        }
    }
}

fn graph(m: &Module, b: &Binding, inputs: &BTreeMap<usize, u64>) -> Vec<u64> {
    let mut values: Vec<u64> = Vec::new();
    for n in &m.nodes {
        let width = n.width.eval(b) as u32;
        let a: Vec<u128> = n.args.iter().map(|x| u128::from(values[x.0 as usize])).collect();
        let w: Vec<u32> = n.args.iter().map(|x| m.node(*x).width.eval(b) as u32).collect();
        let one = 1u128 << width;
        // As a number with a sign, and back.
        let signed = |k: usize| if a[k] >> (w[k] - 1) == 1 { a[k] as i128 - (1 << w[k]) } else { a[k] as i128 };
        let wrap = |v: i128| v.rem_euclid(one as i128) as u128;
        let amount = || a[1].min(127) as u32;
        let v: u128 = match &n.op {
            Op::Input(p) => u128::from(inputs[p]),
            Op::Zeros => 0,
            Op::Ones => one - 1,
            Op::Lit(v) => u128::from(*v),
            Op::Konst(e) => wrap(e.eval_wide(b)),
            Op::Not => one - 1 - a[0],
            Op::And => a[0] & a[1],
            Op::Or => a[0] | a[1],
            Op::Xor => a[0] ^ a[1],
            Op::RedOr => u128::from(a[0] > 0),
            Op::RedAnd => u128::from(a[0] == (1 << w[0]) - 1),
            Op::Add => (a[0] + a[1]) % one,
            Op::Sub => (one + a[0] - a[1]) % one,
            Op::Mul => a[0] * a[1],
            Op::Eq => u128::from(a[0] == a[1]),
            Op::Ult => u128::from(a[0] < a[1]),
            Op::Slt => u128::from(signed(0) < signed(1)),
            Op::Shl => {
                if a[1] >= u128::from(width) {
                    0
                } else {
                    (a[0] << amount()) % one
                }
            }
            Op::Shr => {
                if a[1] >= u128::from(width) {
                    0
                } else {
                    a[0] >> amount()
                }
            }
            Op::Sar => wrap(signed(0) >> amount()),
            Op::Mux => {
                if a[0] == 1 {
                    a[1]
                } else {
                    a[2]
                }
            }
            Op::Concat => a.iter().zip(&w).fold(0, |v, (a, w)| (v << w) | a),
            Op::Slice { lo } => (a[0] >> lo.eval(b)) % one,
            Op::Zext => a[0],
            Op::Sext => wrap(signed(0)),
            Op::Rep => a[0] * (one - 1),
            Op::Reg { .. } | Op::Wire | Op::InstOut(..) => unreachable!("not in these modules"),
        };
        values.push(u64::try_from(v).expect("a value fits its word"));
    }
    m.outputs.iter().map(|(_, id)| values[id.0 as usize] & mask(64)).collect()
}

/// `$clog2` agrees with its definition.
#[test]
fn clog2_is_the_smallest_exponent() {
    for x in 2..1000i128 {
        let k = clog2(x);
        assert!(1i128 << k >= x && 1i128 << (k - 1) < x);
    }
}
