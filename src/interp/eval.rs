//! One flat operation on one set of operands: the only place that maps operations to `bits`.
use super::netlist::{FlatOp, Kind};
use reliefrtl_base::bits::{div_rows, interleave, lzc, mask, recip_table, sar, shl, shr, signed};

/// Computes `op` on `a`, `b`, `c` (operands that the operation does not have are ignored).
#[inline(always)]
pub fn eval(op: &FlatOp, a: u64, b: u64, c: u64) -> u64 {
    let m = mask(op.width);
    match op.kind {
        Kind::Copy => a,
        Kind::Not => !a & m,
        Kind::And => a & b,
        Kind::Or => a | b,
        Kind::Xor => a ^ b,
        Kind::RedOr => u64::from(a != 0),
        Kind::RedAnd => u64::from(a == mask(op.arg_width)),
        Kind::Add => a.wrapping_add(b) & m,
        Kind::Sub => a.wrapping_sub(b) & m,
        Kind::Mul => a.wrapping_mul(b) & m,
        Kind::Eq => u64::from(a == b),
        Kind::Ult => u64::from(a < b),
        Kind::Slt => u64::from(signed(a, op.arg_width) < signed(b, op.arg_width)),
        Kind::Shl => shl(a, b, op.width),
        Kind::Shr => shr(a, b, op.width),
        Kind::Sar => sar(a, b, op.width),
        Kind::Mux => (b & 0u64.wrapping_sub(a)) | (c & !0u64.wrapping_sub(a)),
        Kind::Join => (a << (op.aux & 63)) | b,
        Kind::Slice => (a >> (op.aux & 63)) & m,
        Kind::Sext => (signed(a, op.arg_width) as u64) & m,
        Kind::Rep => 0u64.wrapping_sub(a) & m,
        Kind::Lzc => lzc(a, op.arg_width),
        Kind::Interleave => interleave(a, b),
        Kind::DivRem => div_rows(a, b, op.arg_width - 1, op.aux).0,
        Kind::DivQuot => div_rows(a, b, op.arg_width - 1, op.aux).1,
        Kind::RecipTable => recip_table(a) & m,
    }
}
