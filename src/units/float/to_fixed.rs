//! `fp_to_int`, `fp_to_fixed`: a float to a signed integer, or fixed-point number, toward minus infinity, saturating.
use super::fields::{Fields, FormatParams};
use crate::format::FloatFormat;
use crate::ir::{Builder, Expr, Module};
use std::sync::Arc;

/// Builds `fp_to_int`: the result is a signed integer of `int_w` bits (parameter INT_W).
pub fn fp_to_int(format: FloatFormat, int_w: u32, latency: u32) -> Arc<Module> {
    build(format, int_w, None, latency)
}

/// Builds `fp_to_fixed`: the result is signed, INT_W bits of which FRAC_W stand behind the point.
pub fn fp_to_fixed(format: FloatFormat, int_w: u32, frac_w: u32, latency: u32) -> Arc<Module> {
    build(format, int_w, Some(frac_w), latency)
}

fn build(format: FloatFormat, int_w: u32, frac_w: Option<u32>, latency: u32) -> Arc<Module> {
    let (name, what) = match frac_w {
        None => ("fp_to_int", "floating-point number to a signed integer, toward minus infinity, saturating"),
        Some(_) => ("fp_to_fixed", "floating-point number to signed fixed point, toward minus infinity, saturating"),
    };
    let b = Builder::new(name, file!(), what);
    b.note("Infinities saturate; NaN gives 0.");
    let f = FormatParams::declare(&b, format);
    let int = b.param("INT_W", int_w, "bits of the signed result");
    b.require(2, &int);
    b.require(&int + &f.man + 3, 64);
    let frac = match frac_w {
        None => Expr::from(0),
        Some(k) => {
            let frac = b.param("FRAC_W", k, "of these, bits behind the point");
            b.require(0, &frac);
            b.require(&frac, &int);
            frac
        }
    };
    // The shift runs from INT_W + bias + MAN_W down to INT_W - bias - ..., so two bits above the longest of its terms.
    let r_w = b.local("RightW", f.exp.larger((&int + &f.man + 1).clog2()) + 3);
    let x_w = b.local("WideW", &f.man + 1 + &int);
    b.clock();
    b.clock_enable();
    let a = b.input("a", &f.width, "float", "operand");
    let unit = if frac_w.is_some() { "fixed point" } else { "integer" };
    let out = b.output("result", &int, unit, "floor of a, saturated");
    b.plan(latency, &[("distance", 3), ("shift", 6), ("floor", 4)]);

    b.section("distance", "The significand starts above INT_W zeros and moves right by what the exponent lacks.");
    let fa = Fields::of(&f, a, "a");
    let sig = fa.significand(&b, "a_sig");
    let full = b.konst(f.bias() + &int + &f.man - &frac, &r_w).named("full");
    let right = (full - fa.exp.zext(&r_w)).named("right");
    let least = b.konst(&f.man + 2, &r_w).named("least");
    let too_big = (right.slt(least) | fa.is_inf).named("too_big");
    let (minus, nan) = (fa.sign, fa.is_nan);

    b.section("shift", "");
    let x = b.cat(&[sig, b.zeros(&int)]).named("unshifted");
    let shifted = x.shift_right(right).named("shifted");
    let lost = (x & !b.ones(&x_w).shift_left(right)).any().named("lost");
    let mag = shifted.slice(0, &int).named("mag");
    b.unused(shifted.slice(&int, &f.man + 1));

    b.section("floor", "A negative number with bits shifted out lies below its truncated magnitude.");
    let flip = minus.rep(&int);
    let floor = ((mag ^ flip) + (minus & !lost).zext(&int)).named("floor");
    let limit = b.cat(&[minus, (!minus).rep(&int - 1)]).named("limit");
    let result = nan.mux(b.zeros(&int), too_big.mux(limit, floor)).named("result_value");
    b.drive(out, result, Some(latency));
    b.finish(Some(latency), &super::bindings())
}
