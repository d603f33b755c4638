//! One operation over the lanes of a block: loops of fixed length, which the compiler vectorizes.
//!
//! Words of up to 32 bits have loops of their own: they hold twice as many lanes a vector. `eval` says what an
//! operation means, and `tests/lanes.rs` holds these loops to it at every width.
use super::eval::eval;
use super::netlist::{FlatOp, Kind};
use crate::bits::mask;

/// Lanes of a block. All values of a block together should fit the second-level cache.
pub const BLOCK: usize = 64;
/// A value of up to 32 bits in every lane.
pub type Narrow = [u32; BLOCK];
/// A value of up to 64 bits in every lane.
pub type Wide = [u64; BLOCK];

#[inline(always)]
fn each1<T: Copy, U>(out: &mut [U; BLOCK], a: &[T; BLOCK], f: impl Fn(T) -> U) {
    for i in 0..BLOCK {
        out[i] = f(a[i]);
    }
}
#[inline(always)]
fn each2<T: Copy, U>(out: &mut [U; BLOCK], a: &[T; BLOCK], b: &[T; BLOCK], f: impl Fn(T, T) -> U) {
    for i in 0..BLOCK {
        out[i] = f(a[i], b[i]);
    }
}
#[inline(always)]
fn each3<T: Copy, U>(o: &mut [U; BLOCK], a: &[T; BLOCK], b: &[T; BLOCK], c: &[T; BLOCK], f: impl Fn(T, T, T) -> U) {
    for i in 0..BLOCK {
        o[i] = f(a[i], b[i], c[i]);
    }
}

/// An operation whose operands and result have up to 32 bits.
#[inline(always)]
pub fn narrow(op: &FlatOp, out: &mut Narrow, a: &Narrow, b: &Narrow, c: &Narrow) {
    let (w, aw, aux) = (op.width, op.arg_width, op.aux & 31);
    let (m, sign) = (mask(w) as u32, 1u32 << ((aw - 1) & 31));
    let up = (32 - aw) & 31;
    let signed = move |x: u32| ((x << up) as i32) >> up;
    match op.kind {
        Kind::Copy => *out = *a,
        Kind::Not => each1(out, a, |x| x ^ m),
        Kind::And => each2(out, a, b, |x, y| x & y),
        Kind::Or => each2(out, a, b, |x, y| x | y),
        Kind::Xor => each2(out, a, b, |x, y| x ^ y),
        Kind::RedOr => each1(out, a, |x| u32::from(x != 0)),
        Kind::RedAnd => {
            let full = mask(aw) as u32;
            each1(out, a, |x| u32::from(x == full));
        }
        Kind::Add => each2(out, a, b, |x, y| x.wrapping_add(y) & m),
        Kind::Sub => each2(out, a, b, |x, y| x.wrapping_sub(y) & m),
        Kind::Mul => each2(out, a, b, |x, y| x.wrapping_mul(y) & m),
        Kind::Eq => each2(out, a, b, |x, y| u32::from(x == y)),
        Kind::Ult => each2(out, a, b, |x, y| u32::from(x < y)),
        Kind::Slt => each2(out, a, b, |x, y| u32::from(x ^ sign < y ^ sign)),
        Kind::Shl => each2(out, a, b, |x, n| if n < w { (x << (n & 31)) & m } else { 0 }),
        Kind::Shr => each2(out, a, b, |x, n| if n < w { x >> (n & 31) } else { 0 }),
        Kind::Sar => each2(out, a, b, |x, n| (signed(x) >> (n.min(w - 1) & 31)) as u32 & m),
        Kind::Mux => each3(out, a, b, c, |s, x, y| if s != 0 { x } else { y }),
        Kind::Join => each2(out, a, b, |x, y| (x << aux) | y),
        Kind::Slice => each1(out, a, |x| (x >> aux) & m),
        Kind::Sext => each1(out, a, |x| signed(x) as u32 & m),
        Kind::Rep => each1(out, a, |x| 0u32.wrapping_sub(x) & m),
        Kind::Lzc => each1(out, a, |x| x.leading_zeros() + aw - 32),
        Kind::Interleave => each2(out, a, b, |x, y| eval(op, u64::from(x), u64::from(y), 0) as u32),
        Kind::DivRem => divide(op, a, b, out, &mut [0; BLOCK]),
        Kind::DivQuot => divide(op, a, b, &mut [0; BLOCK], out),
    }
}

