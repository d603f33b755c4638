//! `fp_compare`: how one number stands to another: less, equal, greater, unordered.
//!
//! One carry chain and one equality over the magnitudes; signs and classes are decided beside them.
use super::fields::FormatParams;
use super::general::{Operand, any};
use crate::quantity::{BIT, FLOAT};
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Sections and how long each takes, in tenths of a nanosecond on ECP5.
const PLAN: &[(&str, u32)] = &[("compare", 28), ("decide", 12)];

/// Builds `fp_compare` with `latency` clocks from operand to result.
pub fn fp_compare(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new("fp_compare", file!(), "less, equal, greater or unordered: exactly one of them is 1");
    let f = FormatParams::declare(&b, format);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "left side");
    let b_in = b.input("b", &f.width, FLOAT, "right side");
    let lt = b.output("lt", 1, BIT, "a < b");
    let eq = b.output("eq", 1, BIT, "a = b; +0 and -0 are equal");
    let gt = b.output("gt", 1, BIT, "a > b");
    let unordered = (!format.is_finite()).then(|| b.output("unordered", 1, BIT, "a or b is NaN"));
    b.plan(latency, PLAN);

    b.section("compare", "");
    let mag_w = &f.exp + &f.man;
    let (left, right) = (a_in.slice(0, &mag_w), b_in.slice(0, &mag_w));
    let below = left.lt(right).named("below");
    let same = left.eq(right).named("same");
    let (fa, fb) = (Operand::of(&b, &f, a_in, "a"), Operand::of(&b, &f, b_in, "b"));
    let both_zero = (fa.zero() & fb.zero()).named("both_zero");
    if format.is_finite() && !format.is_gradual() {
        b.unused(b.cat(&[fa.frac, fb.frac]));
    }
    let nan = any(&[fa.nan(), fb.nan()]).map(|s| s.named("either_nan"));
    let (a_sign, differ) = (fa.sign, (fa.sign ^ fb.sign).named("signs_differ"));

    b.section("decide", "");
    let equal = both_zero | (same & !differ);
    let less = !both_zero & differ.mux(a_sign, !same & (below ^ a_sign));
    let (equal, less) = match nan {
        Some(nan) => (equal & !nan, less & !nan),
        None => (equal, less),
    };
    let (equal, less) = (equal.named("equal"), less.named("less"));
    let rest = any(&[Some(equal | less), nan]).expect("there is one");
    b.drive(lt, less);
    b.drive(eq, equal);
    b.drive(gt, (!rest).named("greater"));
    if let Some((port, nan)) = unordered.zip(nan) {
        b.drive(port, nan);
    }
    b.finish(&super::bindings())
}
