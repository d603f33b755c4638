//! `fp_to_int`, `fp_to_fixed`: a float to a signed integer, or fixed-point number, toward minus infinity, saturating.
use super::fields::{Fields, FormatParams};
use super::general::Operand;
use crate::quantity::{FLOAT, integer};
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Builds `fp_to_int`: the result is a signed integer of `int_w` bits (parameter INT_W).
pub fn fp_to_int(format: FloatFormat, int_w: u32, latency: u32) -> Arc<Module> {
    build(format, int_w, None, latency)
}

/// Builds `fp_to_fixed`: the result is signed, INT_W bits of which FRAC_W are fraction bits.
pub fn fp_to_fixed(format: FloatFormat, int_w: u32, frac_w: u32, latency: u32) -> Arc<Module> {
    build(format, int_w, Some(frac_w), latency)
}

fn build(format: FloatFormat, int_w: u32, frac_w: Option<u32>, latency: u32) -> Arc<Module> {
    let (name, what) = match frac_w {
        None => ("fp_to_int", "floating-point number to a signed integer, toward minus infinity, saturating"),
        Some(_) => ("fp_to_fixed", "floating-point number to signed fixed point, toward minus infinity, saturating"),
    };
    let b = Builder::new(name, file!(), what);
    if !format.is_finite() {
        b.note("Infinities saturate; NaN gives 0.");
    }
    let f = FormatParams::declare(&b, format);
    let int = b.param("INT_W", int_w, "bits of the signed result");
    b.require(2, &int);
    b.require(&int + &f.man + 3, 64);
    let frac = match frac_w {
        None => Expr::from(0),
        Some(k) => {
            let frac = b.param("FRAC_W", k, "of these, fraction bits");
            b.require(0, &frac);
            b.require(&frac, &int);
            frac
        }
    };
    // The shift runs from INT_W + bias + MAN_W down to INT_W - bias - ..., so two bits above the longest of its terms.
    let r_w = b.local(
        "RightW",
        f.exp.larger((&int + &f.man + 1).clog2()) + 3,
        "bits of a shift to the right, with room for its sign",
    );
    let x_w = b.local("WideW", &f.man + 1 + &int, "bits of an integer with a significand below it");
    b.clock();
    b.clock_enable();
    let a = b.input("a", &f.width, FLOAT, "operand");
    let unit = integer(if frac_w.is_some() { "fixed point" } else { "integer" });
    let out = b.output("result", &int, unit, "floor of a, saturated");
    b.plan(latency, &[("distance", 5), ("shift", 4), ("fine shift", 4), ("floor", 4), ("saturate", 2)]);

    b.section("distance", "The significand starts above INT_W zeros and moves right by what the exponent lacks.");
    let fa = Read::of(&b, &f, a);
    let sig = fa.sig;
    let full = b
        .konst(f.bias() + &int + &f.man - &frac, &r_w)
        .named("full")
        .doc("biased exponent of a number that need not be moved");
    let right = (full - fa.weight.zext(&r_w)).named("right");
    let least = b.konst(&f.man + 2, &r_w).named("least").doc("least shift of a number that fits");
    let far_out = right.slt(least);
    let big = match frac_w {
        None => far_out,
        // Where the range ends at or below the least normal number, a zero is as far out as that; and so is a subnormal number, which
        // lacks the top bit.
        Some(_) if f.format.is_gradual() => {
            let farther_out = right.slt(
                b.konst(&f.man + 1, &r_w)
                    .named("least_half")
                    .doc("least shift of a number that may fit: one less, of the most negative integer"),
            );
            (far_out & sig.msb()) | (farther_out & sig.bit(&f.man - 1))
        }
        Some(_) => far_out & sig.msb(),
    };
    let too_big = fa.inf.map_or(big, |inf| big | inf).named("too_big");
    let (minus, nan) = (fa.sign, fa.nan);

    b.section("shift", "By multiples of four first; what each step shifts out is lost.");
    let x = b.cat(&[sig, b.zeros(&int)]).named("unshifted");
    let coarse = b.cat(&[right.slice(2, &r_w - 2), b.zeros(2)]).named("coarse");
    let near = x.shift_right(coarse).named("coarse_shifted");
    let fine = right.slice(0, 2).named("fine");
    let lost_coarse = (x & !b.ones(&x_w).shift_left(coarse)).any().named("lost_coarse");

    b.section("fine shift", "");
    let shifted = near.shift_right(fine).named("shifted");
    let lost_fine = (near.slice(0, 3) & !b.ones(3).shift_left(fine)).any();
    let lost = (lost_coarse | lost_fine).named("lost");
    let mag = shifted.slice(0, &int).named("mag");
    b.unused(shifted.slice(&int, &f.man + 1));

    b.section("floor", "A negative number with bits shifted out lies below its truncated magnitude.");
    let flip = minus.rep(&int);
    let floor = ((mag ^ flip) + (minus & !lost).zext(&int)).named("floor");

    b.section("saturate", "");
    let limit = b.cat(&[minus, (!minus).rep(&int - 1)]).named("limit");
    let number = too_big.mux(limit, floor);
    let result = nan.map_or(number, |nan| nan.mux(b.zeros(&int), number)).named("result_value");
    b.drive(out, result);
    b.finish(&super::bindings())
}

/// The operand, as the format's choices read it.
struct Read<'b> {
    sign: Sig<'b>,
    /// Exponent field of the significand's weight.
    weight: Sig<'b>,
    sig: Sig<'b>,
    inf: Option<Sig<'b>>,
    nan: Option<Sig<'b>>,
}

impl<'b> Read<'b> {
    fn of(b: &'b Builder, f: &FormatParams, a: Sig<'b>) -> Self {
        if f.format.is_finite() || f.format.is_gradual() {
            let a = Operand::of(b, f, a, "a");
            return Self { sign: a.sign, weight: a.weight(), sig: a.sig(), inf: a.inf(), nan: a.nan() };
        }
        let a = Fields::of(f, a, "a");
        let sig = a.significand(b, "a_sig");
        Self { sign: a.sign, weight: a.exp, sig, inf: Some(a.is_inf), nan: Some(a.is_nan) }
    }
}
