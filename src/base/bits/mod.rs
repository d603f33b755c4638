//! What every operation of the IR computes, on words of 1 to 64 bits.
//!
//! A value of width `w` is a `u64` whose bits above `w` are zero. Interpreter, constant folding and waveform
//! decoding all call these functions; nothing else in the crate defines the meaning of an operation.
mod prim;
mod recip_table;
pub use prim::{deinterleave, div_rows, interleave, lzc};
pub use recip_table::{INDEX_W, SLOPE_W, START_W, recip_table};

/// The widest word that the IR computes with, in bits.
pub const MAX_WIDTH: u32 = 64;

/// The widest bundle that the IR carries: words beside each other, which are concatenated, sliced, selected and held, and no more.
pub const MAX_BUNDLE: u32 = 4096;

/// All ones in the low `w` bits (`w` up to 64).
#[inline(always)]
pub const fn mask(w: u32) -> u64 {
    if w >= 64 { u64::MAX } else { (1u64 << w) - 1 }
}

/// Two's complement value of the low `w` bits.
#[inline(always)]
pub const fn signed(a: u64, w: u32) -> i64 {
    let s = 64 - w;
    ((a << s) as i64) >> s
}

/// `a << n`, zero when every bit is shifted out.
#[inline(always)]
pub const fn shl(a: u64, n: u64, w: u32) -> u64 {
    if n >= w as u64 { 0 } else { (a << n) & mask(w) }
}

/// `a >> n`, zeros come in; zero when every bit is shifted out.
#[inline(always)]
pub const fn shr(a: u64, n: u64, w: u32) -> u64 {
    if n >= w as u64 { 0 } else { a >> n }
}

/// Arithmetic `a >> n`: copies of the sign come in.
#[inline(always)]
pub const fn sar(a: u64, n: u64, w: u32) -> u64 {
    let n = if n >= w as u64 { w - 1 } else { n as u32 };
    ((signed(a, w) >> n) as u64) & mask(w)
}

/// Smallest `k` with `2^k >= x`; 0 for `x <= 1`. Verilog's `$clog2`.
pub const fn clog2(x: i128) -> i128 {
    let mut k = 0;
    while (1i128 << k) < x {
        k += 1;
    }
    k
}
