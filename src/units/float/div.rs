//! `fp_div`: the quotient of two numbers, rounded once.
//!
//! Restoring digit recurrence, `p + 2` rows for `p = MAN_W + 1`. The quotient of two p-bit significands is never a tie
//! (a tie would have p + 1 significant bits, and times the divisor it would not fit the dividend), so one guard bit
//! decides and no sticky bit is needed. Rows are spread over the stages.
use super::fields::{Fields, FormatParams};
use super::round::{Candidate, Classes};
use crate::format::FloatFormat;
use crate::ir::{Builder, Expr, Module, plan_stages};
use crate::units::div_rows::div_rows;
use std::sync::Arc;

/// What a row takes, in tenths of a nanosecond on ECP5.
const ROW: u32 = 35;
/// The sections behind the rows.
const TAIL: [(&str, u32); 3] = [("pick", 12), ("round", 20), ("select", 18)];

/// Builds `fp_div` with `latency` clocks from operand to result.
pub fn fp_div(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new("fp_div", file!(), "quotient of two floating-point numbers, rounded once");
    let f = FormatParams::declare(&b, format);
    let e_w = b.local("ExpSumW", &f.exp + 2);
    let p = b.local("SigW", &f.man + 1);
    let rows = b.local("QuotW", &p + 2);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, "float", "dividend");
    let b_in = b.input("b", &f.width, "float", "divisor");
    let out = b.output("result", &f.width, "float", "a / b");
    let groups = Groups::of(latency, format.man + 3);
    b.require(groups.least_rows() - 3, &f.man);
    let titles: Vec<String> = (0..groups.ends.len()).map(|c| format!("rows {c}")).collect();
    let mut plan: Vec<(&str, u32)> =
        titles.iter().enumerate().map(|(c, t)| (t.as_str(), ROW * groups.size(c))).collect();
    plan.extend(TAIL);
    b.plan(latency, &plan);

    b.section("classes", "The hidden bit is 1 for every operand: a zero operand overrides the result instead.");
    let (fa, fb) = (Fields::of(&f, a_in, "a"), Fields::of(&f, b_in, "b"));
    let sign = (fa.sign ^ fb.sign).named("quot_sign");
    let bias = b.konst(f.bias(), &e_w).named("bias");
    let exp0 = (fa.exp.zext(&e_w) - fb.exp.zext(&e_w) + bias).named("quot_exp");
    let inf = ((fa.is_inf | fb.is_zero) & !fb.is_inf & !fa.is_zero).named("is_inf");
    let zero = ((fa.is_zero | fb.is_inf) & !fa.is_inf & !fb.is_zero).named("is_zero");
    let same = (fa.is_zero & fb.is_zero) | (fa.is_inf & fb.is_inf);
    let nan = (fa.is_nan | fb.is_nan | same).named("is_nan");
    let div = b.cat(&[b.lit(1, 1), fb.frac]).named("divisor");
    let mut rem = b.cat(&[b.lit(1, 2), fa.frac]).named("rem");
    let mut quot = None;
    for (c, title) in titles.iter().enumerate() {
        b.section(title, "Rows of compare, subtract, double: one quotient bit each, the integer bit first.");
        let end = |c: usize| match groups.ends[c] {
            last if last == groups.of => rows.clone(),
            end => (rows.clone() * i64::from(end)).div(groups.of),
        };
        let count: Expr = if c == 0 { end(0) } else { end(c) - end(c - 1) };
        let (r, q) = div_rows(&b, &format!("u_rows_{c}"), rem, div, &p, &count, c);
        rem = r;
        quot = Some(match quot {
            None => q,
            Some(before) => b.cat(&[before, q]).named(&format!("quot_{c}")),
        });
    }
    b.unused(rem);
    let quot = quot.expect("at least one chunk of rows");

    b.section("pick", "The quotient lies in (1/2, 2): its integer bit says where the significand stands.");
    let top = quot.msb().named("top");
    let exp = (exp0 - (!top).zext(&e_w)).named("norm_exp");
    let frac = top.mux(quot.slice(2, &f.man), quot.slice(1, &f.man)).named("frac");
    let guard = top.mux(quot.bit(1), quot.bit(0)).named("guard");

    b.section("round", "No quotient lies half-way between two numbers, so the guard bit alone rounds.");
    let rounded = Candidate::of(&b, &f, exp, frac, guard, None, "round");

    b.section("select", "");
    let value = rounded.pack(&b, &f, sign, &Classes { nan, inf, zero });
    b.drive(out, value, Some(latency));
    b.finish(Some(latency), &super::bindings())
}

/// Rows in groups, one a stage: group c ends behind row `rows * ends[c] / of`, at any number of rows.
struct Groups {
    rows: u32,
    ends: Vec<u32>,
    of: u32,
}

impl Groups {
    /// Groups such that rows and tail together are balanced, or alike where that would ask for longer fractions than alike
    /// groups do: one short group among many long ones is empty at few rows.
    fn of(latency: u32, rows: u32) -> Self {
        let weights: Vec<u32> = (0..rows).map(|_| ROW).chain(TAIL.iter().map(|t| t.1)).collect();
        let stages = &plan_stages(latency, &weights)[..rows as usize];
        let ends = (1..=rows).filter(|r| stages.get(*r as usize) != Some(&stages[*r as usize - 1])).collect();
        let balanced = Self { rows, ends, of: rows };
        let n = balanced.ends.len() as u32;
        if balanced.least_rows() <= n.max(5) { balanced } else { Self { rows, ends: (1..=n).collect(), of: n } }
    }
    /// Rows of a group.
    fn size(&self, c: usize) -> u32 {
        let end = |c: usize| self.rows * self.ends[c] / self.of;
        if c == 0 { end(0) } else { end(c) - end(c - 1) }
    }
    /// The number of rows from which on no group is empty, 3 or more.
    fn least_rows(&self) -> u32 {
        let step = |c: usize| if c == 0 { self.ends[0] } else { self.ends[c] - self.ends[c - 1] };
        let least = (0..self.ends.len()).map(step).min().unwrap_or(1);
        self.of.div_ceil(least).max(3)
    }
}

#[cfg(test)]
mod tests {
    use super::Groups;

    #[test]
    fn every_group_has_a_row() {
        for rows in 5..=31 {
            for latency in 0..=32 {
                let g = Groups::of(latency, rows);
                assert!(g.ends.len() as u32 <= latency.max(1));
                assert_eq!((0..g.ends.len()).map(|c| g.size(c)).sum::<u32>(), rows);
                assert!((0..g.ends.len()).all(|c| g.size(c) > 0), "{rows} rows, {latency} clocks");
                assert!(g.least_rows() <= latency.clamp(5, rows), "{rows} rows, {latency} clocks");
            }
        }
    }
}
