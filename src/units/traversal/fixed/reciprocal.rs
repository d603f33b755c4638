//! `reciprocal`: M / A for the largest height code M and a ray's travel A, with RECIP_W significant bits and a shift.
//!
//! By rows: digit recurrence on operands whose top bits stand under each other; one digit more than the result has rounds it.
//! By a table: [`by_table`]. Both give the same bits.
use super::params::{bindings, chunks};
use super::reciprocal_ports::{Ports, builder};
use super::reciprocal_table::by_table;
use crate::div_rows::{div_rows, div_rows_module};
use crate::lzc::lzc;
use crate::recip_table::recip_table_module;
use reliefrtl_config::{Design, Divider};
use reliefrtl_ir::{Expr, Module};
use std::sync::Arc;

/// Builds `reciprocal`, `latency.div` clocks, by digit rows or by a table.
pub fn reciprocal(d: &Design) -> Arc<Module> {
    match d.latency.divider {
        Divider::Rows => by_rows(d),
        Divider::Table => by_table(d),
    }
}

/// What it stands on besides its own text.
pub(super) fn reciprocal_core(d: &Design) -> Arc<Module> {
    let (f, w) = (d.datapath.fraction_bits, d.datapath.reciprocal_bits);
    match d.latency.divider {
        Divider::Rows => div_rows_module(f + d.traverse.tile_bits, w + 2),
        Divider::Table => recip_table_module(),
    }
}

fn by_rows(d: &Design) -> Arc<Module> {
    let latency = d.latency.div;
    let b = builder(file!(), Divider::Rows);
    let mut rows = Expr::from(0);
    let Ports { w, h, reach, shift_w, a, o_r, o_z } = Ports::declare(&b, d, |w| {
        rows = b.local("QuotW", w + 2, "bits of a quotient: those of the result, and what its rounding needs")
    });
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
