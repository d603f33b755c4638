//! One operation over the lanes of a block: loops of fixed length, which the compiler vectorizes.
//!
//! Words of up to 32 bits have loops of their own: they hold twice as many lanes a vector. `eval` says what an
//! operation means, and `tests/hardware/lanes.rs` holds these loops to it at every width.
use super::eval::eval;
use super::netlist::{FlatOp, Kind};
use reliefrtl_base::bits::mask;

/// Lanes of a large block. All values of a block together should fit the second-level cache.
pub const BLOCK: usize = 128;
/// Lanes of a small block: what a few copies need. It takes a fifth of the time of a large one.
pub const FEW: usize = 16;
/// A value of up to 32 bits in every lane.
pub type Narrow<const L: usize> = [u32; L];
/// A value of up to 64 bits in every lane.
pub type Wide<const L: usize> = [u64; L];

/// An operation, or two of them in one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Code {
    /// The operation alone.
    Plain,
    /// `a & !b`.
    AndNot,
    /// `a | !b`.
    OrNot,
    /// `a | (b & c)`.
    AndOr,
    /// `a & (b | c)`.
    OrAnd,
}

/// One assignment in every lane. (Closures would be compiled without the vector instructions of their caller.)
macro_rules! each {
    ($out:ident, |$x:ident in $a:ident| $e:expr) => {
        for i in 0..L {
            let $x = $a[i];
            $out[i] = $e;
        }
    };
    ($out:ident, |$x:ident in $a:ident, $y:ident in $b:ident| $e:expr) => {
        for i in 0..L {
            let ($x, $y) = ($a[i], $b[i]);
            $out[i] = $e;
        }
    };
    ($out:ident, |$x:ident in $a:ident, $y:ident in $b:ident, $z:ident in $c:ident| $e:expr) => {
        for i in 0..L {
            let ($x, $y, $z) = ($a[i], $b[i], $c[i]);
            $out[i] = $e;
        }
    };
}

/// An operation whose operands and result have up to 32 bits.
#[inline(always)]
pub fn narrow<const L: usize>(
    code: Code,
    op: &FlatOp,
    out: &mut Narrow<L>,
    a: &Narrow<L>,
    b: &Narrow<L>,
    c: &Narrow<L>,
) {
    let (w, aw, aux) = (op.width, op.arg_width, op.aux & 31);
    let (m, sign) = (mask(w) as u32, 1u32 << ((aw - 1) & 31));
    let up = (32 - aw) & 31;
    match code {
        Code::Plain => {}
        Code::AndNot => return each!(out, |x in a, y in b| x & !y),
        Code::OrNot => return each!(out, |x in a, y in b| x | (y ^ m)),
        Code::AndOr => return each!(out, |x in a, y in b, z in c| x | (y & z)),
        Code::OrAnd => return each!(out, |x in a, y in b, z in c| x & (y | z)),
    }
    match op.kind {
        Kind::Copy => *out = *a,
        Kind::Not => each!(out, |x in a| x ^ m),
        Kind::And => each!(out, |x in a, y in b| x & y),
        Kind::Or => each!(out, |x in a, y in b| x | y),
        Kind::Xor => each!(out, |x in a, y in b| x ^ y),
        Kind::RedOr => each!(out, |x in a| u32::from(x != 0)),
        Kind::RedAnd => {
            let full = mask(aw) as u32;
            each!(out, |x in a| u32::from(x == full));
        }
        Kind::Add => each!(out, |x in a, y in b| x.wrapping_add(y) & m),
        Kind::Sub => each!(out, |x in a, y in b| x.wrapping_sub(y) & m),
        Kind::Mul => each!(out, |x in a, y in b| x.wrapping_mul(y) & m),
        Kind::Eq => each!(out, |x in a, y in b| u32::from(x == y)),
        Kind::Ult => each!(out, |x in a, y in b| u32::from(x < y)),
        Kind::Slt => each!(out, |x in a, y in b| u32::from(x ^ sign < y ^ sign)),
        Kind::Shl => each!(out, |x in a, n in b| if n < w { (x << (n & 31)) & m } else { 0 }),
        Kind::Shr => each!(out, |x in a, n in b| if n < w { x >> (n & 31) } else { 0 }),
        Kind::Sar => each!(out, |x in a, n in b| ((((x << up) as i32) >> up) >> (n.min(w - 1) & 31)) as u32 & m),
        Kind::Mux => each!(out, |s in a, x in b, y in c| (x & 0u32.wrapping_sub(s)) | (y & s.wrapping_sub(1))),
        Kind::Join => each!(out, |x in a, y in b| (x << aux) | y),
        Kind::Slice => each!(out, |x in a| (x >> aux) & m),
        Kind::Sext => each!(out, |x in a| (((x << up) as i32) >> up) as u32 & m),
        Kind::Rep => each!(out, |x in a| 0u32.wrapping_sub(x) & m),
        Kind::Lzc => each!(out, |x in a| x.leading_zeros() + aw - 32),
        Kind::Interleave => each!(out, |x in a, y in b| eval(op, u64::from(x), u64::from(y), 0) as u32),
        Kind::DivRem => divide(op, a, b, out, &mut [0; L]),
        Kind::DivQuot => divide(op, a, b, &mut [0; L], out),
        Kind::RecipTable => each!(out, |x in a| eval(op, u64::from(x), 0, 0) as u32),
    }
}

