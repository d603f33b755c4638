//! `fp_div`: the quotient of two numbers, rounded once.
//!
//! Restoring digit recurrence, `p + 2` rows for `p = MAN_W + 1`. The quotient of two p-bit significands is never a tie
//! (a tie would have p + 1 significant bits, and times the divisor it would not fit the dividend), so one guard bit
//! decides and no sticky bit is needed. Rows are spread over the stages.
use super::div_table::by_table;
use super::fields::FormatParams;
use super::general;
use super::quotient::Quotient;
use super::round::Candidate;
use super::rows::Groups;
use crate::div_rows::div_rows;
use crate::quantity::FLOAT;
use reliefrtl_base::format::FloatFormat;
use reliefrtl_config::{Divider, LatencyConfig};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// The sections after the rows.
const TAIL: [(&str, u32); 3] = [("pick", 12), ("round", 20), ("select", 18)];

/// Builds `fp_div` with `l.div` clocks from operand to result, by digit rows or by a table.
pub fn fp_div(format: FloatFormat, l: &LatencyConfig) -> Arc<Module> {
    match l.divider {
        Divider::Rows => by_rows(format, l.div),
        Divider::Table => by_table(format, l.div),
    }
}

fn by_rows(format: FloatFormat, latency: u32) -> Arc<Module> {
    if !format.is_plain() {
        return general::fp_div(format, latency);
    }
    let b = Builder::new(crate::float::names::DIV, file!(), "quotient of two floating-point numbers, rounded once");
    b.choice("divider", "rows");
    let f = FormatParams::declare(&b, format);
    let e_w = b.local("ExpSumW", &f.exp + 2, "bits of an exponent difference, with its sign");
    let p = b.local("SigW", &f.man + 1, "bits of a significand, the hidden one included");
    let rows = b.local("QuotW", &p + 2, "bits of a quotient: those of the result, and what its rounding needs");
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "dividend");
    let b_in = b.input("b", &f.width, FLOAT, "divisor");
    let out = b.output("result", &f.width, FLOAT, "a / b");
    let groups = Groups::planned(&b, latency, format.man + 3, None, &TAIL);
    b.require(groups.least_rows() - 3, &f.man);

    b.section("classes", "The hidden bit is 1 for every operand: a zero operand overrides the result instead.");
    let x = Quotient::of(&b, &f, a_in, b_in, &e_w);
    let div = b.cat(&[b.lit(1, 1), x.b_frac]).named("divisor");
    let mut rem = b.cat(&[b.lit(1, 2), x.a_frac]).named("rem");
    let mut quot = None;
    for c in 0..groups.len() {
        b.section(&groups.title(c), "Rows of compare, subtract, double: one quotient bit each, the integer bit first.");
        let (r, q) = div_rows(&b, &format!("u_rows_{c}"), rem, div, &p, &groups.count(&rows, c), c);
        rem = r;
        quot = Some(match quot {
            None => q,
            Some(before) => b.cat(&[before, q]).named(&format!("quot_{c}")),
        });
    }
    b.unused(rem);
    let quot = quot.expect("at least one chunk of rows");

    b.section("pick", "The quotient lies in (1/2, 2): its integer bit selects the bits of the significand.");
    let top = quot.msb().named("top");
    let exp = (x.exp - (!top).zext(&e_w)).named("norm_exp");
    let frac = top.mux(quot.slice(2, &f.man), quot.slice(1, &f.man)).named("frac");
    let guard = top.mux(quot.bit(1), quot.bit(0)).named("guard");

    b.section("round", "No quotient lies half-way between two numbers, so the guard bit alone rounds.");
    let rounded = Candidate::of(&b, &f, exp, frac, guard, None, "round");

    b.section("select", "");
    let value = rounded.pack(&b, &f, x.sign, &x.classes);
    b.drive(out, value);
    b.finish(&super::bindings())
}
