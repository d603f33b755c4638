//! `fp_div` by a table of reciprocals and three multipliers, for few clocks.
//!
//! A line of the table, followed to the divisor, gives its reciprocal; times the dividend the quotient, to less than half a unit
//! of its last place. So the rounded quotient is what is left of the estimate when it is cut, or one more, and the remainder at
//! the half-way point between the two says which: `docs/arithmetic.md` proves the bound, `tests/golden/arithmetic/div_table.rs` checks it for
//! every divisor.
use super::fields::FormatParams;
use super::quotient::Quotient;
use super::round::Classes;
use crate::quantity::FLOAT;
use crate::recip_table::recip_table;
use reliefrtl_base::bits::{INDEX_W, SLOPE_W, START_W};
use reliefrtl_base::format::FloatFormat;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Module};
use std::sync::Arc;

/// What stands after the table's register, and how long it takes, in tenths of a nanosecond on ECP5: a read of a block
/// memory takes most of a stage by itself.
const PLAN: [(&str, u32); 7] = [
    ("read", 60),
    ("fall", 40),
    ("reciprocal", 22),
    ("quotient", 40),
    ("estimate", 27),
    ("remainder", 40),
    ("select", 30),
];

/// The same with registers before and after each multiplier besides, so that these can stand beside the block, wherever the rest is.
const DEEP: [&str; 12] = [
    "read",
    "line",
    "fall",
    "fallen",
    "reciprocal",
    "factors",
    "quotient",
    "part",
    "estimate",
    "remainder",
    "rest",
    "select",
];

/// Builds it with `latency` clocks from operand to result; 2 or more.
pub fn by_table(format: FloatFormat, latency: u32) -> Arc<Module> {
    assert!(format.is_plain() && latency >= Design::TABLE_CLOCKS, "Design::check_divider comes first");
    let b = Builder::new(crate::float::names::DIV, file!(), "quotient of two floating-point numbers, rounded once");
    b.choice("divider", "table");
    let f = FormatParams::declare(&b, format);
    b.require(&f.man, Design::TABLE_MAN);
    let e_w = b.local("ExpSumW", &f.exp + 2, "bits of an exponent difference, with its sign");
    let p = b.local("SigW", &f.man + 1, "bits of a significand, the hidden one included");
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "dividend");
    let b_in = b.input("b", &f.width, FLOAT, "divisor");
    let out = b.output("result", &f.width, FLOAT, "a / b");
    if latency as usize > DEEP.len() {
        b.plan_from(1, latency - 1, &DEEP.map(|name| (name, 60)));
    } else {
        b.plan_from(1, latency - 1, &PLAN);
    }

    b.section("table", "Short fractions are filled up with zeros, so one table serves every MAN_W.");
    let x = Quotient::of(&b, &f, a_in, b_in, &e_w);
    let fill = b.zeros(Expr::from(17) - &f.man);
    let filled = b.cat(&[x.b_frac, fill]).named("b_filled");
    let line = recip_table(&b, filled.slice(17 - INDEX_W, INDEX_W));
    let (start, slope) = (line.slice(SLOPE_W, START_W).named("start"), line.slice(0, SLOPE_W).named("slope"));
    let along = filled.slice(1, 16 - INDEX_W).named("along");
    b.unused(filled.bit(0));
    let dividend = b.cat(&[b.lit(1, 1), x.a_frac, fill]).named("dividend");
    let divisor = b.cat(&[b.lit(1, 1), x.b_frac]).named("divisor");
    let less = x.a_frac.lt(x.b_frac).named("is_less");

    b.section("read", "Doubled where it is less than the divisor, so that the quotient lies in [1, 2).");
    let num = less.mux(dividend, b.cat(&[b.zeros(1), dividend.slice(1, 17)])).named("num");
    let low_bits = num.slice(Expr::from(16) - &f.man, 2).named("num_low");
    let exp = (x.exp - less.zext(&e_w)).named("norm_exp");
    let lower = (exp - b.lit(1, &e_w)).named("exp_minus_1");

    b.section("line", "");
    b.section("fall", "");
    let product = slope.product(along).named("fall_product");
    let fall = product.slice(6, SLOPE_W + 10 - INDEX_W).named("fall");
    b.unused(product);

    b.section("fallen", "");
    b.section("reciprocal", "Less 1/2, in 18 bits.");
    let sum = (start - fall.zext(START_W)).named("recip_sum");
    let recip = sum.slice(3, 18).named("recip");
    b.unused(sum);

    b.section("factors", "");
    b.section("quotient", "");
    let product = num.product(recip).named("part_product");
    let part = product.slice(18, 18).named("part");
    b.unused(product);

    b.section("part", "");
    b.section("estimate", "With the half that the reciprocal was given less, and cut to a significand.");
    let est = (num + part).named("est");
    b.unused(est);
    let quot = est.slice(Expr::from(17) - &f.man, &p).named("quot");

    b.section(
        "remainder",
        "At half a unit more than the estimate: it is never 0, and below two divisors, so two bits of the product tell its \
         sign. Below, the estimate is the result, else one more; both stand ready with their masks.",
    );
    let back = b.cat(&[quot, b.ones(1)]).product(divisor).named("back");
    b.unused(back);
    b.section("rest", "");
    let (n0, n1, b0, b1) = (low_bits.bit(0), low_bits.bit(1), back.bit(&f.man + 1), back.bit(&f.man + 2));
    let up = (n1 ^ b1 ^ (n0 & !b0)).named("round_up");
    // An estimate just below 1: one more is the result, and carries to the exponent that is there.
    let at = quot.msb().mux(exp, lower).named("stored_exp");
    let low = b.cat(&[at.slice(0, &f.exp), quot.slice(0, &f.man)]).named("low");
    let high = (low + b.lit(1, low.width())).named("high");
    let Classes { nan, inf, zero } = x.classes;
    let over = (!at.msb() & (at.bit(&f.exp) | at.slice(0, &f.exp).all())).named("over");
    let inf = (nan | inf | (over & !zero)).named("give_inf");
    let at_zero = at.none().named("at_zero");
    let none = (inf | zero | at.msb()).named("none");
    // From exponent 0, rounding may still reach the smallest normal number.
    let keep_low = (!(none | at_zero)).named("keep_low");
    let keep_high = (!(none | (at_zero & !high.bit(&f.man)))).named("keep_high");

    b.section("select", "");
    let (sel_low, sel_high) = ((keep_low & !up).named("sel_low"), (keep_high & up).named("sel_high"));
    let body = |lo: &Expr, w: &Expr| low.slice(lo, w) & sel_low.rep(w) | high.slice(lo, w) & sel_high.rep(w);
    let frac = body(&Expr::from(0), &f.man) | b.cat(&[nan, b.zeros(&f.man - 1)]);
    let value = b.cat(&[(x.sign & !nan).named("sign"), body(&f.man, &f.exp) | inf.rep(&f.exp), frac]).named("value");
    b.drive(out, value);
    b.finish(&super::bindings())
}