/// Remainder and quotient of rows of division with operands and results of up to 32 bits; a few lanes at a time, so
/// that they stay in registers from row to row.
#[inline(always)]
pub fn divide(op: &FlatOp, rem: &Narrow, div: &Narrow, rem_out: &mut Narrow, quot: &mut Narrow) {
    const GROUP: usize = 16;
    let m = mask(op.arg_width) as u32;
    for g in (0..BLOCK).step_by(GROUP) {
        let (mut r, mut q, mut d) = ([0u32; GROUP], [0u32; GROUP], [0u32; GROUP]);
        r.copy_from_slice(&rem[g..g + GROUP]);
        d.copy_from_slice(&div[g..g + GROUP]);
        for _ in 0..op.aux {
            for i in 0..GROUP {
                let fits = r[i] >= d[i];
                r[i] = ((r[i].wrapping_sub(if fits { d[i] } else { 0 })) << 1) & m;
                q[i] = (q[i] << 1) | u32::from(fits);
            }
        }
        rem_out[g..g + GROUP].copy_from_slice(&r);
        quot[g..g + GROUP].copy_from_slice(&q);
    }
}

/// Any operation: `eval` with the kind pulled out of the loop.
#[inline(always)]
pub fn wide(op: &FlatOp, out: &mut Wide, a: &Wide, b: &Wide, c: &Wide) {
    macro_rules! kinds {
        ($($each:ident: $($k:ident),*;)*) => {
            match op.kind {
                $($(Kind::$k => {
                    let op = FlatOp { kind: Kind::$k, ..*op };
                    kinds!(@ $each, op, out, a, b, c)
                })*)*
            }
        };
        (@ each1, $op:ident, $out:ident, $a:ident, $b:ident, $c:ident) => { each1($out, $a, |x| eval(&$op, x, x, x)) };
        (@ each2, $op:ident, $out:ident, $a:ident, $b:ident, $c:ident) => {
            each2($out, $a, $b, |x, y| eval(&$op, x, y, x))
        };
        (@ each3, $op:ident, $out:ident, $a:ident, $b:ident, $c:ident) => {
            each3($out, $a, $b, $c, |x, y, z| eval(&$op, x, y, z))
        };
    }
    kinds!(
        each1: Copy, Not, RedOr, RedAnd, Slice, Sext, Rep, Lzc;
        each2: And, Or, Xor, Add, Sub, Mul, Eq, Ult, Slt, Shl, Shr, Sar, Join, Interleave, DivRem, DivQuot;
        each3: Mux;
    );
}

/// Narrow words as wide ones.
#[inline(always)]
pub fn widen(out: &mut Wide, a: &Narrow) {
    each1(out, a, u64::from);
}
/// Wide words that fit as narrow ones.
#[inline(always)]
pub fn cut(out: &mut Narrow, a: &Wide) {
    each1(out, a, |x| x as u32);
}

/// What a register holds next: `d` where it is enabled, 0 where it is reset.
#[inline(always)]
pub fn next<T: Copy + Default>(q: &mut [T; BLOCK], d: &[T; BLOCK], enable: Option<&Narrow>, reset: Option<&Narrow>) {
    match (enable, reset) {
        (None, None) => *q = *d,
        (Some(e), None) => {
            for i in 0..BLOCK {
                q[i] = if e[i] != 0 { d[i] } else { q[i] };
            }
        }
        (None, Some(r)) => {
            for i in 0..BLOCK {
                q[i] = if r[i] != 0 { T::default() } else { d[i] };
            }
        }
        (Some(e), Some(r)) => {
            for i in 0..BLOCK {
                let v = if e[i] != 0 { d[i] } else { q[i] };
                q[i] = if r[i] != 0 { T::default() } else { v };
            }
        }
    }
}
