//! `fp_sqrt`: the square root of a number, rounded once.
//!
//! Restoring digit recurrence, `p` rows after the leading one for `p = MAN_W + 1`. The root of a p-bit number is never
//! half-way between two numbers (its square would have 2p + 1 bits), so one guard bit rounds to nearest. Rows are spread
//! over the stages. Specials: `docs/arithmetic.md`.
use super::fields::FormatParams;
use super::general::{Classes, Exact, Operand, Range, exponent_width, round};
use super::rows::Groups;
use crate::quantity::FLOAT;
use crate::sqrt_rows::sqrt_rows;
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// What stands before the rows where subnormals are numbers.
const HEAD: (&str, u32) = ("operand", 50);

/// Builds `fp_sqrt` with `latency` clocks from operand to result.
pub fn fp_sqrt(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new("fp_sqrt", file!(), "square root of a floating-point number, rounded once");
    let f = FormatParams::declare(&b, format);
    let e_w = exponent_width(&b, &f);
    let p = b.local("SigW", &f.man + 1, "bits of a significand, the hidden one included");
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, FLOAT, "radicand");
    let out = b.output("result", &f.width, FLOAT, "square root of a; NaN of a negative number, -0 of -0");
    // The root of the smallest subnormal number is a normal one, unless there are many fractions for few exponents.
    let normal = !format.is_gradual() || (format.man as i32) < format.bias();
    if normal && format.is_gradual() {
        b.require(&f.man + 1, f.bias());
    }
    let shift = (!normal).then_some(("shift", 35));
    let tail: Vec<(&str, u32)> = shift.into_iter().chain([("round", 30), ("select", 15)]).collect();
    let groups = Groups::planned(&b, latency, format.man + 1, format.is_gradual().then_some(HEAD), &tail);
    b.require(groups.least_rows() - 1, &f.man);

    b.section("operand", "");
    let a = Operand::of(&b, &f, a_in, "a");
    let (exp, sig) = a.normalized(&e_w);
    let (exp, sig) = (exp.named("a_exponent"), sig.named("a_one_on_top"));
    let (zero, sign) = (a.zero(), a.sign);
    let bad = (sign & !zero).named("negative");
    let (nan, zero) = match a.nan() {
        Some(nan) => (Some((nan | bad).named("give_nan")), zero),
        None => (None, (zero | bad).named("give_zero")),
    };
    let inf = a.inf();
    let twice = (exp + b.konst(f.bias(), &e_w).named("bias").doc("the exponent bias")).named("exp_sum");
    let half = if normal {
        b.unused(twice.bit(0));
        b.unused(twice.slice(&f.exp + 1, &e_w - 1 - &f.exp));
        twice.slice(1, &f.exp).named("root_exp")
    } else {
        twice.sar(b.lit(1, 1)).named("half")
    };
    // An even power of 2 and a significand in [1, 4), less the one that is the root's first digit. The bias is odd.
    let (frac, first) = (sig.slice(0, &f.man), sig.bit(&f.man - 1));
    b.unused(sig.msb());
    let odd = b.cat(&[first, !first, sig.slice(0, &f.man - 1), b.zeros(2)]);
    let even = b.cat(&[b.zeros(2), frac, b.zeros(1)]);
    let mut rem = exp.bit(0).mux(even, odd).named("rem");
    let mut root = b.cat(&[b.lit(1, 1), b.zeros(&p)]);
    for c in 0..groups.len() {
        b.section(&groups.title(c), "Rows of double, compare, subtract: one digit of the root each.");
        let before = if c == 0 { p.clone() - &p } else { groups.end(&p, c - 1) };
        (rem, root) = sqrt_rows(&b, rem, root, &(before + 1), &groups.count(&p, c), c);
    }
    let sticky: Sig<'_> = rem.any().named("sticky");
    let x = Exact { sign, exp: half, sig: root.slice(1, &p).named("sig"), guard: root.bit(0).named("guard"), sticky };
    let range = if normal { Range::Normal } else { Range::Any };
    let value = round(&b, &f, x, range, &Classes { nan, inf, zero: Some(zero) });
    b.drive(out, value);
    b.finish(&super::bindings())
}
