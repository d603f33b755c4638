//! `fp_lt`: 1 if a < b. False when either is NaN; the two zeros are equal.
//!
//! One carry chain over the magnitudes, with no test before it: where `a` is negative, its last position turns
//! `a < b` into `a <= b`, whose complement is the answer for two negative numbers. Classes are decided beside the chain.
use super::fields::{Fields, FormatParams, Split};
use crate::quantity::{BIT, FLOAT};
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// Sections and how long each takes, in tenths of a nanosecond on ECP5.
const PLAN: &[(&str, u32)] = &[("compare", 28), ("decide", 10)];

/// Builds `fp_lt` with `latency` clocks from operand to result.
pub fn fp_lt(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new(crate::float::names::LT, file!(), "1 if a < b; 0 when either is NaN; +0 and -0 are equal");
    let f = FormatParams::declare(&b, format);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "left side");
    let b_in = b.input("b", &f.width, FLOAT, "right side");
    let out = b.output("result", 1, BIT, "a < b");
    b.plan(latency, PLAN);

    b.section(
        "compare",
        "Of magnitudes: below, or for a negative a, below or equal. An exponent of 0 is zero whatever its fraction says, \
         but two zeros are detected beside the comparator, not in its carry chain.",
    );
    let (fa, fb) = (Fields::split(&f, a_in, "a"), Fields::split(&f, b_in, "b"));
    let mag_w = &f.exp + &f.man;
    // Last bits of which one is below the other exactly if that holds of the operands' own, or they are equal and a is
    // negative. (A constant appended there would do too, but Yosys maps comparisons with constants to more cells.)
    let (a_last, b_last) = (a_in.bit(0), b_in.bit(0));
    let rest = mag_w - 1;
    let left = b.cat(&[a_in.slice(1, rest.clone()), a_last & !fa.sign]).named("left");
    let right = b.cat(&[b_in.slice(1, rest), b_last | (fa.sign & !a_last)]).named("right");
    let below = left.lt(right).named("below");
    let mut both_zero = fa.exp.none() & fb.exp.none();
    if format.is_gradual() {
        both_zero = both_zero & (fa.frac | fb.frac).none();
    }
    if format.is_finite() && !format.is_gradual() {
        b.unused(b.cat(&[fa.frac, fb.frac]));
    }
    let both_zero = both_zero.named("both_zero");
    let nan = (!format.is_finite()).then(|| (is_nan(&fa).named("a_is_nan"), is_nan(&fb).named("b_is_nan")));
    let (a_sign, b_sign) = (fa.sign, fb.sign);

    b.section("decide", "");
    let apart = nan.map_or(both_zero, |(a, b)| a | b | both_zero);
    let ordered = (!apart).named("ordered");
    let less = (ordered & a_sign.mux(!(b_sign & below), !b_sign & below)).named("less");
    b.drive(out, less);
    b.finish(&super::bindings())
}

/// Exponent all ones, and a fraction.
fn is_nan<'b>(x: &Split<'b>) -> Sig<'b> {
    x.exp.all() & x.frac.any()
}