/// Remainder and quotient of rows of division with operands and results of up to 32 bits; a few lanes at a time, so
/// that they stay in registers from row to row.
#[inline(always)]
pub fn divide<const L: usize>(
    op: &FlatOp,
    rem: &Narrow<L>,
    div: &Narrow<L>,
    rem_out: &mut Narrow<L>,
    quot: &mut Narrow<L>,
) {
    const GROUP: usize = 16;
    let m = mask(op.arg_width) as u32;
    for g in (0..L).step_by(GROUP) {
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
pub fn wide<const L: usize>(op: &FlatOp, out: &mut Wide<L>, a: &Wide<L>, b: &Wide<L>, c: &Wide<L>) {
    macro_rules! kinds {
        ($($each:ident: $($k:ident),*;)*) => {
            match op.kind {
                $($(Kind::$k => {
                    let op = FlatOp { kind: Kind::$k, ..*op };
                    kinds!(@ $each, op, out, a, b, c)
                })*)*
            }
        };
        (@ each1, $op:ident, $out:ident, $a:ident, $b:ident, $c:ident) => {
            each!($out, |x in $a| eval(&$op, x, x, x))
        };
        (@ each2, $op:ident, $out:ident, $a:ident, $b:ident, $c:ident) => {
            each!($out, |x in $a, y in $b| eval(&$op, x, y, x))
        };
        (@ each3, $op:ident, $out:ident, $a:ident, $b:ident, $c:ident) => {
            each!($out, |x in $a, y in $b, z in $c| eval(&$op, x, y, z))
        };
    }
    kinds!(
        each1: Copy, Not, RedOr, RedAnd, Slice, Sext, Rep, Lzc, RecipTable;
        each2: And, Or, Xor, Add, Sub, Mul, Eq, Ult, Slt, Shl, Shr, Sar, Join, Interleave, DivRem, DivQuot;
        each3: Mux;
    );
}

/// A narrow slice of wide words.
#[inline(always)]
pub fn slice<const L: usize>(op: &FlatOp, out: &mut Narrow<L>, a: &Wide<L>) {
    let (aux, m) = (op.aux & 63, mask(op.width));
    each!(out, |x in a| ((x >> aux) & m) as u32);
}
/// The wide product of narrow words.
#[inline(always)]
pub fn product<const L: usize>(op: &FlatOp, out: &mut Wide<L>, a: &Narrow<L>, b: &Narrow<L>) {
    let m = mask(op.width);
    each!(out, |x in a, y in b| (u64::from(x) * u64::from(y)) & m);
}

/// Narrow words as wide ones.
#[inline(always)]
pub fn widen<const L: usize>(out: &mut Wide<L>, a: &Narrow<L>) {
    each!(out, |x in a| u64::from(x));
}
/// Wide words that fit as narrow ones.
#[inline(always)]
pub fn truncate<const L: usize>(out: &mut Narrow<L>, a: &Wide<L>) {
    each!(out, |x in a| x as u32);
}

/// What registers hold next: `d` where they are enabled, 0 where they are reset.
macro_rules! next {
    ($name:ident, $word:ty) => {
        #[inline(always)]
        pub fn $name<const L: usize>(
            q: &mut [$word; L],
            d: &[$word; L],
            enable: Option<&Narrow<L>>,
            reset: Option<&Narrow<L>>,
        ) {
            match (enable, reset) {
                (None, None) => *q = *d,
                (Some(e), None) => {
                    for i in 0..L {
                        // As masks: a choice of what to load would be a choice of addresses.
                        let on = (0 as $word).wrapping_sub(<$word>::from(e[i]));
                        q[i] = (d[i] & on) | (q[i] & !on);
                    }
                }
                (None, Some(r)) => {
                    for i in 0..L {
                        q[i] = d[i] & <$word>::from(r[i]).wrapping_sub(1);
                    }
                }
                (Some(e), Some(r)) => {
                    for i in 0..L {
                        let on = (0 as $word).wrapping_sub(<$word>::from(e[i]));
                        q[i] = ((d[i] & on) | (q[i] & !on)) & <$word>::from(r[i]).wrapping_sub(1);
                    }
                }
            }
        }
    };
}
next!(next_narrow, u32);
next!(next_wide, u64);
