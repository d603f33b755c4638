//! `reciprocal` by a table of reciprocals and multipliers, with an exact remainder that decides the last digit.
//!
//! With d = the travel moved up into \[1, 2), n = 2 - 2^(1-h), and q = n / d, or twice that where d > n, in \[1, 2): the result
//! is q in units of 2^-(W-1), rounded.
//!
//! 1. **Reciprocal.** A line of the table, followed to 26 fraction bits of d and 13 units of 2^-22 less, gives
//!    r <= 1 / d, below it by at most 23 / d of these units.
//! 2. **First digits.** q0 = q by r instead of 1 / d, cut to L = min(18, W - 1) bits. M is 2^h - 1, so n r costs a difference.
//!    Never above q; below it by less than 3 of its last place 2^-(L-1).
//! 3. **Remainder.** (q - q0) d 2^(L-1), exact: below 6, so what it needs of a product are its lower F + T + 2 bits.
//! 4. **Digits.** The upper 18 bits of the remainder by the upper 18 bits of r are what q0 lacks: never too much, and too little by
//!    less than 1/2 of the last place at W <= 31 (0.42 there, at d near 1: 1/4 for what is cut off the remainder, the rest for r).
//!    Cut to the last place, K <= q 2^(W-1) < K + 3/2.
//! 5. **Round.** So the result is K or K + 1, and the sign of the exact remainder at K + 1/2 says which; it lies between
//!    -d and 2 d, so two bits more than d has hold it.
//!
//! `tests/golden/arithmetic/reciprocal_table.rs` holds these bounds against integers, on every line and at every place of it.
use super::params::bindings;
use super::reciprocal_ports::{Ports, builder};
use crate::lzc::lzc;
use crate::recip_table::recip_table;
use reliefrtl_base::bits::{INDEX_W, SLOPE_W, START_W};
use reliefrtl_config::{Design, Divider};
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Bits of a multiplier's operand.
const OPERAND: u32 = 18;
/// Bits of the table's reciprocal: its units are 2^-22.
const RECIP: u32 = START_W + 1;
/// What the table's reciprocal is given less, so that it never is too large: more than the line lies above 1 / d (`docs/arithmetic.md`).
const LESS: u32 = 13;

/// What stands after the table's register, and how long it takes, in tenths of a nanosecond on ECP5.
const PLAN: [(&str, u32); 9] = [
    ("read", 60),
    ("fall", 40),
    ("inverse", 50),
    ("parts", 40),
    ("remainder", 35),
    ("digits", 40),
    ("parts at half", 40),
    ("remainder at half", 35),
    ("round", 30),
];

/// The same with registers before and after each multiplier besides.
const DEEP: [&str; 17] = [
    "read",
    "line",
    "fall",
    "fallen",
    "inverse",
    "estimate",
    "factors",
    "parts",
    "summed",
    "remainder",
    "upper",
    "digits",
    "factor",
    "parts at half",
    "summed at half",
    "remainder at half",
    "round",
];

/// Registers among leading zeros, normalization and table, for so many clocks in all.
fn head(latency: u32) -> u32 {
    match latency {
        0..=7 => 0,
        8..=13 => 1,
        _ => 2,
    }
}

/// Spreads what follows the table over the clocks that the registers before it leave; how many these are.
fn plan(b: &Builder, latency: u32) -> u32 {
    let before = head(latency);
    let after = latency - before - 1;
    if after as usize >= DEEP.len() {
        b.plan_from(before + 1, after, &DEEP.map(|name| (name, 60)));
    } else {
        b.plan_from(before + 1, after, &PLAN);
    }
    before
}

/// The lower 36 bits of a product with the divisor, as products of 18 bits and their sum.
struct Parts<'b> {
    low: Sig<'b>,
    high: Sig<'b>,
}

impl<'b> Parts<'b> {
    /// `digits` of at most 18 bits times `div` of 36.
    fn of(digits: Sig<'b>, div: Sig<'b>, name: &str) -> Self {
        // A zero above at every width of the digits: no width may be none.
        let digits = digits.zext(OPERAND + 1);
        let part = |lo: u32, which: &str| digits.product(div.slice(lo, OPERAND)).named(&format!("{name}_{which}"));
        Self { low: part(0, "low"), high: part(OPERAND, "high") }
    }

