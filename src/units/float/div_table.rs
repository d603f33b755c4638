//! `fp_div` by a table of reciprocals and three multipliers, for few clocks.
//!
//! A line of the table, followed to the divisor, gives its reciprocal; times the dividend the quotient, to less than half a unit
//! of its last place. So the rounded quotient is what is left of the estimate when it is cut, or one more, and the remainder at
//! the half-way point between the two says which: `docs/arithmetic.md` proves the bound, `tests/div_table.rs` checks it for
//! every divisor.
use super::fields::FormatParams;
use super::quotient::Quotient;
use super::round::Candidate;
use crate::bits::{INDEX_W, SLOPE_W, START_W};
use crate::config::Design;
use crate::format::FloatFormat;
use crate::ir::{Builder, Expr, Module};
use crate::units::recip_table::recip_table;
use std::sync::Arc;

/// What stands behind the table's register, and how long it takes, in tenths of a nanosecond on ECP5: a read of a block
/// memory takes most of a stage by itself.
const PLAN: [(&str, u32); 7] = [
    ("read", 60),
    ("fall", 40),
    ("reciprocal", 25),
    ("quotient", 40),
    ("estimate", 25),
    ("remainder", 40),
    ("select", 30),
];

/// Builds it with `latency` clocks from operand to result; 2 or more.
pub fn by_table(format: FloatFormat, latency: u32) -> Arc<Module> {
    assert!(format.is_plain() && latency >= Design::TABLE_CLOCKS, "Design::check_divider comes first");
    let b = Builder::new("fp_div", file!(), "quotient of two floating-point numbers, rounded once");
    let f = FormatParams::declare(&b, format);
    b.require(&f.man, Design::TABLE_MAN);
    let e_w = b.local("ExpSumW", &f.exp + 2);
    let p = b.local("SigW", &f.man + 1);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, "float", "dividend");
    let b_in = b.input("b", &f.width, "float", "divisor");
    let out = b.output("result", &f.width, "float", "a / b");
    b.plan_from(1, latency - 1, &PLAN);

    b.section("table", "Short fractions are filled up with zeros, so one table serves every MAN_W.");
    let x = Quotient::of(&b, &f, a_in, b_in, &e_w);
    let fill = b.zeros(Expr::from(17) - &f.man);
    let filled = b.cat(&[x.b_frac, fill]).named("b_filled");
    let line = recip_table(&b, filled.slice(17 - INDEX_W, INDEX_W));
    let along = filled.slice(1, 16 - INDEX_W).named("along");
    b.unused(filled.bit(0));
    let num = b.cat(&[b.lit(1, 1), x.a_frac, fill]).named("dividend");
    let den = b.cat(&[b.lit(1, 1), x.b_frac]).named("divisor");
    let less = x.a_frac.lt(x.b_frac).named("is_less");
    let exp = (x.exp - less.zext(&e_w)).named("norm_exp");
    // The dividend's last two bits where the quotient's significand lies in [1, 2).
    let num_low = less.mux(b.cat(&[x.a_frac.bit(0), b.zeros(1)]), x.a_frac.slice(0, 2)).named("num_low");

    b.section("fall", "");
    let fall = line.slice(0, SLOPE_W).product(along).named("fall");
    b.unused(fall);

    b.section("reciprocal", "Less 1/2, in 18 bits.");
    let start = line.slice(SLOPE_W, START_W);
    let recip = (start - fall.slice(6, SLOPE_W + 10 - INDEX_W).zext(START_W)).named("recip");
    b.unused(recip);

    b.section("quotient", "");
    let part = num.product(recip.slice(3, 18)).named("part");
    b.unused(part);

    b.section("estimate", "The half that the reciprocal was given less, and the quotient cut to its significand.");
    let est = (num.slice(1, 17).zext(18) + part.slice(19, 17).zext(18)).named("est");
    b.unused(est);
    let quot = less.mux(est.slice(Expr::from(16) - &f.man, &p), est.slice(Expr::from(17) - &f.man, &p)).named("quot");
    // Just below 1, one more is the result: 1 at the exponent that is there.
    let lower = (exp - b.lit(1, &e_w)).named("lower_exp");
    let at = quot.msb().mux(exp, lower).named("quot_exp_cut");

    b.section(
        "remainder",
        "Half-way between the two candidates: it is no multiple of the last place, and below two divisors, so two bits of \
         the product tell its sign. Both candidates stand ready.",
    );
    let half = b.cat(&[quot, b.ones(1)]);
    let back = half.product(den).named("back");
    b.unused(back);
    let (n0, n1, b0, b1) = (num_low.bit(0), num_low.bit(1), back.bit(&f.man + 1), back.bit(&f.man + 2));
    let up = (n1 ^ b1 ^ (n0 & !b0)).named("round_up");
    let frac = quot.slice(0, &f.man);
    let low = Candidate::of(&b, &f, at, frac, b.zeros(1), None, "low");
    let high = Candidate::of(&b, &f, at, frac, b.ones(1), None, "high");

    b.section("select", "");
    let value = Candidate::pick(up, &high, &low).pack(&b, &f, x.sign, &x.classes);
    b.drive(out, value, Some(latency));
    b.finish(Some(latency), &super::bindings())
}
