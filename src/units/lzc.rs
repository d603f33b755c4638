//! `lzc`: leading zeros of a word; the word's width when it is zero.
use crate::quantity::BITS;
use reliefrtl_ir::{Builder, Module, Prim, Sig};
use std::sync::Arc;

/// Builds the leading-zero counter (parameter W), combinational.
pub fn lzc_module(width: u32) -> Arc<Module> {
    let b = Builder::new("lzc", file!(), "number of leading zeros of a word; W when the word is zero");
    let w = b.param("W", width, "bits of the word");
    b.require(1, &w);
    b.require(&w, 64);
    let count_w = b.local("CountW", (&w + 1).clog2(), "bits of a count of zeros, 0 to W");
    b.input("bits", &w, BITS, "the word");
    b.output("count", &count_w, BITS, "zeros above the topmost 1");
    b.finish_primitive(Prim::Lzc)
}

/// Instantiates an `lzc` on `word`; the count is named `name` and has clog2(width + 1) bits.
pub fn lzc<'b>(b: &'b Builder, instance: &str, word: Sig<'b>, name: &str) -> Sig<'b> {
    b.inst(&lzc_module(8), instance, &[("W", word.width())], &[("bits", word)]).only().named(name)
}