    fn sum(self, b: &'b Builder, name: &str) -> Sig<'b> {
        let upper = self.low.slice(OPERAND, OPERAND) + self.high.slice(0, OPERAND);
        b.unused(self.low);
        b.unused(self.high);
        b.cat(&[upper, self.low.slice(0, OPERAND)]).named(name)
    }
}

/// Builds it, `latency.div` clocks, 2 or more.
pub(super) fn by_table(d: &Design) -> Arc<Module> {
    let latency = d.latency.div;
    assert!(latency >= Design::TABLE_CLOCKS, "Design::check_divider comes first");
    let b = builder(file!(), Divider::Table);
    let (mut lead, mut gap) = (Expr::from(0), Expr::from(0));
    let Ports { w, h, reach, shift_w, a, o_r, o_z } = Ports::declare(&b, d, |w| {
        lead = b.local("LeadW", (w - 1).smaller(OPERAND), "bits of a quotient that its first estimate gives");
        gap = b.local("GapW", w - &lead, "bits of a quotient below its first estimate");
    });
    let before = plan(&b, latency);
    let rem_w = b.local("RemW", &reach + 2, "bits of a remainder, with its sign");

    b.section("leading zeros", "A travel of 0 has no topmost 1.");
    let tall = b.cat(&[b.zeros(1), a]).named("a_tall");
    let count = lzc(&b, "u_lzc", tall, "lz_count").reg_if(before > 0);
    b.section("normalize", "The topmost 1 of the travel and that of M move to the same place.");
    let moved = tall.shift_left(count).named("a_moved");
    b.unused(moved.bit(0));
    let div = moved.slice(1, reach.clone()).named("divisor").reg_if(before > 1);
    let wide = div.zext(2 * OPERAND).named("divisor_wide");
    let zero = a.none().named("is_zero");
    let ones = div.slice(&reach - &h, h.clone()).all();
    let over = (!(ones & div.slice(0, &reach - &h).any())).named("is_over");
    let z = (over | zero).mux(count, (count - b.lit(1, &shift_w)).named("count_less")).named("shift");

    b.section("table", "The fraction's upper bits choose a line, the 18 below follow it.");
    let filled = b.cat(&[div, b.zeros(OPERAND)]).named("filled");
    b.unused(filled);
    let line = recip_table(&b, filled.slice(&reach + (OPERAND - 1 - INDEX_W), INDEX_W));
    let along = filled.slice(&reach - (1 + INDEX_W), OPERAND).named("along");

    b.section("read", "");
    b.section("line", "Less than the reciprocal, whatever the line's error.");
    let start = b.cat(&[b.lit(1, 1), line.slice(SLOPE_W, START_W)]);
    let start = (start - b.lit(u64::from(LESS), RECIP)).named("start");
    let slope = line.slice(0, SLOPE_W).named("slope");

    b.section("fall", "");
    let product = slope.product(along).named("fall_product");
    b.unused(product);
    let fall = product.slice(16, SLOPE_W + OPERAND - 16).named("fall");

    b.section("fallen", "");
    b.section("inverse", "");
    let recip = (start - fall.zext(RECIP)).named("recip");
    let upper_recip = recip.slice(RECIP - OPERAND, OPERAND).named("recip_upper");

    b.section("estimate", "Times 2 - 2^(1-h), rounded down; doubled where that is less than the divisor.");
    let part = recip.slice(h.clone(), Expr::from(RECIP) - &h).zext(RECIP).named("recip_part");
    let est = (recip + !part).named("estimate");
    b.unused(est);
    let first = over
        .mux(est.slice(Expr::from(RECIP) - &lead, lead.clone()), est.slice(Expr::from(RECIP - 1) - &lead, lead.clone()))
        .named("first");

    b.section("factors", "");
    b.section("parts", "");
    let parts = Parts::of(first, wide, "back");

    b.section("summed", "");
    b.section("remainder", "Of the dividend only what the remainder's bits hold; 0 where there are more digits.");
    let back = parts.sum(&b, "back");
    b.unused(back);
    let num = b.cat(&[b.ones(&h), b.zeros(&reach - &h)]);
    let num = over.mux(b.cat(&[b.zeros(1), num]), b.cat(&[num, b.zeros(1)])).named("dividend");
    let scaled = b.cat(&[num, b.zeros(&lead - 1)]).named("scaled");
    b.unused(scaled);
    let rem = (scaled.slice(0, rem_w.clone()) - back.slice(0, rem_w.clone())).named("rem");

    b.section("upper", "");
    b.section("digits", "");
    let filled = b.cat(&[rem, b.zeros(OPERAND)]).named("rem_filled");
    b.unused(filled);
    let product = filled.slice(rem_w.clone(), OPERAND).named("rem_upper").product(upper_recip).named("digits_product");
    b.unused(product);
    let digits = product.slice(Expr::from(33) - &gap, &gap + 2).named("digits");

    b.section("factor", "");
    b.section("parts at half", "");
    let half = Parts::of(b.cat(&[digits, b.lit(1, 1)]).named("digits_half"), wide, "half");
    let low = (b.cat(&[first, b.zeros(gap.clone())]) + digits.zext(&w)).named("low");

    b.section("summed at half", "");
    b.section("remainder at half", "The sign says whether it is one more; a half rounds upward.");
    let half = half.sum(&b, "half");
    b.unused(half);
    let moved = b.cat(&[rem, b.zeros(&gap + 1)]).named("rem_moved");
    b.unused(moved);
    let rest = (moved.slice(0, rem_w.clone()) - half.slice(0, rem_w.clone())).named("rest");
    b.unused(rest);
    let up = (!rest.msb()).named("round_up");

    b.section("round", "What would take a bit more stays at all ones.");
    let sum = (low.zext(&w + 1) + up.zext(&w + 1)).named("rounded");
    let r = (sum.slice(0, w.clone()) | sum.msb().rep(w.clone())) & (!zero).rep(w.clone());
    b.drive(o_r, r.named("nearest"));
    b.drive(o_z, z);
    b.finish(&bindings())
}
