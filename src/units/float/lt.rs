//! `fp_lt`: 1 if a < b. False when either is NaN; the two zeros are equal.
use super::fields::{Fields, FormatParams};
use crate::format::FloatFormat;
use crate::ir::{Builder, Module, Sig};
use std::sync::Arc;

/// Builds `fp_lt` with `latency` clocks from operand to result.
pub fn fp_lt(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new("fp_lt", file!(), "1 if a < b; 0 when either is NaN; +0 and -0 are equal");
    let f = FormatParams::declare(&b, format);
    b.clock();
    b.clock_enable();
    let a_in = b.input("a", &f.width, "float", "left side");
    let b_in = b.input("b", &f.width, "float", "right side");
    let out = b.output("result", 1, "bit", "a < b");
    b.plan(latency, &[("keys", 3), ("compare", 4)]);

    b.section(
        "keys",
        "As unsigned numbers the keys are ordered as the floats are: negatives complemented, zeros alike.",
    );
    let (fa, fb) = (Fields::of(&f, a_in, "a"), Fields::of(&f, b_in, "b"));
    let (ka, kb) = (key(&b, &f, &fa, a_in, "a"), key(&b, &f, &fb, b_in, "b"));
    let ordered = (!(fa.is_nan | fb.is_nan)).named("ordered");
    b.unused(b.cat(&[fa.is_inf, fb.is_inf]));

    b.section("compare", "");
    let less = (ka.lt(kb) & ordered).named("less");
    b.drive(out, less, Some(latency));
    b.finish(Some(latency), &super::bindings())
}

fn key<'b>(b: &'b Builder, f: &FormatParams, x: &Fields<'b>, v: Sig<'b>, name: &str) -> Sig<'b> {
    let mag_w = &f.exp + &f.man;
    let minus = (x.sign & !x.is_zero).named(&format!("{name}_minus"));
    let keep = (!x.is_zero).rep(mag_w.clone());
    let mag = (v.slice(0, mag_w.clone()) & keep) ^ minus.rep(mag_w);
    b.cat(&[!minus, mag]).named(&format!("{name}_key"))
}
