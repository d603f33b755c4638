//! `fp_div` at any choice of rounding, subnormals and specials: the digit rows of the default, and a sticky bit.
use super::super::fields::FormatParams;
use super::super::rows::Groups;
use super::{Classes, Exact, Operand, Range, any, exponent_width, round};
use crate::div_rows::div_rows;
use crate::quantity::FLOAT;
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

const HEAD: (&str, u32) = ("operands", 50);
const TAIL: [(&str, u32); 4] = [("pick", 15), ("shift", 35), ("round", 30), ("select", 20)];

/// Builds `fp_div` with `latency` clocks from operand to result.
pub fn fp_div(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new(crate::float::names::DIV, file!(), "quotient of two floating-point numbers, rounded once");
    b.choice("divider", "rows");
    let f = FormatParams::declare(&b, format);
    let e_w = exponent_width(&b, &f);
    let p = b.local("SigW", &f.man + 1, "bits of a significand, the hidden one included");
    let rows = b.local("QuotW", &p + 2, "bits of a quotient: those of the result, and what its rounding needs");
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "dividend");
    let b_in = b.input("b", &f.width, FLOAT, "divisor");
    let out = b.output("result", &f.width, FLOAT, "a / b");
    let groups = Groups::planned(&b, latency, format.man + 3, format.is_gradual().then_some(HEAD), &tail(format));
    b.require(groups.least_rows() - 3, &f.man);

    b.section("operands", "");
    let (fa, fb) = (Operand::of(&b, &f, a_in, "a"), Operand::of(&b, &f, b_in, "b"));
    let ((ea, sa), (eb, sb)) = (fa.normalized(&e_w), fb.normalized(&e_w));
    let sign = (fa.sign ^ fb.sign).named("quot_sign");
    let bias = b.konst(f.bias(), &e_w).named("bias").doc("the exponent bias");
    let exp0 = (ea - eb + bias).named("quot_exp");
    let (a_zero, b_zero, a_inf, b_inf) = (fa.zero(), fb.zero(), fa.inf(), fb.inf());
    let both = a_inf.zip(b_inf).map(|(x, y)| x & y);
    // NaN wins over infinity, infinity over zero; where every code is a number, zero wins.
    let nan = any(&[fa.nan(), fb.nan(), both, a_inf.map(|_| a_zero & b_zero)]).map(|s| s.named("is_nan"));
    let inf = any(&[a_inf, Some(b_zero)]).map(|s| s.named("is_inf"));
    let zero = any(&[Some(a_zero), b_inf]).map(|s| s.named("is_zero"));
    let div = sb.named("divisor");
    let mut rem = b.cat(&[b.zeros(1), sa]).named("rem");
    let mut quot: Option<Sig<'_>> = None;
    for c in 0..groups.len() {
        b.section(&groups.title(c), "Rows of compare, subtract, double: one quotient bit each, the integer bit first.");
        let (r, q) = div_rows(&b, &format!("u_rows_{c}"), rem, div, &p, &groups.count(&rows, c), c);
        rem = r;
        quot = Some(quot.map_or(q, |before| b.cat(&[before, q]).named(&format!("quot_{c}"))));
    }
    let quot = quot.expect("at least one group of rows");

    b.section("pick", "The quotient lies in (1/2, 2): its integer bit selects the bits of the significand.");
    let top = quot.msb().named("top");
    let exp = (exp0 - (!top).zext(&e_w)).named("norm_exp");
    let norm = top.mux(quot, b.cat(&[quot.slice(0, &p + 1), b.zeros(1)])).named("norm");
    let sticky = (norm.bit(0) | rem.any()).named("sticky");
    let x = Exact { sign, exp, sig: norm.slice(2, &p).named("sig"), guard: norm.bit(1).named("guard"), sticky };
    let value = round(&b, &f, x, Range::Any, &Classes { nan, inf, zero });
    b.drive(out, value);
    b.finish(&super::super::bindings())
}

/// The sections after the rows.
fn tail(format: FloatFormat) -> Vec<(&'static str, u32)> {
    TAIL.into_iter().filter(|t| t.0 != "shift" || format.is_gradual()).collect()
}
