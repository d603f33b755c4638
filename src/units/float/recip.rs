//! `fp_recip`: the reciprocal of a number, rounded once.
//!
//! Restoring digit recurrence as in `fp_div`, with a constant dividend: the reciprocal of a significand in (1, 2) lies in
//! (1/2, 1), so the leading digit is known and a power of 2 is told apart. Specials: `docs/arithmetic.md`.
use super::fields::FormatParams;
use super::general::{Classes, Exact, Operand, Range, exponent_width, round};
use super::rows::Groups;
use crate::div_rows::div_rows;
use crate::quantity::FLOAT;
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// What stands before the rows where subnormals are numbers, and after them.
const HEAD: (&str, u32) = ("operand", 50);
const TAIL: [(&str, u32); 4] = [("pick", 12), ("shift", 35), ("round", 30), ("select", 15)];

/// Builds `fp_recip` with `latency` clocks from operand to result.
pub fn fp_recip(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new("fp_recip", file!(), "reciprocal of a floating-point number, rounded once");
    let f = FormatParams::declare(&b, format);
    let e_w = exponent_width(&b, &f);
    let p = b.local("SigW", &f.man + 1, "bits of a significand, the hidden one included");
    let rows = b.local("QuotW", &p + 1, "bits of a quotient: those of the result, and what its rounding needs");
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "operand");
    let out = b.output("result", &f.width, FLOAT, "1 / a");
    let gradual = format.is_gradual();
    let tail: Vec<(&str, u32)> = TAIL.into_iter().filter(|t| t.0 != "shift" || gradual).collect();
    let groups = Groups::planned(&b, latency, format.man + 2, gradual.then_some(HEAD), &tail);
    b.require(groups.least_rows() - 2, &f.man);

    b.section("operand", "");
    let a = Operand::of(&b, &f, a_in, "a");
    let (exp, sig) = a.normalized(&e_w);
    let (sign, inf, zero, nan) = (a.sign, Some(a.zero()), a.inf(), a.nan());
    let div = sig.named("divisor");
    let more = div.slice(0, &f.man).any().named("no_power");
    let top = b
        .konst(f.bias() * 2, &e_w)
        .named("top_exp")
        .doc("exponent of a reciprocal before it is normalized: twice the bias");
    let exp = (top - exp - more.zext(&e_w)).named("recip_exp");
    let mut rem = b.cat(&[b.lit(1, 1), b.zeros(&p)]);
    let mut quot: Option<Sig<'_>> = None;
    for c in 0..groups.len() {
        b.section(&groups.title(c), "Rows of compare, subtract, double: one digit of 2 / a each.");
        let (r, q) = div_rows(&b, &format!("u_rows_{c}"), rem, div, &p, &groups.count(&rows, c), c);
        rem = r;
        quot = Some(quot.map_or(q, |before| b.cat(&[before, q]).named(&format!("quot_{c}"))));
    }
    let quot = quot.expect("at least one group of rows");

    b.section("pick", "Of a power of 2 the digits mean nothing.");
    let frac = quot.slice(1, &f.man) & more.rep(&f.man);
    b.unused(quot.msb());
    let (guard, sticky) = ((quot.bit(0) & more).named("guard"), (rem.any() & more).named("sticky"));
    let x = Exact { sign, exp, sig: b.cat(&[b.lit(1, 1), frac]).named("sig"), guard, sticky };
    let value = round(&b, &f, x, Range::Any, &Classes { nan, inf, zero });
    b.drive(out, value);
    b.finish(&super::bindings())
}
