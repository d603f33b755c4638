//! `reciprocal`: M / A for the largest height code M and a ray's travel A, with RECIP_W significant bits and a shift.
//!
//! Digit recurrence on operands whose top bits stand under each other; one digit more than the result has rounds it.
use super::params::{LENGTH, Params, bindings, chunks, shift_width};
use crate::div_rows::div_rows;
use crate::lzc::lzc;
use crate::quantity::{BITS, integer};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Module};
use std::sync::Arc;

/// Builds `reciprocal`, `latency.div` clocks.
pub fn reciprocal(d: &Design) -> Arc<Module> {
    let latency = d.latency.div;
    let text = "slope of a ray's parameter along an axis: a reciprocal and a shift";
    let b = Builder::new("reciprocal", file!(), text);
    let of = Params { b: &b, d };
    let f = of.fraction();
    let w = of.recip();
    let h = of.height(&f);
    let (_, reach) = of.reach(&f);
    let shift_w = b.local("ShiftW", shift_width(&reach));
    let rows = b.local("QuotW", &w + 2);
    b.clock();
    b.clock_enable();
    let a = b.input("a", &reach, LENGTH, "travel, its magnitude");
    let o_r = b.output("r", &w, integer("a number of RECIP_W bits"), "M / a without its power of two; 0 if a is");
    let o_z = b.output("z", &shift_w, BITS, "that power: how far a distance is moved up before it meets r");
    let chunks = chunks(d);
    let titles: Vec<String> = (0..chunks).map(|c| format!("rows {c}")).collect();
    let mut plan: Vec<(&str, u32)> = vec![("leading zeros", 3), ("normalize", 3)];
    plan.extend(titles.iter().map(|t| (t.as_str(), 60 / chunks + 1)));
    plan.push(("round", 4));
    b.plan(latency, &plan);

    b.section("leading zeros", "A travel of 0 has no topmost 1.");
    let tall = b.cat(&[b.zeros(1), a]).named("a_tall");
    let count = lzc(&b, "u_lzc", tall, "lz_count");
    b.section("normalize", "The topmost 1 of the travel and that of M move to the same place.");
    let moved = tall.shift_left(count).named("a_moved");
    b.unused(moved.bit(0));
    let div = moved.slice(1, reach.clone()).named("divisor");
    let zero = a.none().named("is_zero");
    let mut rem = b.cat(&[b.zeros(1), b.ones(&h), b.zeros(&reach - &h)]).named("rem");
    let mut quot = None;
    for (c, title) in titles.iter().enumerate() {
        b.section(title, "Rows of compare, subtract, double: one quotient bit each, the integer bit first.");
        let at = |k: i64| if k == i64::from(chunks) { rows.clone() } else { (rows.clone() * k).div(chunks) };
        let count: Expr = if c == 0 { at(1) } else { at(c as i64 + 1) - at(c as i64) };
        let (r, q) = div_rows(&b, &format!("u_rows_{c}"), rem, div, &reach, &count, c);
        rem = r;
        quot = Some(match quot {
            None => q,
            Some(before) => b.cat(&[before, q]).named(&format!("quot_{c}")),
        });
    }
    b.unused(rem);
    let quot = quot.expect("at least one chunk of rows");

    b.section(
        "round",
        "The quotient lies in (3/4, 2): its integer bit picks the digits. To nearest, a half upward; what would take a \
         bit more stays at all ones.",
    );
    let over = quot.msb().named("is_over");
    let digits = over.mux(quot.slice(2, w.clone()), quot.slice(1, w.clone())).named("digits");
    let guard = over.mux(quot.bit(1), quot.bit(0)).named("guard");
    let sum = (digits.zext(&w + 1) + guard.zext(&w + 1)).named("rounded");
    let r = (sum.slice(0, w.clone()) | sum.msb().rep(w.clone())) & (!zero).rep(w.clone());
    b.drive(o_r, r.named("nearest"));
    let z = (over | zero).mux(count, count - b.lit(1, &shift_w)).named("shift");
    b.drive(o_z, z);
    b.finish(&bindings())
}
