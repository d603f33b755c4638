//! `fp_from_int`, `fp_from_fixed`: a signed integer, or fixed-point number, to the nearest float (ties to even).
use super::fields::FormatParams;
use super::general;
use super::round::{Special, Unrounded, round_pack};
use crate::lzc::lzc;
use crate::quantity::{FLOAT, integer};
use reliefrtl_base::format::FloatFormat;
use reliefrtl_ir::{Builder, Expr, Module};
use std::sync::Arc;

/// Builds `fp_from_int`: `a` is a signed integer of `int_w` bits (parameter INT_W).
pub fn fp_from_int(format: FloatFormat, int_w: u32, latency: u32) -> Arc<Module> {
    build(format, int_w, None, latency, format.is_plain())
}

/// Builds `fp_from_fixed`: `a` is signed, INT_W bits of which FRAC_W are fraction bits.
pub fn fp_from_fixed(format: FloatFormat, int_w: u32, frac_w: u32, latency: u32) -> Arc<Module> {
    build(format, int_w, Some(frac_w), latency, format.is_plain())
}

/// As [`fp_from_fixed`], rounded by [`general::round`] whatever the choices are: what the fast rounding is proved equal to.
pub fn fp_from_fixed_in_general(format: FloatFormat, int_w: u32, frac_w: u32, latency: u32) -> Arc<Module> {
    build(format, int_w, Some(frac_w), latency, false)
}

fn build(format: FloatFormat, int_w: u32, frac_w: Option<u32>, latency: u32, fast: bool) -> Arc<Module> {
    let (name, what) = match frac_w {
        None => ("fp_from_int", "signed integer to the nearest floating-point number"),
        Some(_) => ("fp_from_fixed", "signed fixed-point number to the nearest floating-point number"),
    };
    let b = Builder::new(name, file!(), what);
    let f = FormatParams::declare(&b, format);
    let int = b.param("INT_W", int_w, "bits of the signed operand");
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
    let lz_w = (&int + 1).clog2();
    let e_w = b.local(
        "ExpSumW",
        f.exp.larger(&lz_w) + if fast { 2 } else { 3 },
        "bits of an exponent, with room for its sign",
    );
    b.clock();
    b.clock_enable();
    let unit = integer(if frac_w.is_some() { "fixed point" } else { "integer" });
    let a = b.input("a", &int, unit, "signed operand");
    let out = b.output(
        "result",
        &f.width,
        FLOAT,
        if format.is_plain() { "a, rounded to nearest even" } else { "a, rounded" },
    );
    let shift: &[(&str, u32)] = if format.is_gradual() { &[("shift", 7)] } else { &[] };
    let head = [("magnitude", 3), ("count", 4), ("normalize", 3)];
    b.plan(latency, &[&head, shift, &[("round", 4), ("select", 3)]].concat());

    b.section("magnitude", "");
    let minus = a.msb().named("minus");
    let flip = minus.rep(&int);
    let mag = ((a ^ flip) + minus.zext(&int)).named("mag");

    b.section("count", "");
    let lz = lzc(&b, "u_lzc", mag, "lz_count");

    b.section("normalize", "Zeros below make room for guard and sticky bits whatever INT_W is.");
    let norm = b.cat(&[mag.shift_left(lz), b.zeros(&f.man + 3)]).named("norm");
    let is_zero = (!norm.msb()).named("is_zero");
    let top = b
        .konst(f.bias() + &int - 1 - &frac, &e_w)
        .named("top_exp")
        .doc("exponent of an integer whose topmost bit is 1");
    let exp = (top - lz.zext(&e_w)).named("norm_exp");

    if !fast {
        let low = norm.slice(0, &int + 1).any().named("sticky");
        let (sig, guard) = (norm.slice(&int + 2, &f.man + 1).named("sig"), norm.bit(&int + 1).named("guard"));
        let x = general::Exact { sign: minus, exp, sig, guard, sticky: low };
        let zero = general::Classes { zero: Some(is_zero), ..Default::default() };
        let packed = general::round(&b, &f, x, general::Range::Any, &zero);
        b.drive(out, packed);
        return b.finish(&super::bindings());
    }
    b.section("round", "");
    let sig = norm.slice(&int + 2, &f.man + 1).named("sig");
    let x = Unrounded { sign: minus, exp, sig, guard: norm.bit(&int + 1), sticky: Some(norm.slice(0, &int + 1).any()) };
    let s = Special { nan: None, inf: None, inf_sign: None, zero: is_zero, zero_sign: None };
    let packed = round_pack(&b, &f, &x, &s);
    b.drive(out, packed);
    b.finish(&super::bindings())
}
